#include "exercises/01_traversal/face_across.h"
#include <bits/stdc++.h>
#include "my_utils.h"
using namespace std;

optional<int> face_across(const HalfEdgeTable& he, int i) {
    return valid(he[he[i].opp].fi);
}

// Removes a face that is both first and last, also from an empty list.
// Hint: You forgot vertices that have no face at all.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[he[i].opp].next;
    } while (i != start);
    if (faces.front() == faces.back() && faces.size() > 1) faces.pop_back();
    return faces;
}

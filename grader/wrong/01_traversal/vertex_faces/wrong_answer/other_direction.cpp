// The right faces, but the other way round.
// Hint: Your answers are the right ones, but the other way round.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.insert(faces.begin(), fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}

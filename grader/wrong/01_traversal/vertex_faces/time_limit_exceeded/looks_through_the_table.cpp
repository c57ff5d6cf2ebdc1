// Looks for the half-edges of the vertex in the whole table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    std::vector<int> faces;
    for (int k = 0; k < he.size(); k++) {
        int fi = he[k].fi;
        if (he[k].vi == he[i].vi && fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
    }
    return faces;
}

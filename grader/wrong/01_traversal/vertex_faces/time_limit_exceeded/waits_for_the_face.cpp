// Ends when the first face comes again; at a gap it never does.
// Hint: You wait for a face that your walk need not meet.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int first = he[i].fi;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[i].opp;
    } while (he[i].fi != first || faces.size() < 2);
    return faces;
}

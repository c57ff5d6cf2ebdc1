// Keeps its answer for each half-edge, also for another mesh.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/01_traversal/face_across.h"

#include <map>

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    static std::map<int, std::optional<int>> known;
    if (known.count(i) > 0) return known[i];
    int fi = he[he[i].opp].fi;
    if (fi != -1) known[i] = fi;
    return fi == -1 ? std::nullopt : std::optional<int>(fi);
}

#include "exercises/01_traversal/face_sides.h"

#include <vector>

int face_sides(const HalfEdgeTable& he, int i) {
    std::vector<int> visited(25000000000);   // big enough for any mesh
    int n = 0;
    while (he[i].fi != -1 && !visited[i]) {
        visited[i] = 1;
        i = he[i].next;
        n++;
    }
    return n;
}

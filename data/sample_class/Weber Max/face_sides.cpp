#include "exercises/01_traversal/face_sides.h"

#include <iostream>

int face_sides(const HalfEdgeTable& he, int i) {
    std::cout << "--- face_sides, i = " << i << std::endl;
    // mal sehen, was in der Tabelle steht
    for (int k = 0; k < 300; k++)
        std::cerr << "DEBUG " << k << "\n";
    if (he[i].fi == -1) return 0;
    int start = i, n = 0;
    do {
        std::cout << "  i = " << i << " vi = " << he[i].vi << std::endl;
        n++;
        i = he[i].next;
    } while (i != start);
    std::cout << "fertig: " << n << std::endl;
    return n;
}

#include "exercises/00_table/prev.h"

#include <iostream>

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    int next = he[j].next;
    while (next != -1) {
        std::cerr << "looking for the one before, j = " << j << std::endl;
        if (next == i) return j;
        // j = next; next = he[j].next;      <- why did I comment this out?
    }
    return j;
}

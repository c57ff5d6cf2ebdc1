#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    for (int j = 0; j < he.size(); ++j) {
        if (he[j].next == i) return j;
    }
    return -1;
}

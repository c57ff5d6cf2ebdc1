#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    // so lange, bis j vor i liegt
    while (he[j].next != i) {
        j = he[j].opp;
        j = he[j].opp;
    }
    return j;
}

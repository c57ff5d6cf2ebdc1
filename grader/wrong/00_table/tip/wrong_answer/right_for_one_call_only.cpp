// A static variable keeps the first answer for all later calls.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    static const int answer = he[he[i].next].vi;
    return answer;
}

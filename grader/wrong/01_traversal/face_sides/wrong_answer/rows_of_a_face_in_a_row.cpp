// Believes that the rows of a face lie one after the other in the table.
// Hint: You take rows that stand together for those of one face; they may
// stand anywhere.
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return 0;
    int first = i;
    while (first > 0 && he[first - 1].fi == fi) first--;
    int last = i;
    while (last + 1 < he.size() && he[last + 1].fi == fi) last++;
    return last - first + 1;
}

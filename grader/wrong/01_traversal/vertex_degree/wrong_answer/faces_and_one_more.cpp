// Counts the faces, and one more at the border: wrong with several gaps.
// Hint: You count faces, and guess the number of gaps between them.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int faces = 0;
    bool border = false;
    do {
        if (he[i].fi == -1)
            border = true;
        else
            faces++;
        i = he[he[i].opp].next;
    } while (i != start);
    return border ? faces + 1 : faces;
}

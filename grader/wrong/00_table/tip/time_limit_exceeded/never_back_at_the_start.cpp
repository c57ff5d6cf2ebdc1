// Goes to and fro between i and its opposite and waits for a third one.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    int j = i;
    do {
        j = he[he[j].opp].opp;
    } while (j == i);
    return he[j].vi;
}

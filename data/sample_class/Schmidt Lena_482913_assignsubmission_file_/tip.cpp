#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    bool gefunden = false;
    int j = he[i].opp;
    while (!gefunden) {
        if (j == -2) gefunden = true;
    }
    return he[j].vi;
}

// Takes loose edges off, but leaves their ends in.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    int edges = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1 || he[he[i].opp].fi != -1) ++edges;
    return n.vertices - edges / 2 + n.faces;
}

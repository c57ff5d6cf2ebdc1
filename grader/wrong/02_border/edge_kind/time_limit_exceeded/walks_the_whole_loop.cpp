// Right, but walks all of the loop on either side: long on a border.
// Hint: Your answers are right, but you read far more of the table than one
// edge.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    EdgeKind kind = EdgeKind::dangling;
    int j = he[i].opp;
    for (int k = he[i].next; k != i; k = he[k].next)
        if (he[k].fi != he[i].fi) return kind;
    for (int k = he[j].next; k != j; k = he[k].next)
        if (he[k].fi != he[j].fi) return kind;
    if (he[i].fi != -1 || he[j].fi != -1) kind = EdgeKind::border;
    if (he[i].fi != -1 && he[j].fi != -1) kind = EdgeKind::interior;
    return kind;
}

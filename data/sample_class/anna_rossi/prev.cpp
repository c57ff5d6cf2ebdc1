#include "exercises/00_table/prev.h"

// giro la faccia finché la prossima non è di nuovo i
int prev(const HalfEdgeTable& he, int i)
{
    int j = i;
    while (he[j].next != i)
        j = he[j].next;
    return j;
}

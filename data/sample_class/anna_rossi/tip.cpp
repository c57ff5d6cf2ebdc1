#include "exercises/00_table/tip.h"

// dove arriva i: l'opposta parte proprio da lì
int tip(const HalfEdgeTable& he, int i)
{
    return he[he[i].opp].vi;
}

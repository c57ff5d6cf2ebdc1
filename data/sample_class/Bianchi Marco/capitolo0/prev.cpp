#include "exercises/00_table/prev.h"

// Turning round the vertex instead of walking along the face: one of the
// half-edges that arrive at the vertex of i must be the one before i.
int prev(const HalfEdgeTable& he, int i)
{
	int arriving = he[i].opp;
	if (he[arriving].next == i) return arriving;
	for (;;) {
		int leaving = he[arriving].next;
		arriving = he[leaving].opp;
		if (he[arriving].next == i) return arriving;
	}
}

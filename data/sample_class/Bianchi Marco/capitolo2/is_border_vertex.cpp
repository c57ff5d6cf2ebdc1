#include "exercises/02_border/is_border_vertex.h"

namespace {
bool search(const HalfEdgeTable& he, int i, int start)
{
	if (he[i].fi == -1) return true;
	int k = he[he[i].opp].next;
	return k != start && search(he, k, start);
}
}

bool is_border_vertex(const HalfEdgeTable& he, int i) { return search(he, i, i); }

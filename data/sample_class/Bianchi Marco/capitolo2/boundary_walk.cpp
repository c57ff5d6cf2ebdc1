#include "exercises/02_border/boundary_walk.h"

namespace {
// -1 when no side of the edge is on the border
int borderSide(const HalfEdgeTable& he, int i)
{
	if (he[i].fi == -1) return i;
	if (he[he[i].opp].fi == -1) return he[i].opp;
	return -1;
}
}

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i)
{
	int start = borderSide(he, i);
	std::vector<int> walk;
	if (start == -1) return walk;
	for (int k = he[start].next; k != start; k = he[k].next) walk.push_back(k);
	walk.push_back(start);
	return walk;
}

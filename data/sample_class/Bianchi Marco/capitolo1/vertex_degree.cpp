#include "exercises/01_traversal/vertex_degree.h"

namespace {
// next half-edge that leaves the same vertex
int rotate(const HalfEdgeTable& he, int i) { return he[he[i].opp].next; }

int countFrom(const HalfEdgeTable& he, int i, int stop)
{
	return i == stop ? 1 : 1 + countFrom(he, rotate(he, i), stop);
}
}

int vertex_degree(const HalfEdgeTable& he, int i)
{
	return countFrom(he, rotate(he, i), i);
}

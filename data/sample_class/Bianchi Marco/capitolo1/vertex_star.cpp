#include "exercises/01_traversal/vertex_star.h"

namespace {
int rotate(const HalfEdgeTable& he, int i) { return he[he[i].opp].next; }
int otherEnd(const HalfEdgeTable& he, int i) { return he[he[i].next].vi; }
}

std::vector<int> vertex_star(const HalfEdgeTable& he, int i)
{
	std::vector<int> ends{otherEnd(he, i)};
	for (int k = rotate(he, i); k != i; k = rotate(he, k))
		ends.push_back(otherEnd(he, k));
	return ends;
}

#include "exercises/02_border/with_dangling_edge.h"

#include <string>

// first the way back (row n), then the way out (row n + 1)
HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex)
{
	const int n = he.size();
	if (!(0 <= border && border < n))
		throw std::invalid_argument("no such half-edge: " + std::to_string(border));
	if (he[border].fi != -1)
		throw std::invalid_argument("not on a border: " + std::to_string(border));

	HalfEdge back, out;
	back.vi = new_vertex;
	back.next = he[border].next;
	back.opp = n + 1;
	out.vi = he[he[border].opp].vi;
	out.next = n;
	out.opp = n;

	HalfEdgeTable copy(he);
	copy.push_back(back);
	copy.push_back(out);
	copy[border].next = n + 1;
	return copy;
}

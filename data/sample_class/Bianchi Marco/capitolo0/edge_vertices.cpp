#include "exercises/00_table/edge_vertices.h"

static int startOf(const HalfEdgeTable& he, int i) { return he[i].vi; }
static int endOf(const HalfEdgeTable& he, int i) { return startOf(he, he[i].opp); }

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i)
{
	return {{startOf(he, i), endOf(he, i)}};
}

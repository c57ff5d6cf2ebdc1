#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i)
{
	const HalfEdge& across = he[he[i].opp];
	if (across.fi < 0) return {};
	return across.fi;
}

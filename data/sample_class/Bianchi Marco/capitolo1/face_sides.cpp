#include "exercises/01_traversal/face_sides.h"

namespace {
int rest(const HalfEdgeTable& he, int i, int start)
{
	if (i == start) return 0;
	return 1 + rest(he, he[i].next, start);
}
}

int face_sides(const HalfEdgeTable& he, int i)
{
	return he[i].fi == -1 ? 0 : 1 + rest(he, he[i].next, i);
}

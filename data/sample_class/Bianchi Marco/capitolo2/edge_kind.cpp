#include "exercises/02_border/edge_kind.h"

namespace {
bool hasFace(const HalfEdgeTable& he, int i) { return he[i].fi != -1; }
}

EdgeKind edge_kind(const HalfEdgeTable& he, int i)
{
	bool here = hasFace(he, i);
	bool there = hasFace(he, he[i].opp);
	if (here != there) return EdgeKind::border;
	return here ? EdgeKind::interior : EdgeKind::dangling;
}

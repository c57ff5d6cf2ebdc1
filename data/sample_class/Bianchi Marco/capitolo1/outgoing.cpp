#include "exercises/01_traversal/outgoing.h"

namespace {
int rotate(const HalfEdgeTable& he, int i) { return he[he[i].opp].next; }
}

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors, int v)
{
	int first = anchors.vertex.at(v);
	if (first == -1) return {};
	std::vector<int> list = {first};
	while (rotate(he, list.back()) != first)
		list.push_back(rotate(he, list.back()));
	return list;
}

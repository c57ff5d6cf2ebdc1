#include "exercises/01_traversal/face_vertices.h"

namespace {
void collect(const HalfEdgeTable& he, int i, int start, std::vector<int>& out)
{
	out.push_back(he[i].vi);
	int n = he[i].next;
	if (n != start) collect(he, n, start, out);
}
}

std::vector<int> face_vertices(const HalfEdgeTable& he, int i)
{
	std::vector<int> out;
	if (he[i].fi != -1) collect(he, i, i, out);
	return out;
}

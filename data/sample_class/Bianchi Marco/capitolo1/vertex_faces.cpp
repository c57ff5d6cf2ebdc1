#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

namespace {
void addOnce(std::vector<int>& list, int x)
{
	if (x >= 0 && std::count(list.begin(), list.end(), x) == 0) list.push_back(x);
}

void turn(const HalfEdgeTable& he, int i, int start, std::vector<int>& list)
{
	addOnce(list, he[i].fi);
	int k = he[he[i].opp].next;
	if (k != start) turn(he, k, start, list);
}
}

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i)
{
	std::vector<int> list;
	turn(he, i, i, list);
	return list;
}

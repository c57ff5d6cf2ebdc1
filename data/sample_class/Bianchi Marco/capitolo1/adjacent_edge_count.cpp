#include "exercises/01_traversal/adjacent_edge_count.h"

#include <algorithm>

namespace {
std::vector<int> sides(const HalfEdgeTable& he, int i)
{
	std::vector<int> all{i};
	while (he[all.back()].next != i) all.push_back(he[all.back()].next);
	return all;
}
}

int adjacent_edge_count(const HalfEdgeTable& he, int i)
{
	if (he[i].fi == -1) return 0;
	std::vector<int> all = sides(he, i);
	return static_cast<int>(std::count_if(all.begin(), all.end(), [&](int k) {
		return he[he[k].opp].fi != -1;
	}));
}

#include "exercises/02_border/boundary_walk_bug.h"

// rewritten as a for loop, there is only one i now
std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i)
{
	if (he[i].fi != -1) i = he[i].opp;
	if (he[i].fi != -1) return {};
	std::vector<int> walk{i};
	for (int k = he[i].next; k != i; k = he[k].next) walk.push_back(k);
	return walk;
}

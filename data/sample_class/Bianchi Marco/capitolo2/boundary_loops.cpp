#include "exercises/02_border/boundary_loops.h"

namespace {
std::vector<int> loopFrom(const HalfEdgeTable& he, int start, std::vector<char>& done)
{
	std::vector<int> loop;
	for (int i = start; !done[i]; i = he[i].next) {
		done[i] = 1;
		loop.push_back(i);
	}
	return loop;
}
}

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he)
{
	std::vector<char> done(he.size(), 0);
	std::vector<std::vector<int>> all;
	for (int i = he.size() - 1; i >= 0; --i)
		if (he[i].fi == -1 && !done[i]) all.push_back(loopFrom(he, i, done));
	return all;
}

#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

// all neighbours with repetitions, then sort + unique
std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i)
{
	const int own = he[i].fi;
	if (own == -1) return {};
	std::vector<int> n;
	int k = i;
	do {
		int f = he[he[k].opp].fi;
		if (f != own && f != -1) n.push_back(f);
		k = he[k].next;
	} while (k != i);
	std::sort(n.begin(), n.end());
	n.erase(std::unique(n.begin(), n.end()), n.end());
	return n;
}

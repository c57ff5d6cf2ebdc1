#include "exercises/01_traversal/valences.h"

// every edge is seen from both sides, so each half-edge counts at its start
std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count)
{
	std::map<int, int> edgesAt;
	for (int v = 0; v < vertex_count; ++v) edgesAt[v] = 0;
	for (int i = 0; i < he.size(); ++i) edgesAt[he[i].vi] += 1;

	std::map<int, int> howMany;
	for (auto [vertex, edges] : edgesAt) howMany[edges] += 1;
	return howMany;
}

#include "exercises/01_traversal/face_across.h"

// first try, wrong: forgets the border
std::optional<int> face_across(const HalfEdgeTable& he, int i)
{
	return he[he[i].opp].fi;
}

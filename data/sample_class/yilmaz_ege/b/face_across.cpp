#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i)
{
    std::optional<int> altra;
    if (he[he[i].opp].fi >= 0) altra = he[he[i].opp].fi;
    return altra;
}

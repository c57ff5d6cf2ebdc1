// wrong_answer 0: THREATS 29, an enumerator that is not there
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) { return static_cast<EdgeKind>(3 + i + he[i].fi * 0); }

// Loops up to and with he.size().
// Hint: You read a row past the end of the table.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i <= he.size(); ++i)
        if (he[i].fi == -1) return false;
    return true;
}

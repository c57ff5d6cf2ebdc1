#include "exercises/04_topology/incidences.h"

Incidences incidences(const HalfEdgeTable& he) {
    // A half-edge along a face is a side of it, and leaves a corner of it.
    int along_a_face = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1) ++along_a_face;

    int edges = he.size() / 2;
    return {along_a_face, along_a_face, 2 * edges};
}

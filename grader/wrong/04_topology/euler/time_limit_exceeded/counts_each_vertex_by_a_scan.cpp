// Looks for each half-edge whether an earlier one leaves the same vertex:
// quadratic.
// Hint: Your answers are right, but you read the same rows of the table again
// and again.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    int vertices = 0;
    for (int i = 0; i < he.size(); ++i) {
        bool first = true;
        for (int k = 0; k < i; ++k)
            if (he[k].vi == he[i].vi) first = false;
        if (first) ++vertices;
    }
    return vertices - n.edges + n.faces;
}

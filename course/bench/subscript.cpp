// The same walk by he[...] and by a raw pointer. Compiled once for each
// compiler and level (see CMakeLists.txt).
#include "course/bench/subscript.h"

namespace {

template <class Table>
long star(const Table& he, int start) {
    long sum = 0;
    int i = start;
    do {
        const int j = he[i].opp;
        sum += he[j].vi;
        i = he[j].next;
    } while (i != start);
    return sum;
}

long checked(const HalfEdgeTable& he, const int* leaving, int vertices) {
    long sum = 0;
    for (int v = 0; v < vertices; ++v) {
        he.begin_call(he.default_budget());
        if (leaving[v] != -1) sum += star(he, leaving[v]);
    }
    return sum;
}

long raw(const HalfEdge* he, const int* leaving, int vertices) {
    long sum = 0;
    for (int v = 0; v < vertices; ++v)
        if (leaving[v] != -1) sum += star(he, leaving[v]);
    return sum;
}

const bool added = [] {
    bench::subscripts().push_back({BENCH_COMPILED, raw, checked});
    return true;
}();

}  // namespace

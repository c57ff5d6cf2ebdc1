// The same walk by he[...] and by a raw pointer. Compiled once for each
// compiler, level and build of the table (see CMakeLists.txt).
#include "course/bench/subscript.h"

#include "course/halfedge/half_edge_table.h"

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

template <class Table>
long all_stars(const Table& he, const std::vector<int>& leaving) {
    long sum = 0;
    const int* const starts = leaving.data();
    const int vertices = static_cast<int>(leaving.size());
    for (int v = 0; v < vertices; ++v)
        if (starts[v] != -1) sum += star(he, starts[v]);
    return sum;
}

std::vector<HalfEdge> half_edges(const bench::Rows& rows) {
    std::vector<HalfEdge> result;
    result.reserve(rows.size());
    for (const auto& [vi, fi, next, opp] : rows)
        result.push_back({vi, fi, next, opp});
    return result;
}

std::function<double()> by_table(const bench::Rows& rows,
                                 const std::vector<int>& leaving) {
    return [he = HalfEdgeTable(half_edges(rows)), leaving] {
        he.begin_call(he.default_budget());
#if COURSE_TABLE == 2
        he.start_trace();
#endif
        const long sum = all_stars(he, leaving);
#if COURSE_TABLE == 2
        he.stop_trace();
#endif
        return static_cast<double>(sum);
    };
}

std::function<double()> by_pointer(const bench::Rows& rows,
                                   const std::vector<int>& leaving) {
    return [he = half_edges(rows), leaving] {
        return static_cast<double>(all_stars(he.data(), leaving));
    };
}

const bool added = [] {
    bench::subscripts().push_back(
        {BENCH_COMPILED, COURSE_TABLE == 2, by_table, by_pointer});
    return true;
}();

}  // namespace

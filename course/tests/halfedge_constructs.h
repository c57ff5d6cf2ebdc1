// What students may write round he[i]: each construct must do the same in the
// three builds of the table. Included by one test per build, which sets
// COURSE_TABLE first; what is expected is the same text for all of them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <queue>
#include <ranges>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/runner/catch2.h"

// The slide's table: rows of vi, fi, next, opp.
inline HalfEdgeTable slide_table() {
    return {{2, -1, 2, 1},  {0, 0, 3, 0},   {0, -1, 6, 5},  {2, 0, 5, 4},
            {1, 1, 11, 3},  {1, 0, 1, 2},   {1, -1, 7, 12}, {4, -1, 10, 15},
            {5, 2, 14, 11}, {3, 2, 8, 10},  {5, -1, 13, 9}, {2, 1, 15, 8},
            {4, 1, 4, 6},   {3, -1, 0, 14}, {2, 2, 9, 13},  {5, 1, 12, 7}};
}

inline int plus_one(int value) {
    return value + 1;
}
inline int by_const_reference(const int& value) {
    return value + 1;
}
inline void set_to_three(int& value) {
    value = 3;
}
inline HalfEdge moved_to(HalfEdge row, int vertex) {
    row.vi = vertex;
    return row;
}
inline int sides_from(const HalfEdgeTable& he, int i, int start) {
    return he[i].next == start ? 1 : 1 + sides_from(he, he[i].next, start);
}
template <class T>
T doubled(T value) {
    return value + value;
}
#define AFTER(k) he[k].next
#define ACROSS(k) (he[k].opp)

using Run = int (*)(HalfEdgeTable& he, int i);

/// A construct, and what running it from half-edge 4 gives: the result, and
/// each cell of the table that has changed.
struct Construct {
    const char* name;
    Run run;
    const char* outcome;
};

// clang-format off
#pragma GCC diagnostic push  // students' files are compiled without these two:
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#define RUN []([[maybe_unused]] HalfEdgeTable& he, [[maybe_unused]] int i) -> int
inline const std::vector<Construct> constructs = {
// ---- reading a cell
{"a cell into an int", RUN { int x = he[i].next; return x; }, "11"},
{"a cell into an auto, then as index", RUN { auto n = he[i].next; return he[n].vi; }, "2"},
{"a cell into an auto that changes", RUN { auto n = he[i].next; n = 7; return n + he[i].next; }, "18"},
{"a cell into a const auto", RUN { const auto j = he[i].opp; return he[j].vi; }, "2"},
{"a cell into a double", RUN { double x = he[i].next / 2.0; return static_cast<int>(x * 4); }, "22"},
{"a cell into a bool", RUN { bool on_border = he[i].fi == -1; return on_border; }, "0"},
{"a cell into a long", RUN { long x = he[i].next; return static_cast<int>(x * 2); }, "22"},
{"a cell in braces", RUN { int x{he[i].next}; return x; }, "11"},
{"nested subscripts", RUN { return he[he[he[i].opp].next].vi; }, "1"},
{"a subscript over several lines", RUN { return he
    [ he[i]
          .next ]
        .vi; }, "2"},
{"a cell behind a pointer to member", RUN { int HalfEdge::* field = &HalfEdge::next; return he[i].*field; }, "11"},
{"decltype of a cell", RUN { decltype(HalfEdge::next) x = he[i].next; return x; }, "11"},
{"a macro, nested", RUN { return AFTER(AFTER(i)); }, "15"},
{"a macro in parentheses", RUN { return he[ACROSS(i)].vi; }, "2"},
// ---- what an index may be
{"a literal", RUN { return he[12].opp; }, "6"},
{"an expression", RUN { return he[2 * i + 1].vi; }, "3"},
{"a conditional expression", RUN { return he[i > 2 ? he[i].next : i].vi; }, "2"},
{"an unsigned", RUN { unsigned k = 3; return he[k].vi; }, "2"},
{"a size_t", RUN { std::size_t k = 3; return he[k].vi; }, "2"},
{"a long", RUN { long k = 3; return he[k].vi; }, "2"},
{"a short", RUN { short k = 3; return he[k].vi; }, "2"},
{"a char", RUN { char k = 3; return he[k].vi; }, "2"},
{"an enumerator", RUN { enum Corner { first = 3 }; return he[first].vi; }, "2"},
{"a bool", RUN { return he[i > 2].vi; }, "0"},
{"a call", RUN { return he[plus_one(i)].vi; }, "1"},
{"an increment in the index", RUN { int k = i; int first = he[k++].vi; return 10 * first + he[k].vi; }, "11"},
{"an assignment in the index", RUN { int k; int v = he[k = i].vi; return v + k; }, "5"},
{"an element of a vector", RUN { std::vector<int> list{1, 7}; return he[list[1]].vi; }, "4"},
{"an optional's value", RUN { std::optional<int> k = 7; return he[*k].vi + he[k.value()].vi; }, "8"},
{"a structured binding", RUN { const auto [a, b] = std::pair(3, 7); return he[a].vi + he[b].vi; }, "6"},
// ---- comparing and computing
{"comparisons", RUN { return (he[i].fi == -1) + 2 * (he[i].vi != he[i].fi) + 4 * (he[i].vi < he[i].next) + 8 * (he[i].vi <= 1); }, "12"},
{"a cell as a condition", RUN { if (he[i].fi) return 1; return 2; }, "1"},
{"a negated cell", RUN { return !he[1].vi + 2 * !he[i].vi; }, "1"},
{"and, or", RUN { return (he[i].fi != -1 && he[he[i].opp].fi != -1) + 2 * (he[i].fi == -1 || he[0].fi == -1); }, "3"},
{"a conditional with a literal", RUN { return i >= 0 ? he[i].next : -1; }, "11"},
{"a conditional of two cells", RUN { return i > 9 ? he[i].next : he[i].opp; }, "3"},
{"arithmetic with signs", RUN { return -he[i].vi + +he[i].next % 4 * 2; }, "5"},
{"a three-way comparison", RUN { return (he[i].vi <=> he[i].next) < 0; }, "1"},
{"switch over a cell", RUN { switch (he[i].fi) { case -1: return 5; case 1: return 6; default: return 7; } }, "6"},
{"while over a cell", RUN { int n = 0; while (he[i].fi != -1 && n < 9) { i = he[he[i].opp].next; n++; } return 10 * n + i; }, "26"},
{"for with a cell in its head", RUN { int n = 1; for (int k = he[i].next; k != i; k = he[k].next) n++; return n; }, "4"},
{"do while, as on the slides", RUN { int n = 0; int start = i; do { n++; i = he[i].next; } while (i != start); return n; }, "4"},
{"if with an initialiser", RUN { if (int j = he[i].opp; j > i) return j; else return -j; }, "-3"},
// ---- rows
{"a copy of a row", RUN { HalfEdge h = he[i]; he[i].next = 9; return h.next; }, "11 he[4].next=9"},
{"an auto copy of a row", RUN { auto h = he[i]; h.next = 9; return he[i].next + h.next; }, "20"},
{"a const reference to a row sees a change", RUN { const auto& h = he[i]; he[i].next = 9; return h.next; }, "9 he[4].next=9"},
{"a reference to a row", RUN { HalfEdge& h = he[i]; h.opp = 5; h.fi += 2; return h.opp + h.fi; }, "8 he[4].fi=3 he[4].opp=5"},
{"a reference that is written later", RUN { HalfEdge& h = he[i]; int sum = 0; for (int k = 0; k < 12; ++k) sum += he[k].vi; h.next = sum; return he[i].next; }, "26 he[4].next=26"},
{"a cast of a const row", RUN { const HalfEdgeTable& same = he; const_cast<HalfEdge&>(same[i]).next = 9; return same[i].next; }, "9 he[4].next=9"},
{"an auto reference to a row", RUN { auto& h = he[i]; h.vi = h.next; return h.vi; }, "11 he[4].vi=11"},
{"a pointer to a row", RUN { HalfEdge* h = &he[i]; h->next = 2; return (*h).next; }, "2 he[4].next=2"},
{"a row taken apart", RUN { auto [v, f, n, o] = he[i]; n = 0; return v + f + n + o; }, "5"},
{"a row taken apart by reference", RUN { auto& [v, f, n, o] = he[i]; n = v + f + o; return n; }, "5 he[4].next=5"},
{"a row taken apart by const reference", RUN { const auto& [v, f, n, o] = he[i]; return v + f + n + o; }, "16"},
{"a row in braces assigned", RUN { he[i] = {1, 2, 3, 4}; return he[i].opp; }, "4 he[4].fi=2 he[4].next=3 he[4].opp=4"},
{"a row with named fields", RUN { HalfEdge h{.vi = 1, .fi = 2}; return h.vi + h.fi + h.next + h.opp; }, "1"},
{"a row set field by field", RUN { HalfEdge h; h.vi = 3; h.next = he[i].next; return h.vi + h.next + h.fi; }, "13"},
{"a row assigned to a row", RUN { he[i] = he[0]; return he[i].fi; }, "-1 he[4].vi=2 he[4].fi=-1 he[4].next=2 he[4].opp=1"},
{"a row passed by value", RUN { HalfEdge h = moved_to(he[i], 5); return 10 * h.vi + he[i].vi; }, "51"},
{"rows compared", RUN { HalfEdge h = he[i]; return (h == he[i]) + 2 * (h != he[0]); }, "3"},
{"rows swapped", RUN { std::swap(he[0], he[1]); return he[0].fi; }, "0 he[0].vi=0 he[0].fi=0 he[0].next=3 he[0].opp=0 he[1].vi=2 he[1].fi=-1 he[1].next=2 he[1].opp=1"},
{"rows copied into a vector", RUN { std::vector<HalfEdge> copy; for (int k = 0; k < he.size(); ++k) copy.push_back(he[k]); return copy[4].next; }, "11"},
// ---- writing cells
{"a cell assigned", RUN { int j = 2; he[i].opp = j; return he[i].opp; }, "2 he[4].opp=2"},
{"a cell from a cell", RUN { he[i].opp = he[i + 1].opp; return he[i].opp; }, "2 he[4].opp=2"},
{"a cell from another field", RUN { he[i].next = he[he[i].opp].opp; return he[i].next; }, "4 he[4].next=4"},
{"a chain of assignments", RUN { he[i].vi = he[i + 1].vi = 3; return he[i].vi + he[i + 1].vi; }, "6 he[4].vi=3 he[5].vi=3"},
{"increments", RUN { he[i].vi++; ++he[i].vi; --he[i].opp; return he[i].fi--; }, "1 he[4].vi=3 he[4].fi=0 he[4].opp=2"},
{"compound assignments", RUN { he[i].vi += 2; he[i].next -= 1; he[i].opp *= he[i].vi; return he[i].opp; }, "9 he[4].vi=3 he[4].next=10 he[4].opp=9"},
{"a reference to a cell", RUN { int& r = he[i].next; r = 4; return he[i].next; }, "4 he[4].next=4"},
{"a const reference to a cell sees a change", RUN { const int& r = he[i].next; he[i].next = 4; return r; }, "4 he[4].next=4"},
{"a pointer to a cell", RUN { int* p = &he[i].next; *p = 4; return he[i].next; }, "4 he[4].next=4"},
{"cells swapped", RUN { std::swap(he[i].next, he[i + 1].next); return he[i].next; }, "1 he[4].next=1 he[5].next=11"},
{"a cell exchanged", RUN { int old = std::exchange(he[i].next, 3); return old; }, "11 he[4].next=3"},
{"a cell passed by reference", RUN { set_to_three(he[i].next); return he[i].next; }, "3 he[4].next=3"},
{"cells tied", RUN { std::tie(he[i].vi, he[i].fi) = std::pair(7, 8); return he[i].vi; }, "7 he[4].vi=7 he[4].fi=8"},
{"a macro assigned to", RUN { AFTER(i) = 5; return AFTER(i); }, "5 he[4].next=5"},
{"a cell read from a stream", RUN { std::istringstream in("6"); in >> he[i].opp; return he[i].opp; }, "6 he[4].opp=6"},
{"a read and a write of one cell", RUN { he[i].next = he[he[i].next].next; return he[i].next; }, "15 he[4].next=15"},
// ---- cells as arguments
{"a cell by value", RUN { return plus_one(he[i].next); }, "12"},
{"a cell by const reference", RUN { return by_const_reference(he[i].next); }, "12"},
{"a cell to a template", RUN { return doubled(he[i].next); }, "22"},
{"max with a literal", RUN { return std::max(he[i].vi, 3); }, "3"},
{"max of two cells", RUN { return std::max(he[i].vi, he[he[i].opp].vi); }, "2"},
{"min of a list", RUN { return std::min({he[i].vi, he[i].next, he[i].opp}); }, "1"},
{"abs", RUN { return std::abs(he[i].vi - 9); }, "8"},
{"clamp", RUN { return std::clamp(he[i].next, 0, 5); }, "5"},
{"printf", RUN { char text[9]; return std::snprintf(text, sizeof text, "%d", he[i].next) + text[0] - '0'; }, "3"},
{"a stream", RUN { std::ostringstream out; out << he[i].next << ' ' << he[i].vi; return static_cast<int>(out.str().size()); }, "4"},
{"fmt", RUN { return static_cast<int>(fmt::format("{:>3} {}", he[i].next, he[i].vi).size()); }, "5"},
{"to_string", RUN { return static_cast<int>(std::to_string(he[i].next).size()); }, "2"},
{"a tuple of cells", RUN { const auto [v, f] = std::tuple(he[i].vi, he[i].fi); return 10 * v + f; }, "11"},
{"a pair of cells, sorted", RUN { const auto [low, high] = std::minmax({he[i].vi, he[he[i].opp].vi}); return 10 * low + high; }, "12"},
// ---- cells and containers
{"an array of cells", RUN { int cells[] = {he[i].vi, he[i].next}; return cells[0] + cells[1]; }, "12"},
{"a std::array of cells", RUN { std::array<int, 2> ends{he[i].vi, he[he[i].opp].vi}; return 10 * ends[0] + ends[1]; }, "12"},
{"a vector of cells, deduced", RUN { std::vector cells{he[i].vi, he[i].next}; cells.push_back(he[i].opp); return std::accumulate(cells.begin(), cells.end(), 0); }, "15"},
{"push_back and emplace_back", RUN { std::vector<int> v; v.push_back(he[i].vi); v.emplace_back(he[i].next); return v[0] + v[1]; }, "12"},
{"a cell as index of an array", RUN { int names[6] = {5, 4, 3, 2, 1, 0}; return names[he[i].vi]; }, "4"},
{"a vector of bool", RUN { std::vector<bool> seen(16); seen[static_cast<std::size_t>(he[i].next)] = true; return seen[11]; }, "1"},
{"a set", RUN { std::set<int> seen; seen.insert(he[i].vi); seen.insert(he[5].vi); return static_cast<int>(seen.size() + seen.count(he[i].vi)); }, "2"},
{"a map", RUN { std::map<int, int> valence; valence[he[i].vi]++; ++valence[he[5].vi]; return valence[1]; }, "2"},
{"a map by pairs of cells", RUN { std::map<std::pair<int, int>, int> edge; edge[{he[i].vi, he[he[i].opp].vi}] = i; return edge.at({1, 2}); }, "4"},
{"an unordered map", RUN { std::unordered_map<int, int> of; of[he[i].vi] = he[i].next; return of[1]; }, "11"},
{"a queue", RUN { std::queue<int> queue; queue.push(he[i].next); int k = queue.front(); queue.pop(); return he[k].vi; }, "2"},
{"an optional", RUN { std::optional<int> f = he[i].fi; if (f == -1) f.reset(); return f.value_or(9); }, "1"},
{"a variant", RUN { std::variant<int, bool> v = he[i].next; return std::get<int>(v); }, "11"},
{"find in a vector", RUN { std::vector<int> v{5, 1, 4}; return static_cast<int>(std::find(v.begin(), v.end(), he[i].vi) - v.begin()); }, "1"},
// ---- loops over the table
{"range for by const reference", RUN { int n = 0; for (const auto& h : he) n += h.fi == -1; return n; }, "6"},
{"range for by value", RUN { int n = 0; for (auto h : he) n += h.vi; return n; }, "40"},
{"range for that writes", RUN { for (HalfEdge& h : he) if (h.fi == 0) h.fi = 9; return he[1].fi; }, "9 he[1].fi=9 he[3].fi=9 he[5].fi=9"},
{"a loop by index", RUN { int n = 0; for (int k = 0; k < he.size(); k++) n += he[k].fi == -1; return n; }, "6"},
{"a loop by unsigned index", RUN { int n = 0; for (unsigned k = 0; k < 4; ++k) n += he[k].vi; return n; }, "4"},
{"count_if", RUN { return static_cast<int>(std::count_if(he.begin(), he.end(), [](const HalfEdge& h) { return h.fi == -1; })); }, "6"},
{"accumulate", RUN { return std::accumulate(he.begin(), he.end(), 0, [](int sum, const HalfEdge& h) { return sum + h.vi; }); }, "40"},
{"ranges::count by field", RUN { return static_cast<int>(std::ranges::count(he, -1, &HalfEdge::fi)); }, "6"},
{"a maximum over the table", RUN { return std::max_element(he.begin(), he.end(), [](const HalfEdge& a, const HalfEdge& b) { return a.vi < b.vi; })->vi; }, "5"},
// ---- functions
{"a lambda that captures the table", RUN { auto after = [&](int k) { return he[k].next; }; return after(after(i)); }, "15"},
{"a lambda with two kinds of return", RUN { auto f = [&](int k) { if (k < 0) return -1; return he[k].next; }; return f(i); }, "11"},
{"a function object", RUN { std::function<int(int)> across = [&](int k) { return he[k].opp; }; return across(i); }, "3"},
{"recursion", RUN { return sides_from(he, i, i); }, "4"},
{"a const table", RUN { const HalfEdgeTable& c = he; return c[i].next; }, "11"},
{"a pointer to the table", RUN { HalfEdgeTable* p = &he; return (*p)[i].next + p->operator[](i).vi; }, "12"},
{"a copy of the table", RUN { HalfEdgeTable copy = he; copy[i].next = 0; return he[i].next + (copy == he); }, "11"},
{"a table moved", RUN { HalfEdgeTable copy = he; HalfEdgeTable moved = std::move(copy); return moved[i].next + (moved == he); }, "12"},
{"a table in a smart pointer", RUN { auto p = std::make_unique<HalfEdgeTable>(he); return (*p)[i].next; }, "11"},
{"rows appended", RUN { he.push_back({1, 2, 3, 4}); he.push_back(HalfEdge{}); return he.size() + he[16].opp; }, "22 he[16]=1,2,3,4 he[17]=-1,-1,-1,-1"},
{"an empty table", RUN { HalfEdgeTable none; return none.empty() + none.size(); }, "1"},
{"a table from rows", RUN { std::vector<HalfEdge> rows{he[1], he[2]}; HalfEdgeTable other(rows); return other[1].next; }, "6"},
};
    // clang-format on

    inline std::string changes(const HalfEdgeTable& before,
                               const HalfEdgeTable& after) {
        std::string text;
        for (int i = 0; i < after.size(); ++i) {
            const HalfEdge is = after[i];
            if (i >= before.size()) {
                text += fmt::format(" he[{}]={},{},{},{}", i, is.vi, is.fi,
                                    is.next, is.opp);
                continue;
            }
            const HalfEdge was = before[i];
            if (is.vi != was.vi) text += fmt::format(" he[{}].vi={}", i, is.vi);
            if (is.fi != was.fi) text += fmt::format(" he[{}].fi={}", i, is.fi);
            if (is.next != was.next)
                text += fmt::format(" he[{}].next={}", i, is.next);
            if (is.opp != was.opp)
                text += fmt::format(" he[{}].opp={}", i, is.opp);
        }
        return text;
    }

    inline std::string outcome(const Construct& construct) {
        HalfEdgeTable he = slide_table();
        const int result = construct.run(he, 4);
        return fmt::format("{}{}", result, changes(slide_table(), he));
    }

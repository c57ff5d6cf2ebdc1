// What the traced build records, and the steps that are made of it. The
// expected steps are the same for every compiler.
#undef COURSE_TABLE
#define COURSE_TABLE 2
#include "course/halfedge/trace.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "course/runner/catch2.h"

using course::trace_steps;
using course::TraceStep;

// clang-format off
#define NEXT(k) he[k].next
#define ROW(k) (he[k])
#define CURSOR he[i]

namespace {

const int first_line = __LINE__;
int nested(HalfEdgeTable& he, int i) {
    return he[he[he[i].opp].next].vi;
}
int several_lines(HalfEdgeTable& he, int i) {
    return he
        [ he[i]
              .next ]
            .vi;
}
void assigned(HalfEdgeTable& he, int i) {
    he[i].fi = 7; he[i].fi = 7;
}
void copied(HalfEdgeTable& he, int i) {
    he[i].opp = he[i + 1].vi = 8;
}
void changed(HalfEdgeTable& he, int i) {
    he[i].vi++; --he[i].vi; he[i].vi += 2; he[i].vi <<= 1;
}
int compared(HalfEdgeTable& he, int i) {
    return he[i].vi == 3 || he[i].vi <= 3 || he[i].vi >= 3 || he[i].fi != 1;
}
int by_reference(HalfEdgeTable& he, int i) {
    HalfEdge& h = he[i]; h.opp = he[i].vi;
    return he[0].vi;
}
void swapped(HalfEdgeTable& he, int i) {
    int& a = he[i].next; int& b = he[0].next;
    std::swap(a, b);
}
int ternary(HalfEdgeTable& he, int i) {
    return i > 2 ? he[i].next : he[he[i].vi > 0 ? he[i].opp : i].vi;
}
int through_macros(HalfEdgeTable& he, int i) {
    return NEXT(NEXT(i)) + ROW(i).vi + CURSOR.fi;
}
void macro_written(HalfEdgeTable& he, int i) {
    NEXT(i) = 0;
}
int odd_text(HalfEdgeTable& he, int i) {
    int a = he[ /* ] */ i ] . /* .opp */ vi;
    a += he["]"[0] == ']' ? i : 0].fi + he[1'0 - 10].vi;  // he[9].opp
    return a + (*&he)[i].next + he[{i}].opp;
}
void whole_row(HalfEdgeTable& he, int i) {
    he[i] = {9, 1, 9, 3};
}
void appended(HalfEdgeTable& he, int) {
    he.push_back({5, -1, 6, 7});
    he[2].fi = -1;
}
int after_umlaut(HalfEdgeTable& he, int i) {
	/* è */ return he[i].vi;
}
int all_rows(HalfEdgeTable& he, int) {
    int sum = 0;
    for (const HalfEdge& h : he) sum += h.vi;
    return sum;
}
// clang-format on

HalfEdgeTable table() {
    return {{0, 1, 1, 2}, {1, 1, 2, 0}, {2, 1, 0, 1}};
}

std::string source() {
    std::ifstream file(COURSE_SOURCE_DIR
                       "/course/tests/halfedge_trace_test.cpp");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

template <class Function>
std::vector<TraceStep> steps(Function function, int i) {
    HalfEdgeTable he = table();
    he.start_trace();
    function(he, i);
    return trace_steps(he.stop_trace(), table(), source());
}

TraceStep read(int i, std::string field, int line, int from, int to,
               int value) {
    return {i,    std::move(field), first_line + line, from, to, false, value,
            value};
}

TraceStep written(int i, std::string field, int line, int from, int to,
                  int before, int value) {
    return {i,     std::move(field), first_line + line, from, to, true, value,
            before};
}

using Steps = std::vector<TraceStep>;

}  // namespace

namespace course {

std::ostream& operator<<(std::ostream& out, const TraceStep& s) {
    return out << (s.write ? "write" : "read") << " he[" << s.i << "]."
               << s.field << ", line +" << s.line - first_line << ", " << s.from
               << ".." << s.to << ", " << s.before << " -> " << s.value;
}

}  // namespace course

TEST_CASE("the source of this test can be read") {
    REQUIRE(source().find("int nested(HalfEdgeTable& he, int i)") !=
            std::string::npos);
}

TEST_CASE("nested subscripts are steps from the inner to the outer one") {
    CHECK(steps(nested, 1) == Steps{read(1, "opp", 2, 18, 27, 0),
                                    read(0, "next", 2, 15, 33, 1),
                                    read(1, "vi", 2, 12, 37, 1)});
}

TEST_CASE("of a subscript over several lines the one with the ] is shown") {
    CHECK(steps(several_lines, 1) ==
          Steps{read(1, "next", 6, 11, 16, 2), read(2, "vi", 7, 15, 22, 2)});
}

TEST_CASE("an assignment is a write, also when the value stays the same") {
    CHECK(steps(assigned, 1) == Steps{written(1, "fi", 11, 5, 13, 1, 7),
                                      written(1, "fi", 11, 19, 27, 7, 7)});
}

TEST_CASE("in a chain of assignments the right one comes first") {
    CHECK(steps(copied, 1) == Steps{written(2, "vi", 14, 17, 29, 2, 8),
                                    written(1, "opp", 14, 5, 14, 0, 8)});
}

TEST_CASE("increments and compound assignments are writes") {
    CHECK(steps(changed, 1) == Steps{written(1, "vi", 17, 5, 13, 1, 2),
                                     written(1, "vi", 17, 19, 27, 2, 1),
                                     written(1, "vi", 17, 29, 37, 1, 3),
                                     written(1, "vi", 17, 44, 52, 3, 6)});
}

TEST_CASE("comparisons are reads") {
    CHECK(steps(compared, 1) ==
          Steps{read(1, "vi", 20, 12, 20, 1), read(1, "vi", 20, 29, 37, 1)});
}

TEST_CASE("a write through a reference is placed where the row was taken") {
    CHECK(steps(by_reference, 1) == Steps{read(1, "", 23, 19, 24, 0),
                                          read(1, "vi", 23, 34, 42, 1),
                                          written(1, "opp", 23, 19, 24, 0, 1),
                                          read(0, "vi", 24, 12, 20, 0)});
    CHECK(steps(swapped, 1) == Steps{read(1, "next", 27, 14, 24, 2),
                                     read(0, "next", 27, 35, 45, 1),
                                     written(0, "next", 27, 35, 45, 1, 2),
                                     written(1, "next", 27, 14, 24, 2, 1)});
}

TEST_CASE("of a conditional expression only what is evaluated is a step") {
    CHECK(steps(ternary, 1) == Steps{read(1, "vi", 31, 36, 44, 1),
                                     read(1, "opp", 31, 51, 60, 0),
                                     read(0, "vi", 31, 33, 68, 0)});
}

TEST_CASE("a macro is shown as it is used, with the field that it names") {
    CHECK(steps(through_macros, 1) ==
          Steps{read(1, "next", 34, 12, 25, 2), read(2, "next", 34, 12, 25, 0),
                read(1, "", 34, 28, 34, 0), read(1, "", 34, 40, 46, 0)});
    CHECK(steps(macro_written, 1) ==
          Steps{written(1, "next", 37, 5, 12, 2, 0)});
}

TEST_CASE("comments, literals and odd operands do not hide the field") {
    CHECK(steps(odd_text, 1) ==
          Steps{read(1, "vi", 40, 13, 44, 1), read(1, "fi", 41, 10, 38, 1),
                read(0, "vi", 41, 41, 56, 0), read(1, "next", 42, 16, 30, 2),
                read(1, "opp", 42, 33, 44, 0)});
}

TEST_CASE("a whole row that is assigned gives a step for each changed cell") {
    CHECK(steps(whole_row, 1) == Steps{written(1, "", 45, 5, 10, 0, 0),
                                       written(1, "vi", 45, 5, 10, 1, 9),
                                       written(1, "next", 45, 5, 10, 2, 9),
                                       written(1, "opp", 45, 5, 10, 0, 3)});
}

TEST_CASE("a row that is appended is one step") {
    TraceStep added = written(3, "", 48, 5, 32, 0, 0);
    added.added = true;
    CHECK(steps(appended, 0) ==
          Steps{added, written(2, "fi", 49, 5, 13, 1, -1)});
}

TEST_CASE("columns count bytes, and a tab as one") {
    CHECK(steps(after_umlaut, 1) == Steps{read(1, "vi", 52, 18, 26, 1)});
}

TEST_CASE("a loop over the whole table reads every row, at no known place") {
    const int unknown = -first_line;
    CHECK(steps(all_rows, 0) == Steps{read(0, "", unknown, 0, 0, 0),
                                      read(1, "", unknown, 0, 0, 0),
                                      read(2, "", unknown, 0, 0, 0)});
}

TEST_CASE("a place that is not in the source gives a step without a field") {
    const std::vector<TraceEvent> events = {{1, 99, 3, {}}, {1, 1, 99, {}}};
    CHECK(trace_steps(events, table(), "he[i].vi\n") ==
          Steps{{1, "", 99, 0, 0, false, 0, 0}, {1, "", 1, 0, 0, false, 0, 0}});
}

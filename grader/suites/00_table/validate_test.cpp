// Hidden suite of validate: broken tables of every kind, compared with the
// definitions in finding.h, asked one by one.
#include "course/halfedge/validate.h"

#include <algorithm>
#include <climits>
#include <random>
#include <set>
#include <string>

#include "course/runner/suite.h"
#include "exercises/00_table/validate.h"

using namespace course;

namespace {

using Findings = std::vector<Finding>;
using Rows = std::vector<HalfEdge>;
using Faults = std::set<Fault>;

const Faults ranges = {Fault::vertex_out_of_range, Fault::face_out_of_range,
                       Fault::next_out_of_range, Fault::opp_out_of_range};
const Faults about_opp = {Fault::opp_is_itself, Fault::opp_not_mutual,
                          Fault::opp_same_start};
const Faults about_next = {Fault::next_not_at_tip, Fault::next_changes_face};
const Faults about_shared = {Fault::next_shared};

// A sound cell holds none of these but -1, and that only in the column fi.
const std::vector<int> out_of_range = {INT_MIN, -2, -1, 16, INT_MAX};

// ---- the definitions

bool is_row(const Rows& he, int i) {
    return i >= 0 && i < static_cast<int>(he.size());
}

const HalfEdge& at(const Rows& he, int i) {
    return he.at(static_cast<std::size_t>(i));
}

bool is_next_of_another(const Rows& he, int i) {
    for (int m = 0; is_row(he, m); ++m)
        if (m != i && at(he, m).next == at(he, i).next) return true;
    return false;
}

/// Whether half-edge i breaks the rule, as finding.h defines it.
bool breaks(const Rows& he, Fault fault, int i) {
    const int j = at(he, i).opp;
    const int k = at(he, i).next;
    switch (fault) {
        case Fault::vertex_out_of_range:
            return at(he, i).vi < 0;
        case Fault::face_out_of_range:
            return at(he, i).fi < -1;
        case Fault::next_out_of_range:
            return !is_row(he, k);
        case Fault::opp_out_of_range:
            return !is_row(he, j);
        case Fault::opp_is_itself:
            return j == i;
        case Fault::opp_not_mutual:
            return is_row(he, j) && at(he, j).opp != i;
        case Fault::opp_same_start:
            return is_row(he, j) && at(he, j).vi == at(he, i).vi;
        case Fault::next_not_at_tip:
            return is_row(he, j) && is_row(he, k) &&
                   at(he, k).vi != at(he, j).vi;
        case Fault::next_changes_face:
            return is_row(he, k) && at(he, k).fi != at(he, i).fi;
        case Fault::next_shared:
            return is_row(he, k) && is_next_of_another(he, i);
        case Fault::face_in_two_loops:
            break;
    }
    return false;  // not asked for
}

Findings by_definition(const Rows& he) {
    Findings found;
    for (const Faults& faults : {ranges, about_opp, about_next, about_shared})
        for (const Fault fault : faults)
            for (int i = 0; is_row(he, i); ++i)
                if (breaks(he, fault, i)) found.push_back({fault, i});
    return found;
}

// ---- broken tables

struct Column {
    int HalfEdge::*field;
    std::string name;
};

const Column vi = {&HalfEdge::vi, "vi"};
const Column fi = {&HalfEdge::fi, "fi"};
const Column next = {&HalfEdge::next, "next"};
const Column opp = {&HalfEdge::opp, "opp"};

std::vector<int> numbers(int first, int last) {
    std::vector<int> list;
    for (int value = first; value <= last; ++value) list.push_back(value);
    return list;
}

Findings sorted(Findings findings) {
    std::sort(findings.begin(), findings.end());
    return findings;
}

/// The findings of some of the rules, sorted.
Findings only(const Faults& faults, const Findings& findings) {
    Findings some;
    for (const Finding& finding : findings)
        if (faults.count(finding.fault) > 0) some.push_back(finding);
    return sorted(some);
}

/// Which findings a case compares, and in which order.
using Choice = Findings (*)(Findings);

Findings only_ranges(Findings all) {
    return only(ranges, all);
}
Findings only_opp(Findings all) {
    return only(about_opp, all);
}
Findings only_next(Findings all) {
    return only(about_next, all);
}
Findings only_shared(Findings all) {
    return only(about_shared, all);
}

/// What there is to find. The course's own validator must say the same, and it
/// has one rule more.
Findings expected(const HalfEdgeTable& he) {
    Findings found = by_definition(he.rows());
    Findings same;
    for (const Finding& finding : course::validate(he))
        if (finding.fault != Fault::face_in_two_loops) same.push_back(finding);
    REQUIRE(sorted(same) == found);
    return found;
}

/// Calls `check` with each table that has one cell of a column changed.
template <class Check>
void for_each_wrong_cell(const Fixture& fixture, const Column& column,
                         const std::vector<int>& values, Check check) {
    const OnMesh on(fixture);
    for (int i = 0; i < fixture.he.size(); ++i) {
        for (const int value : values) {
            HalfEdgeTable he = fixture.he;
            he[i].*column.field = value;
            INFO("he[" << i << "]." << column.name << " = " << value);
            check(he);
        }
    }
}

void check(const HalfEdgeTable& he, Choice chosen) {
    const ListMatcher<Findings> are_wanted(chosen(expected(he)), chosen,
                                           "is, in any order: ");
    REQUIRE_THAT(::validate(he), are_wanted);
}

void check_all(const HalfEdgeTable& he) {
    check(he, sorted);
}

/// One wrong cell in the slide table; compares the findings of some rules.
void check_some(const Column& column, const std::vector<int>& values,
                Choice chosen) {
    for_each_wrong_cell(
        zoo::slide(), column, values,
        [chosen](const HalfEdgeTable& he) { check(he, chosen); });
}

using Random = std::mt19937_64;

/// A number from first to last; the standard's own way differs by platform.
int between(Random& random, int first, int last) {
    const auto span = static_cast<std::uint64_t>(last - first + 1);
    return first + static_cast<int>(random() % span);
}

/// Any number that a cell may come to hold, most often one of a row.
int any_number(Random& random, int size) {
    return between(random, 0, 19) == 0 ? (random() % 2 == 0 ? INT_MIN : INT_MAX)
                                       : between(random, -2, size + 1);
}

HalfEdge any_row(Random& random, int size) {
    return {between(random, -1, 3), between(random, -2, 2),
            any_number(random, size), any_number(random, size)};
}

}  // namespace

TEST_CASE("numbers that are out of range, in each cell", "[points:1]") {
    hint("Which numbers may stand in each of the four columns?");
    for (const Column& column : {vi, fi, next, opp})
        check_some(column, out_of_range, only_ranges);
}

TEST_CASE("opposites that are not opposite", "[points:1]") {
    hint("What do two opposite half-edges know of each other?");
    check_some(opp, numbers(0, 15), only_opp);
    check_some(vi, numbers(0, 6), only_opp);
}

TEST_CASE("half-edges that are followed by the wrong one", "[points:1]") {
    hint("Where does i arrive, and what must its next have in common with it?");
    check_some(next, numbers(0, 15), only_next);
    check_some(vi, numbers(0, 6), only_next);
    check_some(fi, numbers(-1, 3), only_next);
    check_some(opp, {0, 5, 10, 15}, only_next);
}

TEST_CASE("half-edges with the same next", "[points:1]") {
    hint(
        "If two half-edges have the same next, which of them breaks the rule?");
    check_some(next, numbers(0, 15), only_shared);
}

TEST_CASE("one wrong cell: every finding, and no other", "[points:1]") {
    hint(
        "Which rules can be asked when a cell is out of range, and which not? "
        "Which are asked twice?");
    std::vector<int> rows = numbers(0, 15);
    rows.insert(rows.end(), out_of_range.begin(), out_of_range.end());
    const std::vector<int> vertices = {INT_MIN, -1, 0, 1, 2,
                                       3,       4,  5, 6, INT_MAX};
    const std::vector<int> faces = {INT_MIN, -2, -1, 0, 1, 2, 3, INT_MAX};
    const Fixture fixture = renumbered(zoo::slide());
    for_each_wrong_cell(fixture, next, rows, check_all);
    for_each_wrong_cell(fixture, opp, rows, check_all);
    for_each_wrong_cell(fixture, vi, vertices, check_all);
    for_each_wrong_cell(fixture, fi, faces, check_all);
}

TEST_CASE("tables in which there is nothing to find", "[points:1]") {
    hint("Does a sound table have to look like the slide's?");
    check_all({});
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        REQUIRE(by_definition(fixture.he.rows()).empty());
        check_all(fixture.he);
    }
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    HalfEdgeTable he = slide.he;
    for (const int i : {1, 3, 5}) he[i].fi = he[4].fi;
    INFO("the slide table with one number for two faces: not asked for");
    REQUIRE(by_definition(he.rows()).empty());
    check_all(he);
}

TEST_CASE("several wrong cells, and tables of arbitrary numbers",
          "[points:1]") {
    hint(
        "Does your answer for one half-edge depend on what is wrong at another "
        "one?");
    Random random(seed());
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        HalfEdgeTable he = fixture.he;
        for (int count = 0; count < 4; ++count) {
            HalfEdge& row = he[between(random, 0, he.size() - 1)];
            row = any_row(random, he.size());
            CAPTURE(he);
            check_all(he);
        }
    }
    for (int trial = 0; trial < 120; ++trial) {
        const int size = between(random, 1, 6);
        HalfEdgeTable he;
        while (he.size() < size) he.push_back(any_row(random, size));
        CAPTURE(he);
        check_all(he);
    }
}

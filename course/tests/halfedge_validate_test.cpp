// The validator against an oracle that asks each rule of each half-edge.
#include "course/halfedge/validate.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "course/halfedge/build.h"
#include "course/halfedge/renumber.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"

namespace course {

namespace {

using Rows = std::vector<HalfEdge>;

// The slide's table.
Rows slide_rows() {
    return {{2, -1, 2, 1},  {0, 0, 3, 0},   {0, -1, 6, 5},  {2, 0, 5, 4},
            {1, 1, 11, 3},  {1, 0, 1, 2},   {1, -1, 7, 12}, {4, -1, 10, 15},
            {5, 2, 14, 11}, {3, 2, 8, 10},  {5, -1, 13, 9}, {2, 1, 15, 8},
            {4, 1, 4, 6},   {3, -1, 0, 14}, {2, 2, 9, 13},  {5, 1, 12, 7}};
}

int& cell(Rows& rows, int i, int field) {
    HalfEdge& row = rows[static_cast<std::size_t>(i)];
    int* const cells[] = {&row.vi, &row.fi, &row.next, &row.opp};
    return *cells[field];
}

/// The rules as finding.h states them, one after the other.
class Oracle {
public:
    explicit Oracle(const Rows& rows) : rows_(rows) {}

    bool breaks(Fault fault, int i) const {
        const HalfEdge& row = at(i);
        const bool has_opp = is_row(row.opp);
        const bool has_next = is_row(row.next);
        switch (fault) {
            case Fault::vertex_out_of_range:
                return row.vi < 0;
            case Fault::face_out_of_range:
                return row.fi < -1;
            case Fault::next_out_of_range:
                return !has_next;
            case Fault::opp_out_of_range:
                return !has_opp;
            case Fault::opp_is_itself:
                return row.opp == i;
            case Fault::opp_not_mutual:
                return has_opp && at(row.opp).opp != i;
            case Fault::opp_same_start:
                return has_opp && at(row.opp).vi == row.vi;
            case Fault::next_not_at_tip:
                return has_opp && has_next && at(row.next).vi != at(row.opp).vi;
            case Fault::next_changes_face:
                return has_next && at(row.next).fi != row.fi;
            case Fault::next_shared:
                return has_next && is_shared(i);
            case Fault::face_in_two_loops:
                return is_later_loop(i);
        }
        return false;
    }

private:
    bool is_row(int i) const {
        return i >= 0 && i < static_cast<int>(rows_.size());
    }
    const HalfEdge& at(int i) const {
        return rows_[static_cast<std::size_t>(i)];
    }
    bool is_shared(int i) const {
        for (int k = 0; is_row(k); ++k)
            if (k != i && at(k).next == at(i).next) return true;
        return false;
    }
    /// The loop of i; empty when there is none, or a next in it is faulty.
    std::set<int> loop(int i) const {
        std::set<int> met;
        int k = i;
        do {
            if (breaks(Fault::next_out_of_range, k) ||
                breaks(Fault::next_changes_face, k) ||
                breaks(Fault::next_shared, k) || !met.insert(k).second)
                return {};
            k = at(k).next;
        } while (k != i);
        return met;
    }
    bool is_later_loop(int i) const {
        const std::set<int> own = loop(i);
        if (at(i).fi < 0 || own.empty() || *own.begin() != i) return false;
        for (int k = 0; k < i; ++k)
            if (at(k).fi == at(i).fi && !loop(k).empty()) return true;
        return false;
    }

    Rows rows_;
};

std::vector<Finding> expected(const Rows& rows) {
    const Oracle oracle(rows);
    std::vector<Finding> findings;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i)
        for (int f = 0; f <= static_cast<int>(Fault::face_in_two_loops); ++f)
            if (oracle.breaks(static_cast<Fault>(f), i))
                findings.push_back({static_cast<Fault>(f), i});
    return findings;
}

std::vector<std::string> lines_of(const Rows& rows) {
    const HalfEdgeTable he(rows);
    std::vector<std::string> lines;
    for (const Finding& finding : validate(he))
        lines.push_back(to_string(he, finding));
    return lines;
}

std::vector<std::string> lines_with(int i, int field, int value) {
    Rows rows = slide_rows();
    cell(rows, i, field) = value;
    return lines_of(rows);
}

using Lines = std::vector<std::string>;

enum Field { vi, fi, next, opp };

}  // namespace

TEST_CASE("sound tables have no findings") {
    CHECK(validate({}).empty());
    CHECK(validate(HalfEdgeTable(slide_rows())).empty());
    Random random(30);
    for (int round = 0; round < 300; ++round)
        CHECK(validate(renumber(build(random_sound_mesh(random)), random()))
                  .empty());
}

TEST_CASE("every single cell that is changed in the slide's table is found") {
    for (int i = 0; i < 16; ++i)
        for (int field = 0; field < 4; ++field)
            for (int value = -3; value < 20; ++value) {
                Rows rows = slide_rows();
                if (cell(rows, i, field) == value) continue;
                // Another number for a vertex or a face of one half-edge is
                // noticed where it meets the others.
                cell(rows, i, field) = value;
                CAPTURE(i, field, value);
                REQUIRE(!validate(HalfEdgeTable(rows)).empty());
                REQUIRE(validate(HalfEdgeTable(rows)) == expected(rows));
            }
}

TEST_CASE("findings are those of the rules, taken one by one") {
    Random random(31);
    for (int round = 0; round < 3000; ++round) {
        Rows rows = build(random_sound_mesh(random)).rows();
        const int n = static_cast<int>(rows.size());
        if (n == 0) continue;
        const int changes = below(6, random);
        for (int k = 0; k < changes; ++k)
            cell(rows, below(n, random), below(4, random)) =
                below(n + 4, random) - 2;
        REQUIRE(validate(HalfEdgeTable(rows)) == expected(rows));
    }
}

TEST_CASE("any numbers at all may stand in the table") {
    Random random(32);
    const int wild[] = {std::numeric_limits<int>::min(), -2, -1, 0, 1,
                        std::numeric_limits<int>::max()};
    for (int round = 0; round < 3000; ++round) {
        const int n = below(9, random);
        Rows rows(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i)
            for (int field = 0; field < 4; ++field)
                cell(rows, i, field) = below(3, random) == 0
                                           ? wild[below(6, random)]
                                           : below(n, random);
        REQUIRE(validate(HalfEdgeTable(rows)) == expected(rows));
        for (const std::string& line : lines_of(rows)) REQUIRE(!line.empty());
    }
}

TEST_CASE("two faces of one number are found, whatever the order of the rows") {
    // Two triangles apart that are both called face 0.
    IndexedMesh mesh;
    mesh.positions.resize(6);
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    Rows rows = build(mesh).rows();
    for (HalfEdge& row : rows) row.fi = std::min(row.fi, 0);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const HalfEdgeTable he = renumber(HalfEdgeTable(rows), seed);
        const std::vector<Finding> findings = validate(he);
        REQUIRE(findings.size() == 1);
        CHECK(findings[0].fault == Fault::face_in_two_loops);
        CHECK(findings == expected(he.rows()));
    }
    CHECK(lines_of(rows) ==
          Lines{"half-edge 6: fi is 0, but the loop of half-edge 0, which is "
                "another, is face 0 too"});
}

TEST_CASE("each fault is told with element, fact and expectation") {
    CHECK(lines_with(12, opp, 7) ==
          Lines{"half-edge 6: opp is 12, but opp of 12 is 7",
                "half-edge 12: opp is 7, but opp of 7 is 15",
                "half-edge 12: opp is 7, but both leave vertex 4 and not the "
                "two ends of an edge",
                "half-edge 12: next is 4, but 4 leaves vertex 1 and not the "
                "tip, vertex 4"});
    CHECK(lines_with(3, opp, 3) ==
          Lines{"half-edge 3: opp is the half-edge itself, but the opposite is "
                "another one",
                "half-edge 3: opp is 3, but both leave vertex 2 and not the "
                "two ends of an edge",
                "half-edge 3: next is 5, but 5 leaves vertex 1 and not the "
                "tip, vertex 2",
                "half-edge 4: opp is 3, but opp of 3 is 3"});
    CHECK(lines_with(3, opp, 16) ==
          Lines{"half-edge 3: opp is 16, but the half-edges are 0..15",
                "half-edge 4: opp is 3, but opp of 3 is 16"});
    CHECK(lines_with(3, next, -1) ==
          Lines{"half-edge 3: next is -1, but the half-edges are 0..15"});
    CHECK(lines_with(3, next, 1) ==
          Lines{"half-edge 3: next is 1, but 1 leaves vertex 0 and not the "
                "tip, vertex 1",
                "half-edge 3: next is 1, but next of 5 is 1 too",
                "half-edge 5: next is 1, but next of 3 is 1 too"});
    CHECK(lines_with(13, fi, -2) ==
          Lines{"half-edge 10: next is 13, but fi of 13 is -2 and not -1",
                "half-edge 13: fi is -2, but faces are 0 or more, and -1 is "
                "the border",
                "half-edge 13: next is 0, but fi of 0 is -1 and not -2"});
    CHECK(lines_with(13, vi, -1) ==
          Lines{"half-edge 10: next is 13, but 13 leaves vertex -1 and not the "
                "tip, vertex 3",
                "half-edge 13: vi is -1, but vertices are 0 or more",
                "half-edge 14: next is 9, but 9 leaves vertex 3 and not the "
                "tip, vertex -1"});
}

TEST_CASE("a large table of one endless tail is read once") {
    // Each next leads one back: a walk from every half-edge, made without
    // remembering the ones before, would take n * n steps.
    constexpr int n = 1'000'000;
    Rows rows(n);
    for (int i = 0; i < n; ++i)
        rows[static_cast<std::size_t>(i)] = {0, 0, i - 1, i ^ 1};
    const std::vector<Finding> findings = validate(HalfEdgeTable(rows));
    CHECK(findings.front() == Finding{Fault::next_out_of_range, 0});
}

}  // namespace course

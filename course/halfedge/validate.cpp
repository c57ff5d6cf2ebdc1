// The rules of the half-edge table, one by one.
#include "course/halfedge/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace course {

namespace {

using Rows = std::vector<HalfEdge>;

bool has_row(const Rows& rows, int i) {
    return i >= 0 && static_cast<std::size_t>(i) < rows.size();
}

const HalfEdge& at(const Rows& rows, int i) {
    return rows[static_cast<std::size_t>(i)];
}

/// For each half-edge, how many have it as their next.
std::vector<int> uses_as_next(const Rows& rows) {
    std::vector<int> uses(rows.size(), 0);
    for (const HalfEdge& row : rows)
        if (has_row(rows, row.next)) ++uses[static_cast<std::size_t>(row.next)];
    return uses;
}

void check_ranges(const Rows& rows, int i, std::vector<Finding>& found) {
    const HalfEdge& row = at(rows, i);
    if (row.vi < 0) found.push_back({Fault::vertex_out_of_range, i});
    if (row.fi < -1) found.push_back({Fault::face_out_of_range, i});
    if (!has_row(rows, row.next))
        found.push_back({Fault::next_out_of_range, i});
    if (!has_row(rows, row.opp)) found.push_back({Fault::opp_out_of_range, i});
}

void check_opp(const Rows& rows, int i, std::vector<Finding>& found) {
    const HalfEdge& row = at(rows, i);
    if (!has_row(rows, row.opp)) return;
    const HalfEdge& other = at(rows, row.opp);
    if (row.opp == i) found.push_back({Fault::opp_is_itself, i});
    if (other.opp != i) found.push_back({Fault::opp_not_mutual, i});
    if (other.vi == row.vi) found.push_back({Fault::opp_same_start, i});
}

void check_next(const Rows& rows, const std::vector<int>& uses, int i,
                std::vector<Finding>& found) {
    const HalfEdge& row = at(rows, i);
    if (!has_row(rows, row.next)) return;
    const HalfEdge& after = at(rows, row.next);
    if (has_row(rows, row.opp) && after.vi != at(rows, row.opp).vi)
        found.push_back({Fault::next_not_at_tip, i});
    if (after.fi != row.fi) found.push_back({Fault::next_changes_face, i});
    if (uses[static_cast<std::size_t>(row.next)] > 1)
        found.push_back({Fault::next_shared, i});
}

/// The step from i to its next is one that a loop of a face may take.
bool is_sound_step(const Rows& rows, const std::vector<int>& uses, int i) {
    const HalfEdge& row = at(rows, i);
    return has_row(rows, row.next) && at(rows, row.next).fi == row.fi &&
           uses[static_cast<std::size_t>(row.next)] == 1;
}

/// Marks what is met on the way from i along next; true when it is a loop.
bool closes(const Rows& rows, const std::vector<int>& uses, int start,
            std::vector<bool>& met) {
    int i = start;
    do {
        if (met[static_cast<std::size_t>(i)]) return false;
        met[static_cast<std::size_t>(i)] = true;
        if (!is_sound_step(rows, uses, i)) return false;
        i = at(rows, i).next;
    } while (i != start);
    return true;
}

/// {face, smallest half-edge} of every loop that runs along a face, sorted.
std::vector<std::pair<int, int>> face_loops(const Rows& rows,
                                            const std::vector<int>& uses) {
    std::vector<std::pair<int, int>> loops;
    std::vector<bool> met(rows.size(), false);
    for (int i = 0; has_row(rows, i); ++i)
        if (at(rows, i).fi >= 0 && !met[static_cast<std::size_t>(i)] &&
            closes(rows, uses, i, met))
            loops.emplace_back(at(rows, i).fi, i);
    std::sort(loops.begin(), loops.end());
    return loops;
}

void check_loops(const Rows& rows, const std::vector<int>& uses,
                 std::vector<Finding>& found) {
    const std::vector<std::pair<int, int>> loops = face_loops(rows, uses);
    for (std::size_t k = 1; k < loops.size(); ++k)
        if (loops[k].first == loops[k - 1].first)
            found.push_back({Fault::face_in_two_loops, loops[k].second});
}

// ---- sound tables: two passes tell them, and most tables are

/// Keeps every rule that half-edge i can break by itself.
bool is_sound_row(const Rows& rows, int i) {
    const HalfEdge& row = at(rows, i);
    if (row.vi < 0 || row.fi < -1 || !has_row(rows, row.next) ||
        !has_row(rows, row.opp))
        return false;
    const HalfEdge& other = at(rows, row.opp);
    const HalfEdge& after = at(rows, row.next);
    return other.opp == i && other.vi != row.vi && after.vi == other.vi &&
           after.fi == row.fi;
}

/// Whether it was set before.
bool set(std::vector<bool>& bits, int i) {
    auto bit = bits[static_cast<std::size_t>(i)];
    const bool was = bit;
    bit = true;
    return was;
}

/// Whether no face has two loops. Each half-edge is the next of one other.
bool have_faces_one_loop(const Rows& rows) {
    std::vector<bool> met(rows.size(), false);
    std::vector<bool> has_loop(rows.size(), false);
    for (int start = 0; has_row(rows, start); ++start) {
        const int f = at(rows, start).fi;
        if (f == -1 || met[static_cast<std::size_t>(start)]) continue;
        if (!has_row(rows, f) || set(has_loop, f)) return false;
        for (int i = start; !set(met, i);) i = at(rows, i).next;
    }
    return true;
}

/// False also for sound tables with a face number that is larger than any
/// half-edge's.
bool is_surely_sound(const Rows& rows) {
    std::vector<bool> is_next(rows.size(), false);
    for (int i = 0; has_row(rows, i); ++i)
        if (!is_sound_row(rows, i) || set(is_next, at(rows, i).next))
            return false;
    return have_faces_one_loop(rows);
}

// ---- texts

/// A half-edge other than i with the same next.
int other_before(const Rows& rows, int i) {
    for (int k = 0; has_row(rows, k); ++k)
        if (k != i && at(rows, k).next == at(rows, i).next) return k;
    return -1;
}

/// The smallest half-edge of the first loop along the face of i.
int first_loop(const Rows& rows, int i) {
    const auto loops = face_loops(rows, uses_as_next(rows));
    return std::lower_bound(loops.begin(), loops.end(),
                            std::pair(at(rows, i).fi, 0))
        ->second;
}

std::string range_text(const Rows& rows, const char* field, int value) {
    return fmt::format("{} is {}, but the half-edges are 0..{}", field, value,
                       rows.size() - 1);
}

std::string opp_text(const Rows& rows, const HalfEdge& row, Fault fault) {
    const HalfEdge& other = at(rows, row.opp);
    if (fault == Fault::opp_is_itself)
        return "opp is the half-edge itself, but the opposite is another one";
    if (fault == Fault::opp_not_mutual)
        return fmt::format("opp is {}, but opp of {} is {}", row.opp, row.opp,
                           other.opp);
    return fmt::format(
        "opp is {}, but both leave vertex {} and not the two ends of an edge",
        row.opp, row.vi);
}

std::string next_text(const Rows& rows, int i, Fault fault) {
    const HalfEdge& row = at(rows, i);
    const HalfEdge& after = at(rows, row.next);
    if (fault == Fault::next_not_at_tip)
        return fmt::format(
            "next is {}, but {} leaves vertex {} and not the "
            "tip, vertex {}",
            row.next, row.next, after.vi, at(rows, row.opp).vi);
    if (fault == Fault::next_changes_face)
        return fmt::format("next is {}, but fi of {} is {} and not {}",
                           row.next, row.next, after.fi, row.fi);
    return fmt::format("next is {}, but next of {} is {} too", row.next,
                       other_before(rows, i), row.next);
}

std::string text(const Rows& rows, const Finding& finding) {
    const int i = finding.half_edge;
    const HalfEdge& row = at(rows, i);
    switch (finding.fault) {
        case Fault::vertex_out_of_range:
            return fmt::format("vi is {}, but vertices are 0 or more", row.vi);
        case Fault::face_out_of_range:
            return fmt::format(
                "fi is {}, but faces are 0 or more, and -1 is the border",
                row.fi);
        case Fault::next_out_of_range:
            return range_text(rows, "next", row.next);
        case Fault::opp_out_of_range:
            return range_text(rows, "opp", row.opp);
        case Fault::opp_is_itself:
        case Fault::opp_not_mutual:
        case Fault::opp_same_start:
            return opp_text(rows, row, finding.fault);
        case Fault::next_not_at_tip:
        case Fault::next_changes_face:
        case Fault::next_shared:
            return next_text(rows, i, finding.fault);
        case Fault::face_in_two_loops:
            return fmt::format(
                "fi is {}, but the loop of half-edge {}, which is another, is "
                "face {} too",
                row.fi, first_loop(rows, i), row.fi);
    }
    return "unknown fault";
}

}  // namespace

std::vector<Finding> validate(const HalfEdgeTable& he) {
    const Rows& rows = he.rows();
    if (is_surely_sound(rows)) return {};
    const std::vector<int> uses = uses_as_next(rows);
    std::vector<Finding> found;
    for (int i = 0; i < he.size(); ++i) {
        check_ranges(rows, i, found);
        check_opp(rows, i, found);
        check_next(rows, uses, i, found);
    }
    check_loops(rows, uses, found);
    std::sort(found.begin(), found.end(),
              [](const Finding& a, const Finding& b) {
                  return std::tie(a.half_edge, a.fault) <
                         std::tie(b.half_edge, b.fault);
              });
    return found;
}

std::string to_string(const HalfEdgeTable& he, const Finding& finding) {
    return fmt::format("half-edge {}: {}", finding.half_edge,
                       text(he.rows(), finding));
}

}  // namespace course

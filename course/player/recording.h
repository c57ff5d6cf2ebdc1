// Recorded walks: what a call of an exercise's function did with the half-edge
// table, step by step; and the JSON that pages read.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// vi, fi, next, opp.
using Row = std::array<int, 4>;

/// Names of variables, and their values as JSON.
using Variables = std::vector<std::pair<std::string, std::string>>;

/// A read or write of the table, or (without `i`) a line that was reached.
struct Step {
    int line = 0;  ///< of the source, from 1; 0 when it is not known
    int from = 0;  ///< columns of the expression in bytes, from 1, half open;
    int to = 0;    ///< 0 when they are not known
    int i = -1;
    int field = -1;  ///< 0 vi, 1 fi, 2 next, 3 opp; -1: the whole row
    int value = 0;   ///< of the cell, after the step
    std::optional<int> before = {};  ///< of a write
    std::optional<Row> added = {};   ///< the row is new
    /// The table now has so many rows only.
    std::optional<int> cut = {};
    /// Read in a table that was copied, and the copy has been edited since:
    /// the value may not be the one that the edited table has there.
    bool in_original = false;
    /// Local variables of its function that changed; null when the variable is
    /// gone. Those of a function that calls another one are there again when
    /// that returns.
    Variables locals = {};
    /// The function's name, when it is another one than in the step before.
    std::string function = {};
    /// How many calls of functions of the file it is in, when these are more or
    /// less than in the step before; the exercise's own function is in none.
    std::optional<int> depth = {};
};

/// A call and what it did until it returned or was stopped.
struct RecordedWalk {
    std::size_t source = 0;                 ///< which of Recording::sources
    std::string call;                       ///< "face_sides(he, 4)"
    std::optional<int> start;               ///< of which it is a walk
    std::optional<std::vector<Row>> table;  ///< at its start, when it is not
                                            ///< Recording::table
    std::vector<Step> steps;
    std::size_t skipped = 0;  ///< reads that are left out at the end
    std::string result;       ///< as JSON; empty when it did not return
    std::string error;        ///< why it did not
    /// The same of the reference, when there is one and this is not its walk.
    std::string expected, expected_error;
};

struct RecordedSource {
    std::string label;  ///< "reference" or "your file"
    std::string file;   ///< its name
    int first = 1;      ///< number of lines[0]: includes are left out
    std::vector<std::string> lines;
};

struct Recording {
    std::string exercise, topic, title;
    std::string start_kind;  ///< "half-edge", "vertex", or empty: what the
                             ///< starts of the walks are numbers of
    std::string mesh_name;
    IndexedMesh mesh;
    std::vector<Row> table;
    std::vector<RecordedSource> sources;
    std::vector<RecordedWalk> walks;
    /// What the person who records should know; not part of the page.
    std::vector<std::string> notes;
};

/// Above that many faces a drawing of the whole mesh with all its arrows shows
/// nothing: the page has the mesh in 3D, and arrows near to where a walk is.
inline constexpr int most_drawn_faces = 200;

/// As course/player/page expects it. Fields of a step: l line, c [from, to], i,
/// f field, v value, w value before (of a write), d locals, fn function, in
/// depth, new (row that is added), n (rows that are left), o (read in the
/// original).
std::string to_json(const Recording& recording);

/// The same as the page carries it: of more than most_drawn_faces, mesh and
/// table are left out, for large_mesh.h has a shorter way to say them.
std::string page_json(const Recording& recording);

/// Cuts the longest walks so that all have about `most` steps together, but
/// none to less than `least`: what is cut is counted as skipped.
void shorten(Recording& recording, std::size_t most, std::size_t least);

}  // namespace course

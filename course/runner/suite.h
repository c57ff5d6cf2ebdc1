// What a suite may use beside Catch2: fixtures, hints, read budgets, matchers.
// A suite runs unchanged in process against the reference solution and against
// a submission that lives in another process.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "course/halfedge/copies.h"
#include "course/halfedge/half_edge_table.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/runner/print.h"

namespace course {

/// A question that leads to the mistake; the student reads it when the case
/// fails, even where nothing else may be shown. First line of every case.
void hint(std::string text);

/// The seed of this run: renumbering and generated meshes come from it. Fixed
/// by default, logged in every report.
std::uint64_t seed();

/// While it lives, failures are reported, and drawn, as on this mesh.
class OnMesh {
public:
    explicit OnMesh(const Fixture& fixture);
    ~OnMesh();
    OnMesh(const OnMesh&) = delete;
    OnMesh& operator=(const OnMesh&) = delete;
};

/// While it lives, the calls on `he` may read `reads` half-edges in all; one
/// more ends the call as time limit exceeded. For the cost that a contract
/// promises. Use a new one for each call.
class ReadBudget {
public:
    ReadBudget(const HalfEdgeTable& he, std::int64_t reads);
    ~ReadBudget();
    ReadBudget(const ReadBudget&) = delete;
    ReadBudget& operator=(const ReadBudget&) = delete;

private:
    const HalfEdgeTable& he_;
};

/// The same mesh with half-edges, faces and vertices numbered anew, from the
/// seed of the run and `salt`. Throws std::logic_error where it has no table.
Fixture renumbered(const Fixture& fixture, std::uint64_t salt = 0);

/// Every fixture that has a table, and a renumbered copy of each.
std::vector<Fixture> all_fixtures();

/// Six random polygon meshes, open and closed, the first one flat, of one to
/// three components, with faces of 3 to 8 sides and no bow-tie; the same for
/// the same seed of the run.
std::vector<Fixture> generated_fixtures();

/// Calls check(mesh) for each of the meshes, up to the first on which it fails.
/// That one is then made smaller (smallest_failing.h says how) as long as the
/// check fails with the same verdict, and what is reported is the failure on
/// the smallest one. However the function answers meanwhile, the case has
/// failed.
///
/// The check is a piece of an ordinary suite, whose assertions call the
/// function; best with REQUIRE, which ends it, and UNSCOPED_INFO (an INFO would
/// outlive the REQUIRE). Where a contract does not allow every mesh that is a
/// part of the given ones, as one for closed meshes, it returns on the others.
/// Cost: beside the calls for the meshes at most 500, with 20'000 half-edges in
/// all.
void on_generated_meshes(const std::vector<Fixture>& meshes,
                         const std::function<void(const Fixture&)>& check);

/// A mesh with a million half-edges: many copies of a grid of quads, apart from
/// each other. What is expected of it is what is expected of the grid, under
/// the numbers of the copy.
struct LargeMesh {
    Fixture tile;  ///< the grid
    Copies copies;
    HalfEdgeTable he;
    MixedNumbers half_edges, vertices, faces;  ///< of (number in tile, copy)
};

/// For cases where the cost must not depend on the size of the mesh. Before the
/// first call of a case; its calls then have large_mesh_cpu in all.
/// Made once, in some 10 ms.
const LargeMesh& a_million_half_edges();

/// A half-edge of a large mesh: number `i` of copy `copy` of the tile.
struct InLargeMesh {
    const LargeMesh* mesh;
    int i;
    int copy;

    /// Its number in the large mesh.
    int row() const { return mesh->half_edges(i, copy); }

    /// Numbers of the tile as those of this copy.
    std::vector<int> half_edges(std::vector<int> of_tile) const;
    std::vector<int> vertices(std::vector<int> of_tile) const;
    std::vector<int> faces(std::vector<int> of_tile) const;
};

/// `n` half-edges all over the mesh, each of the tile in its turn.
std::vector<InLargeMesh> some_of(const LargeMesh& mesh, int n);

/// While it lives, calls f(he, i) are asked for ahead: those for i in `starts`,
/// in this order, many in one conversation. For one function, whose arguments
/// are the table and the half-edge, under one read budget for each call.
class AskAhead {
public:
    AskAhead(const HalfEdgeTable& he, std::vector<int> starts);
    ~AskAhead();
    AskAhead(const AskAhead&) = delete;
    AskAhead& operator=(const AskAhead&) = delete;
};

/// All its half-edges: 0, 1, 2 ...
std::vector<int> all_half_edges(const HalfEdgeTable& he);

/// How many calls on it a case makes: more than any scan of a million rows can
/// answer in that time, even one that does not let itself be counted (0.2 ms
/// for one with vector instructions, half of it where it ends when it has found
/// what it looks for); a walk has 50 us for each.
inline constexpr int many_calls = 5000;
inline constexpr std::chrono::milliseconds large_mesh_cpu{250};

/// A matcher that normalises both sides and compares.
template <class List>
class ListMatcher : public CatchMatcherBase<List> {
public:
    using Normalise = List (*)(List);

    ListMatcher(List expected, Normalise normalise, std::string how)
        : expected_(std::move(expected)),
          normalise_(normalise),
          how_(std::move(how)) {}

    bool match(const List& got) const override {
        return normalise_(got) == normalise_(expected_);
    }
    std::string describe() const override {
        return how_ + ::Catch::Detail::stringify(expected_);
    }

private:
    List expected_;
    Normalise normalise_;
    std::string how_;
};

}  // namespace course

/// The numbers of `expected` in the same cyclic order, begun anywhere.
course::ListMatcher<std::vector<int>> IsRotationOf(std::vector<int> expected);

/// The numbers of `expected`, each as often, in any order.
course::ListMatcher<std::vector<int>> IsPermutationOf(
    std::vector<int> expected);

/// The loops of `expected` in any order, each begun anywhere.
course::ListMatcher<std::vector<std::vector<int>>> AreLoops(
    std::vector<std::vector<int>> expected);

// Hidden suite of greedy_strip. What is expected is found in the face list: the
// faces that have the last two vertices of the strip.
#include "exercises/05_structures/greedy_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/05_structures/structures_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Ends = std::array<int, 2>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// The strips of a mesh, by its face list alone.
class Strips {
public:
    explicit Strips(const Fixture& fixture) : fixture_(fixture) {
        for (int f = 0; f < fixture.mesh.faces.size(); ++f) {
            const auto face = fixture.mesh.faces[f];
            for (std::size_t k = 0; k < 3; ++k)
                faces_[sorted(face[k], face[(k + 1) % 3])].push_back(f);
        }
    }

    /// The strip from half-edge i on.
    std::vector<int> from(int i) const {
        const std::vector<HalfEdge>& rows = fixture_.he.rows();
        const int a = rows[at(i)].vi, b = rows[at(rows[at(i)].opp)].vi;
        std::vector<int> strip = {a, b};
        std::set<int> used;
        int f = first_face(a, b);
        if (f == -1) return {};
        while (f != -1) {
            used.insert(f);
            const int p = strip[strip.size() - 2], q = strip.back();
            for (const int v : fixture_.mesh.faces[f])
                if (v != p && v != q) strip.push_back(v);
            f = other_face(q, strip.back(), f);
            if (used.contains(f)) f = -1;
        }
        return strip;
    }

private:
    static Ends sorted(int a, int b) {
        return {std::min(a, b), std::max(a, b)};
    }

    /// The face that has b after a.
    int first_face(int a, int b) const {
        const auto found = faces_.find(sorted(a, b));
        if (found == faces_.end()) return -1;
        for (const int f : found->second) {
            const auto face = fixture_.mesh.faces[f];
            for (std::size_t k = 0; k < 3; ++k)
                if (face[k] == a && face[(k + 1) % 3] == b) return f;
        }
        return -1;
    }

    /// The face that has a and b, other than f.
    int other_face(int a, int b, int f) const {
        for (const int other : faces_.at(sorted(a, b)))
            if (other != f) return other;
        return -1;
    }

    const Fixture& fixture_;
    std::map<Ends, std::vector<int>> faces_;
};

bool has_border(const Fixture& fixture) {
    return std::any_of(fixture.he.rows().begin(), fixture.he.rows().end(),
                       [](const HalfEdge& row) { return row.fi == -1; });
}

/// Meshes made by hand whose faces are triangles, also with loose edges.
std::vector<Fixture> made_by_hand(bool with_border) {
    std::vector<Fixture> fixtures = hidden::made_by_hand();
    std::erase_if(fixtures, [&](const Fixture& fixture) {
        return has_border(fixture) != with_border ||
               !std::all_of(fixture.mesh.faces.begin(),
                            fixture.mesh.faces.end(),
                            [](auto face) { return face.size() == 3; });
    });
    return fixtures;
}

enum class Asked { along_faces, along_the_border, all };

void check(const Fixture& fixture, Asked asked) {
    const OnMesh on(fixture);
    const Strips expected(fixture);
    std::vector<int> starts = all_half_edges(fixture.he);
    std::erase_if(starts, [&](int i) {
        const bool border = fixture.he.rows()[at(i)].fi == -1;
        return asked == Asked::all ? false
                                   : border != (asked != Asked::along_faces);
    });
    const AskAhead ahead(fixture.he, starts);
    for (const int i : starts)
        REQUIRE(greedy_strip(fixture.he, i) == expected.from(i));
}

Fixture built(std::string name, const IndexedMesh& mesh, std::uint64_t salt) {
    return renumbered({std::move(name), mesh, build(mesh)}, salt);
}

/// A ring of 2 n triangles between an outer and an inner circle.
IndexedMesh ring(int n) {
    IndexedMesh mesh;
    for (int k = 0; k < 2 * n; ++k) {
        const double angle = 3.14159265358979 * k / n;
        const double radius = k % 2 == 0 ? 2 : 1.5;
        mesh.positions.push_back(
            {radius * std::cos(angle), radius * std::sin(angle), 0});
        const int a = k, b = (k + 1) % (2 * n), c = (k + 2) % (2 * n);
        if (k % 2 == 0)
            mesh.faces.push_back({a, c, b});
        else
            mesh.faces.push_back({a, b, c});
    }
    return mesh;
}

}  // namespace

TEST_CASE("closed meshes, from each half-edge", "[points:2]") {
    hint("Which triangles does the strip have already when it comes back?");
    for (const Fixture& fixture : made_by_hand(false))
        check(fixture, Asked::all);
    check(built("icosphere", icosphere(0), 1), Asked::all);
    check(built("torus", torus(6, 5, Cells::triangles), 2), Asked::all);
}

TEST_CASE("open meshes, from each half-edge along a face", "[points:2]") {
    hint(
        "On which side does the strip leave a triangle, and on which the "
        "next?");
    for (const Fixture& fixture : made_by_hand(true))
        check(fixture, Asked::along_faces);
    check(built("grid", grid(5, 4, Cells::triangles), 3), Asked::along_faces);
    check(built("ring", ring(7), 4), Asked::along_faces);
    check(built("small ring", ring(3), 5), Asked::along_faces);
}

TEST_CASE("half-edges without a face", "[points:1]") {
    hint("What is the first triangle of a half-edge that has no face?");
    for (const Fixture& fixture : made_by_hand(true)) {
        check(fixture, Asked::along_the_border);
        check(renumbered(fixture, 9), Asked::all);
    }
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    std::uint64_t salt = 10;
    for (const bool with_border : {false, true})
        for (const Fixture& fixture : made_by_hand(with_border))
            check(renumbered(fixture, salt++), Asked::all);
    for (const Fixture& fixture : hidden::generated_triangle_meshes())
        check(fixture, Asked::all);
    check(built("icosphere", icosphere(2), salt), Asked::all);
}

TEST_CASE("a few reads for each triangle of the strip", "[points:1][once]") {
    hint("How much of the table must you look at for a strip of n triangles?");
    for (const Fixture& fixture :
         {built("grid", grid(30, 30, Cells::triangles), 20),
          built("torus", torus(40, 7, Cells::triangles), 21),
          built("long ring", ring(700), 22)}) {
        const OnMesh on(fixture);
        const Strips expected(fixture);
        for (int i = 0; i < fixture.he.size(); i += fixture.he.size() / 40) {
            const std::vector<int> strip = expected.from(i);
            if (strip.empty()) continue;
            const int triangles = static_cast<int>(strip.size()) - 2;
            const ReadBudget budget(fixture.he, 20 * triangles + 20);
            REQUIRE(greedy_strip(fixture.he, i) == strip);
        }
    }
}

// What the suites of the operations on tables share: what a table says, however
// its half-edges are numbered; the meshes; and the operations by brute force on
// faces and borders as loops of vertices.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "course/mesh/zoo.h"
#include "course/runner/print.h"

namespace course::editing {

/// Vertices in cyclic order.
using Loop = std::vector<int>;

/// The faces by number and the borders, each loop from where it reads smallest;
/// borders in order. Two valid tables that say the same differ only in the
/// numbers of their half-edges.
struct Content {
    std::map<int, Loop> faces;
    std::vector<Loop> borders;

    friend bool operator==(const Content&, const Content&) = default;
};

/// The same loop from where it reads smallest.
Loop from_smallest(Loop loop);

/// Precondition: validate has no findings.
Content content_of(const HalfEdgeTable& he);

/// What is wrong with a table that comes from a submission, or "": a rule that
/// it breaks, or a face or border that it should not have, or should.
std::string difference(const HalfEdgeTable& got, const Content& expected);

/// The same for tables that have these faces as well, under any numbers that
/// are not in `expected`.
std::string difference(const HalfEdgeTable& got, const Content& expected,
                       std::vector<Loop> new_faces);

/// A table that says this, and has these new faces; what is wrong with another
/// one stands in the message.
class ContentMatcher : public CatchMatcherBase<HalfEdgeTable> {
public:
    ContentMatcher(Content expected, std::vector<Loop> new_faces)
        : expected_(std::move(expected)), new_faces_(std::move(new_faces)) {}

    bool match(const HalfEdgeTable& got) const override {
        why_ = difference(got, expected_, new_faces_);
        return why_.empty();
    }
    std::string describe() const override {
        return "is a table of what the contract asks for\n" + why_;
    }

private:
    Content expected_;
    std::vector<Loop> new_faces_;
    mutable std::string why_;
};

ContentMatcher Says(Content expected, std::vector<Loop> new_faces = {});

/// The first rule that the table breaks, or "".
std::string broken_rule(const HalfEdgeTable& he);

/// Sorts the borders and begins each loop anew.
Content in_order(Content content);

/// Start and tip of half-edge i.
std::pair<int, int> ends(const HalfEdgeTable& he, int i);

// ---- collapse

/// Vertex a becomes vertex b in all loops; a corner that follows itself is
/// dropped, and so is a face with fewer than three corners.
Content pulled_together(const Content& content, int a, int b);

/// Whether that leaves a surface: each edge with two sides and a face, borders
/// that do not meet, faces that come to no vertex twice, a vertex b that has
/// three edges (two on the border), and all other vertices in use.
bool may_be_pulled_together(const Content& content, int a, int b);

// ---- meshes

/// Whether the mesh is what the operations ask for: no loose edges, no two
/// edges with the same ends, borders that do not meet, faces that come to no
/// vertex twice.
bool is_surface(const Fixture& fixture);

/// Made by hand, some of them not of triangles only.
Fixture octahedron();     ///< closed, each edge may be collapsed
Fixture three_peaks();    ///< a ring of three between two apexes
Fixture hexagon_lid();    ///< a face that holds both ends of another edge
Fixture cut_square();     ///< two triangles that share an edge
Fixture tube_of_three();  ///< open at both ends, three edges round
Fixture neck();           ///< closed, with a neck of three edges
Fixture ribbon();         ///< a strip of triangles
Fixture one_quad();       ///< a single quad
Fixture open_tetra();     ///< a tetrahedron without one of its faces
Fixture ear();            ///< an interior vertex of two edges

/// These, and all meshes by hand that are surfaces.
std::vector<Fixture> surfaces();

/// A copy of each with half-edges, faces and vertices numbered anew.
std::vector<Fixture> renumbered_surfaces();

/// Random ones, closed, open and both, of triangles and of polygons.
std::vector<Fixture> generated_surfaces();

/// Those of `fixtures` that have triangles only.
std::vector<Fixture> of_triangles(std::vector<Fixture> fixtures);

/// The same mesh with face numbers 2, 5, 8 ... in the table.
Fixture with_gaps_in_faces(Fixture fixture);

/// A fixture from faces, and from positions.
Fixture made(std::string name, IndexedMesh mesh);

}  // namespace course::editing

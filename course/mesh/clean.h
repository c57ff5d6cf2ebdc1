// Cleaning: from a mesh that may have no half-edge table to one that has. Each
// step does one thing and says what it did.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// What a step did, and what else of a Change is given with it.
enum class ChangeKind {
    face_dropped,        ///< faces, and the defect for which they had to go
    face_cut,            ///< faces: one, which came to a vertex twice (defect),
                         ///< became `count` faces
    loose_edge_dropped,  ///< defect, which has its number
    faces_turned,        ///< faces: their corners now come the other way round
    twist_found,         ///< nothing was done: the proof that turning cannot
                         ///< help. From each of `faces` to the next, and from
                         ///< the last to the first, one comes across the edge
                         ///< of two of `vertices`, in sequence, which has these
                         ///< two faces only; an odd number of these edges are
                         ///< run along alike by both
    edge_split,          ///< vertices: the edge of `faces` became `count` edges
    vertex_split,        ///< vertices: {v, copy}; `faces` now use the copy
    hole_filled,         ///< vertices: the corners of the face that was added
    vertices_dropped,    ///< vertices: no face and no loose edge used them
};

/// One change. Numbers are those of the mesh that the function was given;
/// copies of vertices are numbered on from its last one.
struct Change {
    ChangeKind kind;
    std::vector<int> faces = {};
    std::vector<int> vertices = {};
    int count = -1;
    std::optional<Defect> defect = {};

    friend bool operator==(const Change&, const Change&) = default;
};

/// One line: `vertex 4: faces 2 and 3 take vertex 9, a copy of it, ...`. Of
/// long lists of faces or vertices the first ones only.
std::string to_string(const Change& change);

/// A line for each, of many only for the first ones, and how many there are.
std::string to_string(const std::vector<Change>& changes);

/// What a step makes of a mesh.
struct Cleaned {
    IndexedMesh mesh;
    std::vector<Change> changes;  ///< none: the mesh is as it was
    std::vector<int> face_of;     ///< for each face of `mesh` the face that it
                                  ///< was, or is a piece of; -1: it is new
};

// Of these steps each takes any mesh, and passes over what has defects that
// other steps are for. They keep the order of vertices, faces and loose edges.
// O(n log n) for n corners and loose edges, linear where that is said. They
// throw std::length_error where numbers would not fit into int.

/// Drops faces with fewer than three corners or with a corner that is no
/// vertex. One that comes to a vertex again is cut there into loops, of which
/// those with fewer than three corners are dropped: (1, 2, 3, 3) becomes (1, 2,
/// 3). What is degenerate by its positions only is left alone.
Cleaned drop_degenerate_faces(const IndexedMesh& mesh);

/// Of faces with the same corners in the same cyclic order keeps the first.
/// The mirror image is another face: two of them make a pillow.
Cleaned drop_duplicate_faces(const IndexedMesh& mesh);

/// Drops loose edges that end at no vertex or where they begin, and those where
/// there is an edge already.
Cleaned drop_bad_loose_edges(const IndexedMesh& mesh);

/// Turns faces over, so that neighbours are wound compatibly; in each part of
/// the mesh (faces joined by edges of just two faces) as few as possible. Where
/// that cannot be it says so with a proof, one for each such part, and turns
/// the faces so that only some edges are wrong.
Cleaned orient_faces(const IndexedMesh& mesh);

/// Gives each fan of faces a vertex of its own: a fan are the faces at a vertex
/// that one reaches from one another across edges with just two faces that run
/// along them in opposite directions. Afterwards no vertex is a bow-tie, and
/// two faces at most share an edge, never wound alike. Surfaces are cut no
/// further than that: what crosses a surface comes off it, and it stays closed.
/// (The cutting of Gueziec, Taubin, Lazarus and Horn, "Cutting and stitching",
/// IEEE TVCG 7 (2), 2001)
Cleaned split_non_manifold(const IndexedMesh& mesh);

/// Closes each border of at most `most_sides` edges with one polygon; borders
/// at a bow-tie are closed one by one. Whether a border is a hole or the rim of
/// an open surface only its length can tell. Linear, as `build`.
/// Throws BuildError where the faces have no half-edge table.
Cleaned fill_holes(const IndexedMesh& mesh,
                   int most_sides = std::numeric_limits<int>::max());

/// Drops vertices that no face and no loose edge uses. Linear.
Cleaned drop_unused_vertices(const IndexedMesh& mesh);

/// What `clean` does beside what a half-edge table needs.
struct CleanOptions {
    int most_sides = 0;  ///< of the holes that are filled
    bool drop_unused = false;
};

/// All steps above, in this order. The result has a half-edge table without
/// bow-ties, whatever the mesh was; one that had such a table already is as it
/// was, but for the options. Face numbers of all changes are those of `mesh`.
Cleaned clean(IndexedMesh mesh, const CleanOptions& options = {});

}  // namespace course

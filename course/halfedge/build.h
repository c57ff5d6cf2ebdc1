// From the indexed mesh to the half-edge table and back, and what may be wrong
// with the faces on the way.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// Why an indexed mesh has no half-edge table.
enum class DefectKind {
    too_few_corners,          ///< a face with fewer than three corners
    index_out_of_range,       ///< a corner that is no vertex of the mesh
    repeated_vertex,          ///< a face with two corners at one vertex
    edge_with_many_faces,     ///< an edge with three or more faces
    faces_wound_alike,        ///< the only two faces of an edge run along it in
                              ///< the same direction
    duplicate_face,           ///< faces with the same corners, same winding
    loose_edge_out_of_range,  ///< a loose edge that ends at no vertex
    loose_edge_equal_ends,    ///< a loose edge from a vertex to itself
    loose_edge_repeated,      ///< a loose edge where there is an edge already
};

/// One defect and the elements that take part in it. What a kind does not
/// speak of stays empty or -1.
struct Defect {
    DefectKind kind;
    std::vector<int> faces = {};     ///< ascending
    std::vector<int> vertices = {};  ///< an edge: both ends, in the direction
                                     ///< of its first face
    std::vector<int> loose_edges = {};  ///< this one, then the one it repeats
    int corner = -1;  ///< out of range: which corner of the face, or which
                      ///< end of the loose edge
    int count = -1;   ///< too_few_corners: how many corners the face has;
                      ///< out of range: how many vertices the mesh has

    friend bool operator==(const Defect&, const Defect&) = default;
};

/// One line: `edge 4-7 has 3 faces, 0, 2 and 5, but an edge has at most 2`.
std::string to_string(const Defect& defect);

/// Thrown by build: all defects of the mesh, what() has a line for each.
class BuildError : public std::invalid_argument {
public:
    explicit BuildError(std::vector<Defect> defects);
    const std::vector<Defect>& defects() const { return defects_; }

private:
    std::vector<Defect> defects_;
};

/// All defects: those of single faces by face, then those of edges by their
/// vertices, then duplicate faces, then loose edges by number. A face with a
/// defect of its own takes no part in the later checks. Empty when the mesh has
/// a table; a bow-tie is no defect, nor is a vertex that no face uses.
/// Throws std::length_error when the numbers would not fit into int.
/// As `build` when there is no defect, else O(n log n). (Lecture "half-edge",
/// slide 170: the structure "needs adaptation" for other meshes)
std::vector<Defect> defects(const IndexedMesh& mesh);

/// Vertices whose faces form more than one fan, ascending: where the mesh is
/// no surface although every edge is sound. Faces with a defect of their own
/// are passed over, loose edges too. Nearly linear (union-find).
/// Throws std::length_error as `defects`.
std::vector<int> bow_tie_vertices(const IndexedMesh& mesh);

/// Throws std::length_error when a mesh of that size could have more vertices,
/// faces or half-edges than int can number.
void require_countable(std::size_t vertices, std::size_t faces,
                       std::size_t corners, std::size_t loose_edges);

/// The half-edge table of the mesh: opposite half-edges side by side, in the
/// order in which the faces name the edges, loose edges last. Border half-edges
/// are there and follow each other against the sense of the faces. At a vertex
/// where several borders or loose edges meet (bow-tie), they are linked so that
/// one walk round the vertex passes through all of them. (Slide 170)
/// Throws BuildError with all defects; std::length_error as `defects`.
/// Linear, hubs of any degree included: sides are laid out by the smaller end
/// of their edge. Takes 16 bytes for each half-edge, and while it works 4 for
/// each side and 8 for each vertex.
HalfEdgeTable build(const IndexedMesh& mesh);

/// The faces in order of their numbers, each from any of its corners. Loose
/// edges are passed over. (Slide 170) Linear.
/// Throws std::invalid_argument when validate has findings, or when a face
/// number below the largest has no half-edge.
FaceList to_faces(const HalfEdgeTable& he);

/// {start, tip} of each edge with no face on either side, in table order.
/// Throws std::invalid_argument when validate has findings. Linear.
std::vector<std::array<int, 2>> loose_edges(const HalfEdgeTable& he);

/// The table with an edge that hangs, with no face, from the tip of `border`
/// to `new_vertex`: two half-edges are appended, from the tip and back to it.
/// (Slide 181)
/// Precondition: no half-edge leaves new_vertex. Throws std::invalid_argument
/// when `border` is no half-edge of a border, or new_vertex is negative.
HalfEdgeTable add_dangling_edge(const HalfEdgeTable& he, int border,
                                int new_vertex);

}  // namespace course

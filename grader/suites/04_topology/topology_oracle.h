// Facts about whole meshes, found in the face list by brute force: what the
// suites of chapter 4 compare with.
#pragma once

#include <vector>

#include "course/mesh/zoo.h"

namespace course::oracle {

/// Elements of the mesh, from its faces and loose edges; only the border loops
/// come from the table where the faces leave them open (see Border).
struct TopologyCounts {
    int vertices = 0, edges = 0, faces = 0, loops = 0;

    int euler() const { return vertices - edges + faces; }
};
TopologyCounts topology_counts(const Fixture& fixture);

/// Sides of faces: how many in all, and how many with no other side along the
/// same edge. Loose edges have none.
int side_count(const IndexedMesh& mesh);
bool every_edge_has_two_faces(const IndexedMesh& mesh);

/// How many entries the lists of a mesh have that stores all adjacencies; made
/// and looked through, one list after the other.
struct StoredLists {
    int faces_of_vertices = 0, edges_of_vertices = 0;
    int vertices_of_edges = 0, faces_of_edges = 0;
    int vertices_of_faces = 0, edges_of_faces = 0;

    int total() const {
        return faces_of_vertices + edges_of_vertices + vertices_of_edges +
               faces_of_edges + vertices_of_faces + edges_of_faces;
    }
};
StoredLists stored_lists(const IndexedMesh& mesh);

/// Parts of the graph of vertices and edges, isolated vertices left out.
int graph_parts(const IndexedMesh& mesh);

/// Whether no two sides run from the same vertex to the same vertex.
bool sides_agree(const IndexedMesh& mesh);

/// The same after the faces with a flag were turned over; false when there are
/// not as many flags as faces.
bool sides_agree_after(const IndexedMesh& mesh, const std::vector<bool>& flags);

/// Whether some choice of flags makes all sides agree: tries them all.
/// Precondition: at most 16 faces.
bool some_flags_agree(const IndexedMesh& mesh);

/// At most two sides at each edge, one fan at each vertex: by the definition,
/// vertex by vertex.
bool is_surface(const IndexedMesh& mesh);

}  // namespace course::oracle

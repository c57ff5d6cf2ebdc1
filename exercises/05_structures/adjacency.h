#pragma once

#include <array>
#include <vector>

#include "course/mesh/indexed_mesh.h"

/// What a vertex knows: the edges and the faces that meet there.
struct VertexLinks {
    std::vector<int> edges;
    std::vector<int> faces;

    friend bool operator==(const VertexLinks&, const VertexLinks&) = default;
};

/// What an edge knows: its two ends, and the faces that have it.
struct EdgeLinks {
    std::array<int, 2> vertices;
    std::vector<int> faces;

    friend bool operator==(const EdgeLinks&, const EdgeLinks&) = default;
};

/// What a face knows: its corners and its edges, round the face.
struct FaceLinks {
    std::vector<int> vertices;
    std::vector<int> edges;

    friend bool operator==(const FaceLinks&, const FaceLinks&) = default;
};

/// The whole mesh as a graph of its elements; each is known by its number.
struct Adjacency {
    std::vector<VertexLinks> vertices;
    std::vector<EdgeLinks> edges;
    std::vector<FaceLinks> faces;

    friend bool operator==(const Adjacency&, const Adjacency&) = default;
};

/// The explicit adjacency lists of a mesh.
///
/// Vertices and faces keep their numbers; there is an entry for each of them.
/// Each edge is listed once, however many faces have it: two corners that
/// follow each other in a face (the first follows the last), or a loose edge.
/// faces[f].vertices are the corners of face f as the mesh has them, from the
/// same first corner on. faces[f].edges is as long, and edge number i in it
/// joins corner i of the face with corner i + 1, the last one with the first.
/// Free: how edges are numbered, the order of the two ends of an edge, and the
/// order of edges and faces in the lists of vertices and of edges; each stands
/// there once.
/// An isolated vertex has two empty lists; a loose edge has no faces. A mesh
/// without vertices gives three empty lists.
/// Any number of faces may meet at an edge, wound in any way, and any number of
/// fans at a vertex: no half-edge table could hold such meshes.
/// Precondition: the corners of a face are three or more different vertices of
/// the mesh, the ends of a loose edge two; a loose edge is no side of a face,
/// and no loose edge is there twice.
/// Cost: O(n log n) for n sides of faces, loose edges and vertices.
/// Slide mesh: vertex 3 has two edges and the face 2; the edge between 1 and 2
/// has the faces 0 and 1; face 0 has the corners 0, 2, 1 and the edges between
/// 0 and 2, 2 and 1, 1 and 0. (Lecture "mesh formats", slides 11-13)
Adjacency adjacency(const IndexedMesh& mesh);

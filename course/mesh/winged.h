// The winged-edge structure (Baumgart, 1975): one record for each edge, with
// the faces on its two sides and the edges that go on from its two ends. The
// lecture's pointers are numbers here, as in the half-edge table. (Lecture
// "modelling")
#pragma once

#include <compare>
#include <vector>

/// An edge with its eight references. It is stored in one of its two
/// directions, from `from` to `to`; left and right are as seen that way.
///
///      to_left  \       / to_right        left side: from_left, then this
///                \     /                  edge forwards, then to_left
///                  to
///                   ^                     right side: to_right, then this
///         left      |      right          edge backwards, then from_right
///                   |
///                 from
///                /     \.
///     from_left /       \ from_right
///
/// The left face has `to` after `from`, counter-clockwise; the right face has
/// `from` after `to`. A side without a face, where `left` or `right` is -1, has
/// its two neighbours too: those along the border. So the four neighbours are
/// always edges; at the end of a loose edge where there is no other edge, it is
/// its own neighbour on both sides.
struct WingedEdge {
    int from = -1;        ///< the vertex that it is stored as leaving
    int to = -1;          ///< the vertex at its other end
    int left = -1;        ///< the face on its left; -1 when there is none
    int right = -1;       ///< the face on its right; -1 when there is none
    int from_left = -1;   ///< the edge before it on the left, at `from`
    int from_right = -1;  ///< the edge after it on the right, at `from`
    int to_left = -1;     ///< the edge after it on the left, at `to`
    int to_right = -1;    ///< the edge before it on the right, at `to`

    friend bool operator==(const WingedEdge&, const WingedEdge&) = default;
};

/// A mesh as winged edges. Edges may be numbered in any order, and each may be
/// stored in either direction: a face may have some of its edges with itself
/// on their left and the others with itself on their right.
struct WingedMesh {
    std::vector<WingedEdge> edges;
    std::vector<int> vertex;  ///< vertex[v]: any one edge at v; -1 if none is
    std::vector<int> face;    ///< face[f]: any one edge of f; -1 if none is

    friend bool operator==(const WingedMesh&, const WingedMesh&) = default;
};

/// One direction of an edge: what is a half-edge in the other structure.
struct DirectedEdge {
    int edge = -1;        ///< its number in WingedMesh::edges
    bool forward = true;  ///< from `from` to `to`, along the left side; else
                          ///< from `to` to `from`, along the right side

    friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

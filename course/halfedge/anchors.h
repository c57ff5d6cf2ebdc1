// Where a walk may begin: one half-edge for each vertex and each face.
#pragma once

#include <vector>

/// What stands beside the table to reach it from a vertex or a face. Which of
/// the half-edges it is, is left open. (Lecture "half-edge", slide 166)
struct Anchors {
    /// vertex[v]: any one half-edge that leaves vertex v; -1 when none does.
    std::vector<int> vertex;
    /// face[f]: any one half-edge that runs along face f.
    std::vector<int> face;
};

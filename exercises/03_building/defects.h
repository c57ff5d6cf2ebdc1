#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "course/mesh/mesh_fault.h"

/// One defect.
struct MeshDefect {
    MeshFault fault = MeshFault::too_few_corners;
    std::vector<int> elements;

    friend bool operator==(const MeshDefect&, const MeshDefect&) = default;
};

/// All defects of the faces, each once; empty for a sound mesh, and for one
/// without faces.
///
/// The first three kinds are those of a face by itself. A face may have several
/// of them, and all are reported; such a face takes no part in the other four,
/// which are about the sound faces only. Nothing else keeps a defect from being
/// reported: two equal triangles are duplicate_faces, and wound_alike at each
/// of their edges that no third face has.
/// Free: the order of the defects. Fixed: the order of the elements in each.
/// Border cases: for several_fans it does not matter how many faces an edge
/// has, or how they are wound. Loose edges and vertices that no face uses are
/// not looked at. All but several_fans are what keeps a mesh from having a
/// half-edge table; a mesh with such a vertex (bow-tie) has one (exercise 3.3,
/// build), though it is no surface there.
/// Precondition: none; faces may hold any numbers.
/// Cost: n log n for n corners, as long as few faces meet at a vertex.
/// Slide mesh: no defect. Three triangles at one edge, {0,1,2} {1,0,3} {0,1,4}:
/// {{MeshFault::too_many_faces, {0, 1, 0, 1, 2}}}. (Lecture "half-edge", slide
/// 170)
std::vector<MeshDefect> defects(const IndexedMesh& mesh);

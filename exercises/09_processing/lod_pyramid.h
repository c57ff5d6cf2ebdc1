#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "exercises/09_processing/simplify.h"

/// A mesh of the pyramid, and from which distance on it may stand in for the
/// finest one.
struct LevelOfDetail {
    HalfEdgeTable he;
    double from = 0;

    friend bool operator==(const LevelOfDetail&,
                           const LevelOfDetail&) = default;
};

/// The levels of detail of a mesh, from the finest to the coarsest, `levels` of
/// them at most. Level 0 is the mesh itself. Each further level is
/// simplify(h, positions, n / 2), where h is the table of the level before it,
/// and n the number of its faces (halves are rounded down). The pyramid ends
/// earlier, before a level that would have as many faces as the one before it.
///
/// `from` of a level is the mean length of its edges, each counted once,
/// divided by the mean length of the edges of level 0: seen from `from` times
/// as far, they look as long as those of level 0 do from distance 1. It is 1
/// for level 0.
///
/// All levels share the positions. Vertices and faces keep their numbers.
/// Free: how the half-edges of each table are numbered.
/// Precondition: that of simplify, which you may call: in grading, it is a
/// right one. If the mesh has edges, their mean length is above 0.
/// Errors: std::invalid_argument when `levels` is below 1, and, where there is
/// a level 1 to be made, when a vertex has no position.
/// Cost: that of simplify, for each level.
/// Slide mesh, with its positions: lod_pyramid(he, positions, 9) has two
/// levels: of three faces, and of one, F0 = (0,2,1) with the edges 2, sqrt(2)
/// and sqrt(2) long. For the next level simplify is asked for no face, but
/// F0 stays.
/// (Lecture "mesh processing": level of detail pyramid)
std::vector<LevelOfDetail> lod_pyramid(const HalfEdgeTable& he,
                                       std::span<const Vec3> positions,
                                       int levels);

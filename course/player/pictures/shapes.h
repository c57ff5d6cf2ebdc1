// The meshes of the pictures on processing: small enough that each face can be
// seen, and of shapes that everybody knows.
#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "course/player/json.h"

namespace course {

/// A pawn of chess, about 2.3 high: closed, 480 triangles wound outwards, with
/// a flat foot, a thin neck, and a ball.
IndexedMesh pawn();

/// A building brick of 2 x 2 x 0.4 with one round stud on it: closed, 320
/// triangles wound outwards, most of them where it is flat.
IndexedMesh brick();

/// The unit sphere of 162 vertices as a scanner might see it: each vertex
/// nearer or farther by up to 15 %. Always the same one.
IndexedMesh noisy_sphere();

/// How the three sides of a box's corner are cut into triangles.
enum class Cut { first, second };

/// Three sides of a box of 3 x 2 x 1 that meet at vertex 0, the corner at
/// (3, 2, 1), wound outwards. At that corner, the first cut has four triangles
/// on the smallest side, two on the top, and one on the other; the second one
/// on the top, and two on each of the others.
IndexedMesh box_corner(Cut cut);

/// What a page draws: {"points", "faces"}, to three digits behind the point.
Json mesh_json(const IndexedMesh& mesh);
Json points_json(const std::vector<Vec3>& points);

/// The faces of a table whose faces may be numbered with gaps, as after
/// collapses. Precondition: the table is valid.
FaceList faces_left(const HalfEdgeTable& he);

}  // namespace course

// Meshes for the suites of chapter 3: face lists for which there may or may not
// be a table, and the same ones put down in another way.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "course/mesh/zoo.h"

namespace course::hidden {

/// Vertices 0 <= v < vertices on a circle, and these faces; without a table.
Fixture of_faces(std::string name, int vertices,
                 std::initializer_list<std::initializer_list<int>> faces);
Fixture of_mesh(std::string name, IndexedMesh mesh);

/// The same mesh: faces and loose edges in another order, each begun at another
/// corner, vertices numbered anew with a gap here and there. Without a table.
Fixture put_in_another_order(const Fixture& fixture, std::uint64_t salt);

/// All corners of these faces the other way round; without a table.
Fixture with_faces_reversed(const Fixture& fixture,
                            const std::vector<int>& faces);

/// All meshes beside each other, with no vertex in common; without a table.
Fixture beside_each_other(const std::vector<Fixture>& parts);

/// Two cones over one ring of `sides` vertices: every face at an apex, vertices
/// 0 and 1. Closed, 2 * sides triangles, sides >= 3.
Fixture double_cone(int sides);

/// Fixtures of the zoo and of hidden meshes by what they are. Faces have at
/// least three corners, at different vertices.
std::vector<Fixture> closed_meshes();
std::vector<Fixture> open_meshes_with_table();
std::vector<Fixture> with_loose_edges();

/// Generated meshes, with bow-ties and unused vertices among them.
std::vector<Fixture> generated_closed();
std::vector<Fixture> generated_open();

}  // namespace course::hidden

// The hidden meshes of chapter 4: surfaces of known genus, bands with and
// without a twist, and meshes with a defect that is made on purpose.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "course/mesh/zoo.h"

namespace course::hidden {

/// With its table; and without one, for meshes that have none.
Fixture with_table_built(std::string name, IndexedMesh mesh);
Fixture face_list_only(std::string name, IndexedMesh mesh);

/// The meshes side by side, with no vertex in common.
IndexedMesh side_by_side(const std::vector<IndexedMesh>& parts);

/// One closed surface: `genus` tori in a row, each glued to the next along a
/// quad; for genus 0 a sphere. `holes` of its faces are taken out, no two of
/// which touch. Precondition: 0 <= holes <= 4.
IndexedMesh surface_of_genus(int genus, int holes);

/// `quads` quads in a ring, at least three of them. Two border loops; with a
/// twist (a Moebius band) one.
IndexedMesh straight_band(int quads);
IndexedMesh twisted_band(int quads);

/// `triangles` triangles in a row, each glued to the one before.
IndexedMesh triangle_strip(int triangles);

/// An octahedron with every other face taken out: four border loops, each of
/// which meets the others in all its vertices.
Fixture checkered_octahedron();

/// The fixture with these faces turned over; without a table.
Fixture flipped(const Fixture& fixture, const std::vector<int>& faces);

/// The same faces in another order, each begun at another corner, vertices
/// numbered anew with a gap here and there; without a table.
Fixture shuffled(const Fixture& fixture, std::uint64_t salt);

/// Vertices `from` and `to` become one, under the number of `to`; without a
/// table.
Fixture merged(const Fixture& fixture, int from, int to);

/// All faces that have at least three corners at different vertices stay; loose
/// edges go. Without a table.
Fixture sound_faces(const Fixture& fixture);

/// The zoo, with a table or without, and the hidden meshes, of each only the
/// faces that have no corner twice.
std::vector<Fixture> all_face_lists();

/// A table with the same half-edges; vertex and face numbers with gaps.
HalfEdgeTable with_gaps(const HalfEdgeTable& he);

/// Numbers below n, each once, in an order that comes from the seed.
std::vector<int> any_order(int n, std::uint64_t salt);

}  // namespace course::hidden

// Small meshes for the hidden suites only: what no mesh of the zoo has, and
// what therefore lets a mistake through that the zoo does not see.
#pragma once

#include <vector>

#include "course/mesh/zoo.h"

/// Fixtures by name. Each call makes a new one.
namespace course::hidden {

Fixture twelve_gon();         ///< one face of twelve sides
Fixture prism();              ///< closed, two hexagons and six quads
Fixture bipyramid();          ///< closed, two vertices of nine edges
Fixture ring_of_two();        ///< two faces share two edges that do not meet
Fixture ring_closed();        ///< the same, one more face inside, one outside
Fixture gaps();               ///< vertex numbers that no face uses
Fixture open_then_closed();   ///< two components, the open one first
Fixture closed_then_open();   ///< two components, the closed one first
Fixture two_tori();           ///< two components of genus 1
Fixture spur();               ///< a face on both sides of an edge
Fixture keyhole();            ///< as spur, round a second face
Fixture pinched_sphere();     ///< closed; a face that meets a vertex twice
Fixture loose_edge_after();   ///< a component that is one loose edge
Fixture loose_edge_before();  ///< the same, numbered before the face
Fixture loose_chain();        ///< two loose edges in a row
Fixture loose_pair();         ///< two loose edges at one vertex
Fixture thorn();              ///< a loose edge at one of two border loops
Fixture bridge();             ///< a loose edge that joins two triangles
Fixture pinwheel_in_turn();   ///< three triangles at a vertex, one border loop
Fixture pinwheel_across();    ///< the same, linked in the other order
Fixture pinwheel_split();     ///< the same, two linked and one apart

/// All fixtures above, in this order.
std::vector<Fixture> all();

/// Every fixture of the zoo that has a table, and all of the above.
std::vector<Fixture> made_by_hand();

/// A copy of each of them with half-edges, faces and vertices numbered anew.
std::vector<Fixture> renumbered_copies();

/// The half-edge that runs from vertex `from` to vertex `to`.
/// Throws std::logic_error when there is none.
int half_edge(const Fixture& fixture, int from, int to);

}  // namespace course::hidden

// The mesh zoo: small meshes that tell a right walk from a wrong one. Each is
// made by hand, with picture, counts and Euler characteristic in the source.
#pragma once

#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// A mesh with a name that students read, and its half-edge table.
struct Fixture {
    std::string name;
    IndexedMesh mesh;
    HalfEdgeTable he;  ///< empty where the mesh has none (non-manifold ones)
};

}  // namespace course

/// Fixtures by name, as in the catalogue. Each call makes a new one.
namespace course::zoo {

Fixture slide();             ///< the worked table of the slides, row by row
Fixture triangle();          ///< the smallest mesh with a border
Fixture tetra();             ///< closed, four triangles
Fixture cube();              ///< closed, six quads
Fixture house();             ///< closed, quads and triangles
Fixture annulus();           ///< three quads in a ring: two border loops
Fixture moebius3q();         ///< three quads with a twist: no table
Fixture moebius5();          ///< five triangles with a twist: no table
Fixture torus7();            ///< seven vertices, genus 1
Fixture klein4x4();          ///< closed, non-orientable: no table
Fixture rp2_6();             ///< closed, non-orientable: no table
Fixture pillow();            ///< two triangles glued along all three edges
Fixture lens();              ///< two quads that share two edges
Fixture fan6();              ///< six triangles round an interior vertex
Fixture two_triangles();     ///< two components
Fixture dangling();          ///< slide with a loose edge from 4 to 6
Fixture bow_tie_crossed();   ///< two triangles at a vertex, one border loop
Fixture bow_tie_separate();  ///< two triangles at a vertex, two border loops
Fixture hourglass();         ///< two tetrahedra at a vertex
Fixture fan3();              ///< three triangles on an edge: no table
Fixture house_with_wall();   ///< four non-manifold edges: no table

/// All fixtures above that have a table, in this order.
std::vector<Fixture> with_table();

}  // namespace course::zoo

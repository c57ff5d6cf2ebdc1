#pragma once

#include <span>
#include <stdexcept>

#include "course/mesh/indexed_mesh.h"
#include "course/mesh/soup.h"

/// The indexed mesh of a triangle soup: corners at one point, or nearly, become
/// one vertex.
///
/// The corners are taken in order: those of triangle 0, then those of triangle
/// 1, and so on. A corner that lies at a distance of at most `eps` from a
/// vertex that is there already becomes that vertex: the one with the smallest
/// number, if there are several, even if another one is nearer. Else it
/// becomes a new vertex, with the next number. So vertices are numbered in the
/// order of their first use, a vertex lies where its first corner lies and
/// never moves, and corners are compared with vertices, not with each other.
/// Distances are Euclidean, in the unit of the coordinates. With eps == 0, only
/// corners with equal coordinates are joined; 0.0 equals -0.0.
/// Faces: face k is triangle k, its corners in the same order; also where
/// corners of one triangle become the same vertex, or two triangles the same
/// face. loose_edges is empty. An empty soup gives an empty mesh.
/// Precondition: the coordinates are finite.
/// Errors: std::invalid_argument when eps is negative or not a number (NaN).
/// Cost: each corner may be compared with each vertex.
/// Example: the triangles (0,0,0) (1,0,0) (0,1,0) and (0,1,0) (1,0,0) (1,1,0)
/// give with eps = 0 the four positions (0,0,0) (1,0,0) (0,1,0) (1,1,0) and
/// the faces (0,1,2) (2,1,3). (Lecture "modelling")
IndexedMesh weld(std::span<const SoupTriangle> soup, double eps);

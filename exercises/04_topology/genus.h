#pragma once

#include "course/halfedge/half_edge_table.h"
#include "exercises/04_topology/components.h"
#include "exercises/04_topology/counts.h"
#include "exercises/04_topology/euler.h"

/// The genus of the mesh: how many handles its surface has, the holes that one
/// could put a finger through. A sphere and a disk have 0, a torus has 1. For
/// several components it is the sum of theirs.
///
/// It is the G that solves V - L + F = 2 (S - G) - B, with L edges, S
/// components and B border loops, as `counts` and `components` count them. A
/// border loop is no handle: an annulus has genus 0. Border cases: 0 for an
/// empty table, and for a loose edge that hangs on nothing. A loose edge on a
/// border changes nothing; where one joins two loops of one component, it is
/// the formula that decides. Precondition: the table is valid, and every vertex
/// has one fan: the walk round it (by opp, then next) meets all half-edges that
/// leave it. Cost: a fixed number of reads for each half-edge. Builds on
/// exercises 4.1, 4.2 and 4.3: you may call counts, components and euler, which
/// in grading are the course's own. Slide mesh: genus(he) == 0, from 6 - 8 + 3
/// = 2 (1 - G) - 1. (Lecture "modelling"; lecture "mesh memory formats", pages
/// 14-15)
int genus(const HalfEdgeTable& he);

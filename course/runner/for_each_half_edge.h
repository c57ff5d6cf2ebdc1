// The loop that suites of walks have in common.
#pragma once

#include "course/runner/by_faces.h"
#include "course/runner/suite.h"

namespace course {

/// Calls check(he, i, expected) for each half-edge i of the mesh. Each check is
/// about one function f(he, i), or about none.
template <class Check>
void for_each_half_edge(const Fixture& mesh, Check check) {
    const oracle::ByFaces expected(mesh);
    const AskAhead ahead(mesh.he, all_half_edges(mesh.he));
    for (int i = 0; i < mesh.he.size(); ++i) check(mesh.he, i, expected);
}

/// The same for each of generated_fixtures(), as on_generated_meshes.
template <class Check>
void for_each_generated_half_edge(Check check) {
    on_generated_meshes(generated_fixtures(), [&](const Fixture& mesh) {
        for_each_half_edge(mesh, check);
    });
}

}  // namespace course

// Which meshes a library takes at all.
#include "course/bench/accepted.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <vector>

#include "course/bench/peers.h"
#include "course/halfedge/build.h"
#include "course/mesh/clean.h"
#include "course/tests/halfedge_random.h"

namespace bench {

namespace {

using course::Random;

IndexedMesh with_bow_tie(Random& random) {
    for (;;) {
        IndexedMesh mesh = course::random_sound_mesh(random);
        mesh.loose_edges.clear();
        if (!course::bow_tie_vertices(mesh).empty()) return mesh;
    }
}

IndexedMesh cleaned(Random& random) {
    IndexedMesh mesh = course::clean(course::random_soup(random)).mesh;
    mesh.loose_edges.clear();
    return mesh;
}

bool accepts(const Peer& peer, const IndexedMesh& mesh) {
    try {
        keep(peer.build(mesh).get());
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

void count(const char* what, int meshes, IndexedMesh (*next)(Random&)) {
    Random random(1);
    std::vector<IndexedMesh> all;
    for (int k = 0; k < meshes; ++k) all.push_back(next(random));
    fmt::print("{} {}: all faces taken of\n", meshes, what);
    for (const Peer& peer : peers()) {
        if (!peer.build || std::string_view(peer.name) == "bytes") continue;
        int taken = 0;
        for (const IndexedMesh& mesh : all) taken += accepts(peer, mesh);
        fmt::print("  {:<10} {}\n", peer.name, taken);
    }
}

}  // namespace

void count_accepted(int meshes) {
    count("meshes with bow-ties", meshes, with_bow_tie);
    count("meshes with flaws, cleaned", meshes, cleaned);
}

}  // namespace bench

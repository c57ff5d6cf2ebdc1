#include "course/player/pictures/simplification_picture.h"

#include <algorithm>
#include <map>

#include "course/halfedge/build.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/pictures/shapes.h"
#include "course/player/reference.h"
#include "exercises/09_processing/cluster.h"
#include "exercises/09_processing/hausdorff.h"
#include "exercises/09_processing/simplify_quadric.h"

namespace course {

namespace {

std::vector<std::array<int, 3>> bad_edges_of(const FaceList& faces) {
    std::map<std::pair<int, int>, int> count;
    for (const FaceList::Face face : faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            ++count[std::minmax(face[k], face[(k + 1) % face.size()])];
    std::vector<std::array<int, 3>> bad;
    for (const auto& [edge, n] : count)
        if (n > 2) bad.push_back({edge.first, edge.second, n});
    return bad;
}

Json simpler_json(const Simpler& simpler) {
    std::vector<Json> bad;
    for (const auto& [from, to, n] : simpler.bad_edges)
        bad.push_back(Json::array({from, to, n}));
    return Json::object({{"mesh", mesh_json(simpler.mesh)},
                         {"error", simpler.error},
                         {"bad_edges", bad}});
}

}  // namespace

std::vector<TwoWays> simplified(const IndexedMesh& mesh,
                                const std::vector<double>& cells) {
    const Reference<decltype(cluster)> clustering("cluster");
    const Reference<decltype(simplify_quadric)> collapses("simplify_quadric");
    const Reference<decltype(hausdorff)> distance("hausdorff");
    const auto judged = [&](const IndexedMesh& simple) {
        return Simpler{simple, distance(mesh, simple),
                       bad_edges_of(simple.faces)};
    };
    HalfEdgeTable he = build(mesh);
    std::vector<TwoWays> ways;
    for (const double cell : cells) {
        const IndexedMesh clustered = clustering(mesh, cell);
        // From the start each time: planes of the original count.
        const HalfEdgeTable left =
            collapses(he, mesh.positions, clustered.faces.size());
        ways.push_back({cell, judged(clustered),
                        judged({mesh.positions, faces_left(left), {}})});
    }
    return ways;
}

std::string simplification_picture() {
    const IndexedMesh mesh = brick();
    std::vector<Json> ways;
    for (const TwoWays& two : simplified(mesh, {0.25, 0.35, 0.5, 0.7}))
        ways.push_back(
            Json::object({{"cell", two.cell},
                          {"clustered", simpler_json(two.clustered)},
                          {"collapsed", simpler_json(two.collapsed)}}));
    return Json::object({{"mesh", mesh_json(mesh)}, {"ways", ways}}).text();
}

}  // namespace course

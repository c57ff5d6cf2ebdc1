// The meshes that are measured.
#include "course/bench/meshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "course/mesh/generators.h"
#include "course/mesh/mesh_file.h"

namespace bench {

namespace {

std::vector<int> random_order(std::size_t n, std::mt19937& random) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    return order;
}

/// Hills, with six digits after the point as files have them.
IndexedMesh with_hills(IndexedMesh mesh) {
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
    for (Vec3& p : mesh.positions)
        p = {rounded(p.x * 0.01), rounded(p.y * 0.01),
             rounded(p.z + std::sin(p.x * 0.1) * std::cos(p.y * 0.1))};
    return mesh;
}

}  // namespace

IndexedMesh shuffled(const IndexedMesh& mesh) {
    std::mt19937 random(7);
    const std::vector<int> place = random_order(mesh.positions.size(), random);
    IndexedMesh result;
    result.positions.resize(mesh.positions.size());
    for (std::size_t v = 0; v < place.size(); ++v)
        result.positions[static_cast<std::size_t>(place[v])] =
            mesh.positions[v];
    result.faces.reserve(static_cast<std::size_t>(mesh.faces.size()),
                         mesh.faces.corners().size());
    std::vector<int> corners;
    for (const int f :
         random_order(static_cast<std::size_t>(mesh.faces.size()), random)) {
        corners.clear();
        for (const int v : mesh.faces[f])
            corners.push_back(place[static_cast<std::size_t>(v)]);
        result.faces.push_back(corners);
    }
    return result;
}

std::vector<std::string> made_meshes() {
    return {"triangles_1M", "shuffled_1M", "quads_1M", "triangles_4M"};
}

Case made_mesh(const std::string& name, bool quick) {
    using course::Cells;
    const int side = quick ? 100 : 1000;
    if (name == "triangles_1M")
        return {name,
                with_hills(course::grid(side, side / 2, Cells::triangles))};
    if (name == "shuffled_1M")
        return {name, shuffled(with_hills(
                          course::grid(side, side / 2, Cells::triangles)))};
    if (name == "quads_1M") return {name, with_hills(course::grid(side, side))};
    return {name, with_hills(course::torus(2 * side, side, Cells::triangles))};
}

Case mesh_of_file(const std::filesystem::path& file) {
    return {file.stem().string(), course::read_mesh(file)};
}

}  // namespace bench

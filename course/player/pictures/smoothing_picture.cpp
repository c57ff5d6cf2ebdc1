#include "course/player/pictures/smoothing_picture.h"

#include <cmath>

#include "course/halfedge/build.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/pictures/shapes.h"
#include "course/player/reference.h"
#include "exercises/06_geometry/signed_volume.h"
#include "exercises/09_processing/smooth.h"

namespace course {

namespace {

double bumps_of(const std::vector<Vec3>& positions) {
    double sum = 0, squares = 0;
    for (const Vec3& p : positions) {
        sum += length(p);
        squares += dot(p, p);
    }
    const double n = static_cast<double>(positions.size());
    const double mean = sum / n;
    return std::sqrt(squares / n - mean * mean) / mean;
}

constexpr int pairs_shown = 8;
constexpr double laplace = 0.5;
constexpr double outwards = -0.53;

Json steps_json(const std::vector<Smoothed>& steps) {
    std::vector<Json> list;
    for (const Smoothed& step : steps)
        list.push_back(Json::object({{"points", points_json(step.positions)},
                                     {"volume", step.volume},
                                     {"bumps", step.bumps}}));
    return list;
}

}  // namespace

std::vector<Smoothed> smoothed_ball(int pairs, double first, double second) {
    const Reference<decltype(smooth)> smooth_once("smooth");
    const Reference<decltype(signed_volume)> volume_of("signed_volume");
    IndexedMesh mesh = noisy_sphere();
    const HalfEdgeTable he = build(mesh);
    std::vector<Smoothed> steps;
    for (int k = 0;; ++k) {
        steps.push_back(
            {mesh.positions, volume_of(mesh), bumps_of(mesh.positions)});
        if (k == 2 * pairs) return steps;
        mesh.positions =
            smooth_once(he, mesh.positions, 1, k % 2 == 0 ? first : second);
    }
}

std::string smoothing_picture() {
    return Json::object(
               {{"mesh", mesh_json(noisy_sphere())},
                {"weights", Json::array({laplace, outwards})},
                {"laplace",
                 steps_json(smoothed_ball(pairs_shown, laplace, laplace))},
                {"taubin",
                 steps_json(smoothed_ball(pairs_shown, laplace, outwards))}})
        .text();
}

}  // namespace course

// After the last meridian comes the first one of the next circle.
// Hint: Your vertices are right. Your triangles are not, and those at the
// poles are among the wrong or missing ones.
#include "exercises/08_making/uv_sphere.h"

#include <cmath>
#include <numbers>

namespace {

Vec3 crossing(int i, int nu, int j, int nv) {
    double a = std::numbers::pi * j / nv;
    double b = 2 * std::numbers::pi * i / nu;
    return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

}  // namespace

IndexedMesh uv_sphere(int nu, int nv) {
    if (nu < 3 || nv < 2)
        throw std::invalid_argument(
            "a sphere has three meridians and two bands at least");
    IndexedMesh mesh;
    mesh.positions.push_back({0, 0, 1});
    for (int j = 1; j < nv; ++j)
        for (int i = 0; i < nu; ++i)
            mesh.positions.push_back(crossing(i, nu, j, nv));
    mesh.positions.push_back({0, 0, -1});

    int north = 0, south = mesh.vertex_count() - 1;
    auto vertex = [&](int i, int j) { return 1 + (j - 1) * nu + i; };
    for (int i = 0; i < nu; ++i) {
        mesh.faces.push_back({north, vertex(i, 1), vertex(i + 1, 1)});
        for (int j = 1; j + 1 < nv; ++j) {
            int a = vertex(i, j), b = vertex(i, j + 1);
            int c = vertex(i + 1, j + 1), d = vertex(i + 1, j);
            mesh.faces.push_back({a, b, c});
            mesh.faces.push_back({a, c, d});
        }
        mesh.faces.push_back({south, vertex(i + 1, nv - 1), vertex(i, nv - 1)});
    }
    return mesh;
}

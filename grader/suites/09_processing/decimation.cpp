#include "grader/suites/09_processing/decimation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"

namespace course::decimation {

namespace {

/// The next of a sequence of well-mixed numbers. (splitmix64)
std::uint64_t next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

double squared_length(const std::vector<Vec3>& positions, int a, int b) {
    const Vec3 d = positions.at(std::size_t(b)) - positions.at(std::size_t(a));
    return dot(d, d);
}

}  // namespace

Fixture scattered(Fixture fixture, std::uint64_t salt, int range) {
    std::uint64_t state = seed() * 1000 + salt;
    const auto coordinate = [&] {
        return double(next(state) % std::uint64_t(range));
    };
    for (Vec3& p : fixture.mesh.positions)
        p = {coordinate(), coordinate(), coordinate()};
    fixture.name += ", scattered";
    return fixture;
}

std::vector<Fixture> scattered(const std::vector<Fixture>& fixtures,
                               int range) {
    std::vector<Fixture> all;
    for (const Fixture& fixture : fixtures)
        all.push_back(scattered(fixture, all.size(), range));
    return all;
}

std::vector<std::pair<int, int>> edges(const Content& content) {
    std::set<std::pair<int, int>> all;
    for (const auto& [f, loop] : content.faces)
        for (std::size_t k = 0; k < loop.size(); ++k)
            all.insert(std::minmax(loop[k], loop[(k + 1) % loop.size()]));
    return {all.begin(), all.end()};
}

bool on_border(const Content& content, int v) {
    return std::any_of(
        content.borders.begin(), content.borders.end(), [&](const auto& loop) {
            return std::find(loop.begin(), loop.end(), v) != loop.end();
        });
}

int face_count(const Content& content) {
    return static_cast<int>(content.faces.size());
}

std::optional<Pull> shortest(const Content& content,
                             const std::vector<Vec3>& positions) {
    std::vector<std::tuple<double, int, int>> in_order;
    for (const auto& [a, b] : edges(content))
        in_order.emplace_back(squared_length(positions, a, b), a, b);
    std::sort(in_order.begin(), in_order.end());
    for (const auto& [length, a, b] : in_order) {
        if (!editing::may_be_pulled_together(content, a, b)) continue;
        if (on_border(content, b) && !on_border(content, a)) return Pull{a, b};
        return Pull{b, a};
    }
    return std::nullopt;
}

Content simplified(Content content, const std::vector<Vec3>& positions,
                   int faces) {
    while (face_count(content) > faces) {
        const std::optional<Pull> pull = shortest(content, positions);
        if (!pull) break;
        content = editing::pulled_together(content, pull->gone, pull->kept);
    }
    return content;
}

Fixture rounded(Fixture fixture, std::uint64_t salt, int jitter) {
    std::uint64_t state = seed() * 1000 + salt;
    const auto moved = [&](double x) {
        const auto by = next(state) % std::uint64_t(2 * jitter + 1);
        return std::round(24 * x) + double(by) - jitter;
    };
    for (Vec3& p : fixture.mesh.positions)
        p = {moved(p.x), moved(p.y), moved(p.z)};
    fixture.name += ", whole coordinates";
    return fixture;
}

Fixture terrain(int nx, int ny, std::uint64_t salt, int rough) {
    std::uint64_t state = seed() * 1000 + salt;
    Fixture fixture = editing::made("terrain", grid(nx, ny, Cells::triangles));
    for (Vec3& p : fixture.mesh.positions)
        p = {4 * p.x, 4 * p.y, double(next(state) % std::uint64_t(rough + 1))};
    return fixture;
}

namespace {

using Lattice = std::array<int, 3>;

/// Numbers the points of a lattice in the order in which they are asked for.
class LatticeVertices {
public:
    int operator()(Lattice at) {
        const auto [entry, is_new] = numbers_.emplace(at, numbers_.size());
        if (is_new)
            positions_.push_back({double(at[0]), double(at[1]), double(at[2])});
        return static_cast<int>(entry->second);
    }
    std::vector<Vec3> positions() const { return positions_; }

private:
    std::map<Lattice, std::size_t> numbers_;
    std::vector<Vec3> positions_;
};

/// The square whose first corner is (u, v) on one of the two sides of the cube
/// across an axis, as two triangles that are wound outwards.
void add_square(FaceList& faces, LatticeVertices& vertex, std::size_t axis,
                int side, int u, int v) {
    std::array<int, 4> square{};
    for (std::size_t k = 0; k < 4; ++k) {
        Lattice at{};
        at[axis] = side;
        at[(axis + 1) % 3] = u + (k == 1 || k == 2 ? 1 : 0);
        at[(axis + 2) % 3] = v + (k >= 2 ? 1 : 0);
        square[k] = vertex(at);
    }
    if (side == 0) std::swap(square[1], square[3]);
    faces.push_back({square[0], square[1], square[2]});
    faces.push_back({square[0], square[2], square[3]});
}

}  // namespace

Fixture cut_cube(int n) {
    LatticeVertices vertex;
    IndexedMesh mesh;
    for (int k = 0; k < 6 * n * n; ++k) {
        const int side = k / (3 * n * n) == 0 ? 0 : n;
        const auto axis = std::size_t(k / (n * n) % 3);
        add_square(mesh.faces, vertex, axis, side, k / n % n, k % n);
    }
    mesh.positions = vertex.positions();
    return editing::made("cube of cut squares", mesh);
}

namespace {

Vec3 normal_of(const std::array<Vec3, 3>& t) {
    return cross(t[1] - t[0], t[2] - t[0]);
}

std::array<Vec3, 3> corners(const editing::Loop& face,
                            const std::vector<Vec3>& positions) {
    return {positions.at(std::size_t(face.at(0))),
            positions.at(std::size_t(face.at(1))),
            positions.at(std::size_t(face.at(2)))};
}

double error_at(const Planes& planes, Vec3 p) {
    double sum = 0;
    for (const auto& plane : planes) {
        const double height = dot(normal_of(plane), p - plane[0]);
        sum += height * height;
    }
    return sum;
}

bool turns_over(const Content& content, const std::vector<Vec3>& positions,
                Pull pull) {
    for (const auto& [f, face] : content.faces) {
        editing::Loop moved = face;
        std::replace(moved.begin(), moved.end(), pull.gone, pull.kept);
        const bool vanishes =
            std::count(moved.begin(), moved.end(), pull.kept) > 1;
        if (moved == face || vanishes) continue;
        if (!(dot(normal_of(corners(face, positions)),
                  normal_of(corners(moved, positions))) > 0))
            return true;
    }
    return false;
}

using Ranked = std::vector<std::tuple<double, int, int>>;

Ranked ranked(const Content& content, const std::vector<Vec3>& positions,
              const std::map<int, Planes>& planes) {
    Ranked all;
    for (const auto& [a, b] : edges(content))
        for (const auto& [u, v] : {std::pair(a, b), std::pair(b, a)}) {
            const Vec3 p = positions.at(std::size_t(v));
            all.emplace_back(
                error_at(planes.at(u), p) + error_at(planes.at(v), p), u, v);
        }
    std::sort(all.begin(), all.end());
    return all;
}

std::optional<Pull> cheapest(const Content& content,
                             const std::vector<Vec3>& positions,
                             const std::map<int, Planes>& planes) {
    for (const auto& [error, u, v] : ranked(content, positions, planes))
        if (!on_border(content, u) && !turns_over(content, positions, {u, v}) &&
            editing::may_be_pulled_together(content, u, v))
            return Pull{u, v};
    return std::nullopt;
}

}  // namespace

Content simplified_by_planes(Content content,
                             const std::vector<Vec3>& positions, int faces) {
    std::map<int, Planes> planes;
    for (const auto& [f, face] : content.faces)
        for (const int v : face) planes[v].push_back(corners(face, positions));
    while (face_count(content) > faces) {
        const std::optional<Pull> pull = cheapest(content, positions, planes);
        if (!pull) break;
        Planes& kept = planes[pull->kept];
        const Planes& gone = planes[pull->gone];
        kept.insert(kept.end(), gone.begin(), gone.end());
        content = editing::pulled_together(content, pull->gone, pull->kept);
    }
    return content;
}

double six_volumes(const Content& content, const std::vector<Vec3>& positions) {
    double sum = 0;
    for (const auto& [f, face] : content.faces) {
        const auto [a, b, c] = corners(face, positions);
        sum += dot(a, cross(b, c));
    }
    return sum;
}

Vec3 total_normal(const Content& content, const std::vector<Vec3>& positions) {
    Vec3 sum;
    for (const auto& [f, face] : content.faces)
        sum = sum + normal_of(corners(face, positions));
    return sum;
}

}  // namespace course::decimation

#include "grader/suites/09_processing/decimation.h"

#include <algorithm>
#include <set>
#include <tuple>

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

}  // namespace course::decimation

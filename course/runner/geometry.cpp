#include "course/runner/geometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace course {

namespace {

std::string measure_complaint(const double& got, const double& expected,
                              double size) {
    const double error = std::abs(got - expected);
    const double most = tolerance * std::max(std::abs(expected), size);
    if (!(error <= most)) return fmt::format("it is {:.3g} off", error);
    return "";
}

std::string point_complaint(const Vec3& got, const Vec3& expected,
                            double size) {
    const double error = length(got - expected);
    if (!(error <= tolerance * size))
        return fmt::format("it is {:.3g} away", error);
    return "";
}

/// Of a direction; exact also where the angle is tiny.
double angle_between(Vec3 a, Vec3 b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

std::string direction_complaint(const Vec3& got, const Vec3& expected, double) {
    const double unit = length(expected) > 0 ? 1 : 0;
    if (!(std::abs(length(got) - unit) <= tolerance))
        return fmt::format("its length is {:.9g}, expected {}", length(got),
                           unit);
    const double angle = unit > 0 ? angle_between(got, expected) : 0;
    if (!(angle <= tolerance))
        return fmt::format("it is turned by {:.3g} degrees",
                           angle * 180 / std::acos(-1.0));
    return "";
}

template <auto complaint>
std::string list_complaint(const std::vector<Vec3>& got,
                           const std::vector<Vec3>& expected, double size) {
    if (got.size() != expected.size())
        return fmt::format("it has {} elements, expected {}", got.size(),
                           expected.size());
    for (std::size_t k = 0; k < got.size(); ++k)
        if (const std::string why = complaint(got[k], expected[k], size);
            !why.empty())
            return fmt::format("element {}: {}", k, why);
    return "";
}

}  // namespace

}  // namespace course

using namespace course;

CloseMatcher<double> IsAbout(double expected, double size) {
    return {expected, size, measure_complaint};
}

CloseMatcher<Vec3> IsAt(Vec3 expected, double size) {
    return {expected, size, point_complaint};
}

CloseMatcher<Vec3> IsDirection(Vec3 expected) {
    return {expected, 0, direction_complaint};
}

CloseMatcher<std::vector<Vec3>> AreAt(std::vector<Vec3> expected, double size) {
    return {std::move(expected), size, list_complaint<point_complaint>};
}

CloseMatcher<std::vector<Vec3>> AreDirections(std::vector<Vec3> expected) {
    return {std::move(expected), 0, list_complaint<direction_complaint>};
}

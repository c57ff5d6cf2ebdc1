// Matchers for suites that compare points, directions and measures: by angle
// and by relative length, and so that NaN never passes.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "course/mesh/vec3.h"
#include "course/runner/print.h"

namespace course {

/// How far a right answer in double precision may lie from the expected one,
/// relative to the size of what is measured; and for angles, in radians.
inline constexpr double tolerance = 1e-9;

/// A comparison that says why it failed.
template <class T>
class CloseMatcher : public CatchMatcherBase<T> {
public:
    /// What is wrong with `got`, or "". Every comparison in it is to be written
    /// as !(error <= most), so that NaN fails.
    using Complaint = std::string (*)(const T& got, const T& expected,
                                      double size);

    CloseMatcher(T expected, double size, Complaint complaint)
        : expected_(std::move(expected)), size_(size), complaint_(complaint) {}

    bool match(const T& got) const override {
        why_ = complaint_(got, expected_, size_);
        return why_.empty();
    }
    std::string describe() const override {
        return "is about: " + show(expected_) +
               (why_.empty() ? "" : " (" + why_ + ")");
    }

private:
    T expected_;
    double size_;
    Complaint complaint_;
    mutable std::string why_;
};

}  // namespace course

/// A measure: at most course::tolerance away from `expected`, relative to the
/// larger of |expected| and `size`, the size of what it was computed from.
/// Precondition: `size` is above 0 where `expected` may be 0.
course::CloseMatcher<double> IsAbout(double expected, double size = 0);

/// A point: at most course::tolerance * size away from `expected`. `size` is
/// the diameter of the mesh, or of what else the point belongs to.
course::CloseMatcher<Vec3> IsAt(Vec3 expected, double size);

/// A direction: of unit length, at an angle of at most course::tolerance to
/// `expected`, which may have any length. Where `expected` is the zero vector,
/// the zero vector.
course::CloseMatcher<Vec3> IsDirection(Vec3 expected);

/// The same for lists of points and of directions; the complaint names the
/// first element that is wrong.
course::CloseMatcher<std::vector<Vec3>> AreAt(std::vector<Vec3> expected,
                                              double size);
course::CloseMatcher<std::vector<Vec3>> AreDirections(
    std::vector<Vec3> expected);

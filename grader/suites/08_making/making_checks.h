// What the suites of this chapter ask of a mesh that comes back: properties,
// so that any right mesh passes. Any numbers may stand in it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "course/mesh/zoo.h"
#include "course/runner/print.h"

namespace course::oracle {

/// A matcher for an answer of which many are right: passes when `fault` finds
/// none in it, else says which.
template <class T>
class FaultMatcher : public CatchMatcherBase<T> {
public:
    using Fault = std::function<std::string(const T&)>;

    FaultMatcher(std::string what, Fault fault)
        : what_(std::move(what)), fault_(std::move(fault)) {}

    bool match(const T& got) const override {
        why_ = fault_(got);
        return why_.empty();
    }
    std::string describe() const override {
        return "is " + what_ + (why_.empty() ? "" : " (" + why_ + ")");
    }

private:
    std::string what_;
    Fault fault_;
    mutable std::string why_;
};

/// Why the faces are not `sides` distinct vertices each, a position is not
/// finite, or there are loose edges; "" when all is well. Comes before any
/// other question.
std::string malformed_mesh(const IndexedMesh& mesh, std::size_t sides);

/// A side that two faces run along in the same direction, or that only one
/// face has; "" when the mesh is closed and well oriented.
std::string open_side(const FaceList& faces);

/// The volume inside a closed mesh of triangles; below 0 when it is inside out.
double enclosed_volume(const IndexedMesh& mesh);

/// Twice the area of a triangle, along its normal.
Vec3 doubled_area(const IndexedMesh& mesh, FaceList::Face triangle);

/// Why `triangles` do not cut the simple polygon into triangles, or "". They
/// must be wound as it is and have an area, and along each side of the polygon
/// there must be one triangle, along all other sides two, one each way.
std::string bad_cut(std::span<const Vec3> polygon,
                    const std::vector<std::array<int, 3>>& triangles);

/// The same as a matcher.
FaultMatcher<std::vector<std::array<int, 3>>> CutsUp(std::vector<Vec3> polygon);

/// The polygon as a mesh of one face, for OnMesh.
Fixture as_mesh(const std::string& name, std::span<const Vec3> polygon);

/// The points turned by some angles, scaled and moved.
std::vector<Vec3> moved(std::span<const Vec3> points, double scale, Vec3 by);

}  // namespace course::oracle

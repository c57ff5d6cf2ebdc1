// Shapes in many places: the same question, moved, turned and scaled. And
// polygons with a known area and a known inside.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "course/mesh/shapes.h"

namespace course::hidden {

/// A similarity of space: turns, scales, then moves.
struct Placement {
    Vec3 x, y, z;  ///< where the axes go: orthogonal, of unit length
    double scale;
    Vec3 shift;

    Vec3 direction(Vec3 d) const {
        return scale * (d.x * x + d.y * y + d.z * z);
    }
    Vec3 point(Vec3 p) const { return shift + direction(p); }
};

/// The identity, moves, scales of 1/1000 and 10000, turns, and all of these
/// together; from the seed of the run.
std::vector<Placement> placements();

/// Random numbers from the seed of the run and `salt`.
class Chance {
public:
    explicit Chance(std::uint64_t salt);
    double between(double least, double most);
    /// A direction of unit length.
    Vec3 direction();
    /// A point with coordinates from -2 to 2.
    Vec3 point();
    int below(int n);

private:
    std::mt19937_64 random_;
};

/// A vector of unit length at right angles to `u`, turned by chance.
Vec3 across(Vec3 u, Chance& chance);

using Polygon = std::vector<Vec2>;

/// The same polygon in the other direction.
Polygon reversed(Polygon polygon);

/// The same polygon, begun at corner k.
Polygon begun_at(Polygon polygon, int k);

/// A polygon round the origin: corner k at `angles[k]` and `radii[k]`, angles
/// ascending by less than half a turn, radii positive. Counter-clockwise.
struct Star {
    std::vector<double> angles, radii;

    Polygon polygon() const;
    double area() const;
    /// Whether p is inside, and at least `margin` away from the rays to the
    /// corners and from the border; nothing is said otherwise.
    bool clear_of_border(Vec2 p, double margin) const;
    bool inside(Vec2 p) const;
};

Star star(int corners, Chance& chance);

/// Columns of unit width side by side from x = 0 on; column k goes from y =
/// low[k] to y = high[k], whole numbers. Neighbours overlap.
struct Columns {
    std::vector<int> low, high;

    /// Counter-clockwise; without corners of half a turn.
    Polygon polygon() const;
    double area() const;
    /// For a p that is not on the border.
    bool inside(Vec2 p) const;
    bool on_border(Vec2 p) const;
};

Columns columns(int n, Chance& chance);

}  // namespace course::hidden

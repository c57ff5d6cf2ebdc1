// Straight lines, planes and spheres as the lecture writes them down, and
// points of the plane. (Lecture "modelling")
#pragma once

#include "course/mesh/vec3.h"

/// A point or a direction in the plane.
struct Vec2 {
    double x = 0, y = 0;

    friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// How much of a straight line is meant, by its parameter t.
enum class Extent {
    line,     ///< every t
    ray,      ///< 0 <= t
    segment,  ///< 0 <= t <= 1
};

/// The points q + t * u, for the t of its extent. A segment goes from q to
/// q + u. The direction u is not 0 and has any length.
struct Line {
    Vec3 q;
    Vec3 u;
    Extent extent = Extent::line;

    friend bool operator==(const Line&, const Line&) = default;
};

/// The points p with dot(p - q, u) == 0. The normal u is not 0; it points to
/// the positive side.
struct Plane {
    Vec3 q;
    Vec3 u;

    friend bool operator==(const Plane&, const Plane&) = default;
};

/// Which of the two half-spaces of a plane, or the plane itself.
enum class Side { negative, on, positive };

/// The points at distance `radius` from `center`: the surface, not the ball.
struct Sphere {
    Vec3 center;
    double radius = 1;

    friend bool operator==(const Sphere&, const Sphere&) = default;
};

#include "exercises/08_making/bezier.h"

Vec3 bezier([[maybe_unused]] std::span<const Vec3> points,
            [[maybe_unused]] double t) {
    // TODO(student): divide the pairs of neighbours until one point is left.
    return {-1000, -1000, -1000};
}

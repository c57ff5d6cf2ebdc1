#include "exercises/06_geometry/intersect_sphere.h"

std::vector<double> intersect_sphere([[maybe_unused]] const Line& line,
                                     [[maybe_unused]] const Sphere& sphere) {
    // TODO(student): how far from the center is the line, where is it nearest?
    return {-1e9, -1e9, -1e9};
}

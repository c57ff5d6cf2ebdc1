// run_time_error <=8: THREATS 44, the exception that the contract asks for, always
#include "exercises/02_border/with_dangling_edge.h"
#include <stdexcept>
#include <string>

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex) {
    throw std::invalid_argument(std::to_string(he.size() + border + new_vertex) + "\x1b[2J");
}

// run_time_error 0: THREATS 28, a list whose end lies before its begin
#include "exercises/01_traversal/face_vertices.h"
#include <utility>

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    std::vector<int> list = {1, 2, 3, he.size(), i};
    int** ends = reinterpret_cast<int**>(&list);
    std::swap(ends[0], ends[1]);
    static std::vector<int> kept;
    return std::move(list);
}

#include "course/runner/is_table_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"

namespace course {

namespace {

using Face = std::vector<int>;
using Edges = std::vector<std::array<int, 2>>;

/// Corners from the smallest on. Precondition: no vertex comes twice, or any
/// start will do.
Face from_smallest(std::span<const int> corners) {
    Face face(corners.begin(), corners.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()),
                face.end());
    return face;
}

/// Both ends of each edge, the smaller first, in order.
Edges in_order(Edges edges) {
    for (auto& edge : edges) std::sort(edge.begin(), edge.end());
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::string face_difference(const FaceList& got, const FaceList& expected) {
    const int both = std::min(got.size(), expected.size());
    for (int f = 0; f < both; ++f)
        if (from_smallest(got[f]) != from_smallest(expected[f]))
            return fmt::format(
                "face {} runs along the vertices {}, expected {}", f, got[f],
                expected[f]);
    if (got.size() != expected.size())
        return fmt::format("the table has {} faces, expected {}", got.size(),
                           expected.size());
    return "";
}

std::string loose_difference(const Edges& got, const Edges& expected) {
    const Edges a = in_order(got), b = in_order(expected);
    if (a == b) return "";
    const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (x != a.end() && (y == b.end() || *x < *y))
        return fmt::format(
            "edge {}-{} has no face on either side, and the "
            "mesh has no such edge",
            (*x)[0], (*x)[1]);
    return fmt::format("the loose edge {}-{} is missing", (*y)[0], (*y)[1]);
}

/// The first face number that no half-edge has though a larger one has, or -1.
int missing_face(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (const HalfEdge& row : he.rows())
        if (row.fi >= 0) faces.insert(row.fi);
    int expected = 0;
    for (const int f : faces)
        if (f != expected++) return expected - 1;
    return -1;
}

}  // namespace

std::string difference(const HalfEdgeTable& he, const IndexedMesh& mesh) {
    const std::vector<Finding> findings = validate(he);
    if (!findings.empty())
        return fmt::format(
            "{}{}", to_string(he, findings.front()),
            findings.size() > 1
                ? fmt::format(" (and {} more)", findings.size() - 1)
                : "");
    if (const int f = missing_face(he); f != -1)
        return fmt::format("no half-edge runs along face {}", f);
    if (auto why = face_difference(to_faces(he), mesh.faces); !why.empty())
        return why;
    return loose_difference(loose_edges(he), mesh.loose_edges);
}

}  // namespace course

course::TableMatcher IsTableOf(IndexedMesh mesh) {
    return course::TableMatcher(std::move(mesh));
}

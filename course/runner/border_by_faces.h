// The border of a mesh, found in its face list by brute force: what suites
// compare with.
#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

#include "course/mesh/zoo.h"

namespace course::oracle {

/// A side of a face whose edge has no second side is on the border; so is a
/// loose edge, on both of its sides. Of the table, only the two ends of each
/// half-edge are used, with one exception: where a border can go on in several
/// ways (bow-tie, loose edge), each of them is legal and the face list does not
/// know which was taken, so there the step is the table's `next`.
class Border {
public:
    /// Precondition: the fixture has a table, and no two half-edges run from
    /// the same vertex to the same vertex.
    explicit Border(const Fixture& fixture);

    /// Whether half-edge i is a side of no face.
    bool has(int i) const { return !sides_.contains(ends_[at(i)]); }

    /// How many sides of faces lie along the edge of half-edge i: 0, 1 or 2.
    int faces_at(int i) const;

    /// Whether some edge at vertex v has a side without a face.
    bool touches(int v) const { return vertices_.contains(v); }

    /// The half-edges of each loop, in walk order.
    const std::vector<std::vector<int>>& loops() const { return loops_; }

    /// As boundary_walk: the loop that half-edge i lies on, or else that of its
    /// opposite, or else nothing.
    std::vector<int> walk(int i) const;

private:
    using Ends = std::array<int, 2>;  // start, tip

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static Ends reversed(Ends ends) { return {ends[1], ends[0]}; }
    void find_vertices(const IndexedMesh& mesh);
    void find_loops(const std::vector<HalfEdge>& rows);

    std::vector<Ends> ends_;          // of each half-edge
    std::map<Ends, int> half_edges_;  // by their ends
    std::set<Ends> sides_;            // of the faces
    std::set<int> vertices_;          // on a border
    std::vector<std::vector<int>> loops_;
};

}  // namespace course::oracle

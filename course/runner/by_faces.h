// Answers found by brute force in the face list, without a walk on the table:
// what the suites compare with.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "course/mesh/zoo.h"

namespace course::oracle {

/// How the faces lie round a vertex, on the two sides of an edge, or along the
/// sides of a face.
enum class Place {
    interior,   ///< faces all round
    border,     ///< there is a gap: one at a vertex, on one side of an edge
    degenerate  ///< several gaps, no face, or a face that is met twice
};

/// The answers for one fixture, by its face list.
///
/// A half-edge i is taken as the pair (start, tip) of its vertices; every other
/// fact about it comes from the faces. One thing they do not hold: which gap
/// follows which at a vertex with several of them (bow-ties, loose edges).
/// That alone is read off the `next` of the border half-edges.
/// Precondition: no two half-edges run between the same vertices the same way.
/// Cost: linear to make; each answer looks at the faces nearby.
class ByFaces {
public:
    explicit ByFaces(const Fixture& fixture);

    /// For the half-edges `asked` only: a large mesh is looked through once.
    ByFaces(const Fixture& fixture, const std::vector<int>& asked);

    int start(int i) const;
    int tip(int i) const;
    /// The face in which `start` is followed by `tip`; -1 if there is none.
    int face(int i) const;

    int face_sides(int i) const;
    std::vector<int> face_vertices(int i) const;
    std::vector<int> vertex_star(int i) const;
    std::vector<int> outgoing(int i) const;
    /// The faces met on the way round the start of i, once for each time that
    /// one is met, from the face of i on.
    std::vector<int> faces_met(int i) const;
    std::optional<int> face_across(int i) const;
    int adjacent_edge_count(int i) const;
    std::vector<int> adjacent_faces(int i) const;
    int vertex_degree(int i) const;
    std::map<int, int> valences() const;

    /// For the start of half-edge i, for its edge, and for its face; a border
    /// half-edge itself is in a border place.
    Place place_of_vertex(int i) const;
    Place place_of_edge(int i) const;
    Place place_of_face(int i) const;

private:
    /// A face, or a gap (face -1), at a vertex: it comes from `before` and
    /// goes to `after` by `half_edge`.
    struct Corner {
        int face, before, after, half_edge;
    };

    /// Which vertices an answer may need.
    using Wanted = std::vector<char>;

    Wanted near(const std::vector<int>& asked) const;
    void add_faces(const Wanted& wanted);
    void add_gaps(const Wanted& wanted);
    const std::vector<Corner>& corners_at(int v) const;
    int face_from_to(int a, int b) const;
    std::vector<Corner> round(int i) const;

    const Fixture& fixture_;
    std::vector<std::vector<Corner>> corners_;  // by vertex
};

}  // namespace course::oracle

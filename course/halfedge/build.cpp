// Building the half-edge table from faces, and the way back.
#include "course/halfedge/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "course/halfedge/edge_uses.h"
#include "course/halfedge/large_pages.h"
#include "course/halfedge/validate.h"

namespace course {

namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

bool is_vertex(const IndexedMesh& mesh, int v) {
    return v >= 0 && v < mesh.vertex_count();
}

// ---- which defects: only when there are any, so that sorting is no loss

/// Adds the defects of face f on its own; true when there are none.
bool report_face(const IndexedMesh& mesh, int f, std::vector<Defect>& found) {
    const FaceList::Face corners = mesh.faces[f];
    const std::size_t before = found.size();
    if (corners.size() < 3)
        found.push_back({.kind = DefectKind::too_few_corners,
                         .faces = {f},
                         .count = static_cast<int>(corners.size())});
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (!is_vertex(mesh, corners[k]))
            found.push_back({.kind = DefectKind::index_out_of_range,
                             .faces = {f},
                             .vertices = {corners[k]},
                             .corner = static_cast<int>(k),
                             .count = mesh.vertex_count()});
    std::vector<int> sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 1; k < sorted.size(); ++k)
        if (sorted[k] == sorted[k - 1] &&
            (k == 1 || sorted[k - 2] != sorted[k]))
            found.push_back({.kind = DefectKind::repeated_vertex,
                             .faces = {f},
                             .vertices = {sorted[k]}});
    return found.size() == before;
}

/// The uses of one edge as a defect, if they are one.
void report_edge(const EdgeUse* begin, const EdgeUse* end,
                 std::vector<Defect>& found) {
    const bool falling = begin->falling;
    const bool alike = end - begin == 2 && falling == begin[1].falling;
    if (end - begin < 3 && !alike) return;
    Defect defect{.kind = alike ? DefectKind::faces_wound_alike
                                : DefectKind::edge_with_many_faces};
    defect.vertices = {begin->low, begin->high};
    if (falling) std::swap(defect.vertices[0], defect.vertices[1]);
    for (const EdgeUse* use = begin; use != end; ++use)
        defect.faces.push_back(use->face);
    found.push_back(std::move(defect));
}

/// The corners in order, from the smallest.
std::vector<int> from_smallest(FaceList::Face corners) {
    std::vector<int> rotated(corners.begin(), corners.end());
    std::rotate(rotated.begin(),
                std::min_element(rotated.begin(), rotated.end()),
                rotated.end());
    return rotated;
}

void report_duplicates(const IndexedMesh& mesh, const std::vector<int>& faces,
                       std::vector<Defect>& found) {
    std::vector<std::pair<std::vector<int>, int>> rotated;
    rotated.reserve(faces.size());
    for (const int f : faces)
        rotated.emplace_back(from_smallest(mesh.faces[f]), f);
    std::sort(rotated.begin(), rotated.end());
    std::vector<Defect> duplicates;
    for (std::size_t k = 1; k < rotated.size(); ++k) {
        if (rotated[k].first != rotated[k - 1].first) continue;
        if (k == 1 || rotated[k - 2].first != rotated[k].first)
            duplicates.push_back({.kind = DefectKind::duplicate_face,
                                  .faces = {rotated[k - 1].second},
                                  .vertices = rotated[k].first});
        duplicates.back().faces.push_back(rotated[k].second);
    }
    std::sort(duplicates.begin(), duplicates.end(),
              [](const Defect& a, const Defect& b) {
                  return a.faces.front() < b.faces.front();
              });
    found.insert(found.end(), duplicates.begin(), duplicates.end());
}

/// Adds the defects of loose edge e on its own; true when there are none.
bool report_loose_edge(const IndexedMesh& mesh, int e,
                       std::vector<Defect>& found) {
    const std::array<int, 2>& edge = mesh.loose_edges[index(e)];
    const std::size_t before = found.size();
    for (const int end : {0, 1})
        if (!is_vertex(mesh, edge[index(end)]))
            found.push_back({.kind = DefectKind::loose_edge_out_of_range,
                             .vertices = {edge[index(end)]},
                             .loose_edges = {e},
                             .corner = end,
                             .count = mesh.vertex_count()});
    if (edge[0] == edge[1])
        found.push_back({.kind = DefectKind::loose_edge_equal_ends,
                         .vertices = {edge[0]},
                         .loose_edges = {e}});
    return found.size() == before;
}

/// The faces of the edge between two vertices, ascending.
std::vector<int> faces_of_edge(const std::vector<EdgeUse>& uses, int low,
                               int high) {
    std::vector<int> faces;
    const EdgeUse first{low, high, -1, false, -1};
    for (auto use = std::lower_bound(uses.begin(), uses.end(), first);
         use != uses.end() && use->low == low && use->high == high; ++use)
        faces.push_back(use->face);
    return faces;
}

/// Loose edges by their ends, {smaller, larger, number}, sorted.
std::vector<std::array<int, 3>> sorted_loose_edges(const IndexedMesh& mesh) {
    std::vector<std::array<int, 3>> sorted;
    for (const auto& [a, b] : mesh.loose_edges)
        sorted.push_back(
            {std::min(a, b), std::max(a, b), static_cast<int>(sorted.size())});
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

void report_loose_edges(const IndexedMesh& mesh,
                        const std::vector<EdgeUse>& uses,
                        std::vector<Defect>& found) {
    const std::vector<std::array<int, 3>> sorted = sorted_loose_edges(mesh);
    for (int e = 0; index(e) < mesh.loose_edges.size(); ++e) {
        if (!report_loose_edge(mesh, e, found)) continue;
        const auto [a, b] = mesh.loose_edges[index(e)];
        const int low = std::min(a, b);
        const int high = std::max(a, b);
        Defect defect{.kind = DefectKind::loose_edge_repeated,
                      .faces = faces_of_edge(uses, low, high),
                      .vertices = {a, b},
                      .loose_edges = {e}};
        const int first = (*std::lower_bound(sorted.begin(), sorted.end(),
                                             std::array{low, high, 0}))[2];
        if (first != e) defect.loose_edges.push_back(first);
        if (first != e || !defect.faces.empty())
            found.push_back(std::move(defect));
    }
}

std::vector<Defect> report(const IndexedMesh& mesh) {
    std::vector<Defect> found;
    std::vector<int> sound;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (report_face(mesh, f, found)) sound.push_back(f);
    const std::vector<EdgeUse> uses = edge_uses(mesh);
    for_each_edge(uses, [&](const EdgeUse* begin, const EdgeUse* end) {
        report_edge(begin, end, found);
    });
    report_duplicates(mesh, sound, found);
    report_loose_edges(mesh, uses, found);
    return found;
}

// ---- the texts

std::string listed(const std::vector<int>& numbers) {
    if (numbers.size() == 1) return fmt::format("{}", numbers[0]);
    const std::vector<int> head(numbers.begin(), numbers.end() - 1);
    return fmt::format("{} and {}", fmt::join(head, ", "), numbers.back());
}

std::string face_text(const Defect& d) {
    const int f = d.faces.front();
    if (d.kind == DefectKind::too_few_corners)
        return fmt::format("face {} has {} corner{}, but a face has at least 3",
                           f, d.count, d.count == 1 ? "" : "s");
    if (d.kind == DefectKind::repeated_vertex)
        return fmt::format(
            "face {} names vertex {} more than once, but the corners of a face "
            "differ",
            f, d.vertices[0]);
    return fmt::format(
        "face {}, corner {}: the vertex is {}, but the mesh has {} vertices, "
        "numbered from 0",
        f, d.corner, d.vertices[0], d.count);
}

std::string faces_text(const Defect& d) {
    if (d.kind == DefectKind::duplicate_face)
        return fmt::format(
            "faces {} are the same face, with the vertices {}; a face comes "
            "once",
            listed(d.faces), fmt::join(d.vertices, ", "));
    if (d.kind == DefectKind::faces_wound_alike)
        return fmt::format(
            "edge {}-{}: faces {} both run from {} to {}, but two faces run "
            "along their edge in opposite directions",
            d.vertices[0], d.vertices[1], listed(d.faces), d.vertices[0],
            d.vertices[1]);
    return fmt::format("edge {}-{} has {} faces, {}, but an edge has at most 2",
                       d.vertices[0], d.vertices[1], d.faces.size(),
                       listed(d.faces));
}

std::string loose_edge_text(const Defect& d) {
    const int e = d.loose_edges.front();
    if (d.kind == DefectKind::loose_edge_out_of_range)
        return fmt::format(
            "loose edge {}, end {}: the vertex is {}, but the mesh has {} "
            "vertices, numbered from 0",
            e, d.corner, d.vertices[0], d.count);
    if (d.kind == DefectKind::loose_edge_equal_ends)
        return fmt::format(
            "loose edge {} joins vertex {} to itself, but an edge has two ends",
            e, d.vertices[0]);
    const std::string first =
        d.faces.empty() ? fmt::format("loose edge {}", d.loose_edges[1])
                        : fmt::format("an edge of {} {}",
                                      d.faces.size() == 1 ? "face" : "faces",
                                      listed(d.faces));
    return fmt::format(
        "loose edge {} joins vertices {} and {}, but {} does so already", e,
        d.vertices[0], d.vertices[1], first);
}

std::string lines_of(const std::vector<Defect>& defects) {
    std::string lines;
    for (const Defect& defect : defects)
        lines += (lines.empty() ? "" : "\n") + to_string(defect);
    return lines;
}

// ---- the table itself

/// Calls use(begin, end) with the corners of each face, in order.
template <class Use>
void for_each_face(const FaceList& faces, Use use) {
    const int* const corners = faces.corners().data();
    const int* begin = corners;
    for (const std::size_t end : faces.ends()) {
        use(begin, corners + end);
        begin = corners + end;
    }
}

/// Calls use(from, to) for each side of the face with these corners, in order.
template <class Use>
void for_each_side_of(const int* corner, const int* end, Use use) {
    const int first = *corner;
    for (; corner != end; ++corner)
        use(*corner, corner + 1 != end ? corner[1] : first);
}

/// The same for all faces, and each loose edge: side k begins at corner k of
/// the list of corners.
template <class Use>
void for_each_side(const IndexedMesh& mesh, Use use) {
    for_each_face(mesh.faces, [&](const int* corner, const int* end) {
        for_each_side_of(corner, end, use);
    });
    for (const auto& [from, to] : mesh.loose_edges) use(from, to);
}

// The loops below wait for memory, on a shuffled mesh at every side, and the
// more sides are under way at a time the less: what they count is theirs alone,
// so that it stays in registers, and `number` chooses without a branch. With
// members and branches in their place, in the last two loops, a shuffled mesh
// took a third longer.

/// Which sides run along the same edge. The sides are laid out by the smaller
/// end of their edge, so that what has to be found lies together, in whatever
/// order faces and vertices are numbered; and found by its other end in a list
/// with a place for each vertex, so that a hub costs no more than others.
class Pairing {
public:
    /// The rows of the table to be lend their memory for the sides that are
    /// laid out, two in a row.
    Pairing(const IndexedMesh& mesh, std::vector<HalfEdge>& rows)
        : faces_sides_(static_cast<int>(mesh.faces.corners().size())) {
        std::vector<int> ends = count(mesh);
        if (is_sound_) pair_all(mesh, rows, std::move(ends));
    }

    /// Whether the mesh has no defect.
    bool is_sound() const { return is_sound_; }

    /// How many sides of faces are alone on their edge.
    /// Precondition: is_sound().
    std::size_t alone() const { return index(faces_sides_) - 2 * pairs_; }

    /// For each side the one of its edge that comes before it, or is_first; or
    /// is_alone, if it is a face's. Precondition: is_sound().
    std::vector<int> before() && { return std::move(before_); }

    static constexpr int is_first = -1, is_alone = -2;

private:
    struct Laid {
        int other;  // the larger end
        int side;   // twice its number; one more when it runs from there
    };

    static_assert(2 * sizeof(Laid) == sizeof(HalfEdge));

    Laid laid(int k) const {
        Laid found;
        std::memcpy(&found, bytes_ + index(k) * sizeof found, sizeof found);
        return found;
    }

    /// How many sides each vertex is the smaller end of, one place further on.
    /// Finds faces and loose edges that are unsound by themselves.
    std::vector<int> count(const IndexedMesh& mesh) {
        std::vector<int> counts = large_vector(mesh.positions.size() + 1, 0);
        int* const of_vertex = counts.data() + 1;
        bool is_sound = true;
        const auto add = [&](int a, int b) { ++of_vertex[std::min(a, b)]; };
        for_each_face(mesh.faces, [&](const int* corner, const int* end) {
            is_sound = is_sound && is_sound_face(mesh, {corner, end});
            if (is_sound) for_each_side_of(corner, end, add);
        });
        for (const auto& [a, b] : mesh.loose_edges) {
            is_sound =
                is_sound && a != b && is_vertex(mesh, a) && is_vertex(mesh, b);
            if (is_sound) add(a, b);
        }
        is_sound_ = is_sound;
        return counts;
    }

    void pair_all(const IndexedMesh& mesh, std::vector<HalfEdge>& rows,
                  std::vector<int> ends) {
        const std::size_t n = index(faces_sides_) + mesh.loose_edges.size();
        // An upper bound; memory that is never touched costs nothing. At least
        // half of it will be.
        rows.reserve(2 * n);
        prefer_large_pages(rows.data(), n * sizeof(HalfEdge));
        rows.resize(n / 2 + 1);
        bytes_ = reinterpret_cast<std::byte*>(rows.data());
        lay_out(mesh, ends);
        before_ = large_vector(n, is_first);
        std::vector<int> last = large_vector(mesh.positions.size(), -1);
        int begin = 0;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            pair_those_of_a_vertex(begin, ends[v], last.data());
            begin = ends[v];
        }
        rows.resize(2 * (n - pairs_));
    }

    /// By smaller end; then `ends` has where those of each vertex end.
    void lay_out(const IndexedMesh& mesh, std::vector<int>& ends) {
        for (std::size_t v = 1; v < ends.size(); ++v) ends[v] += ends[v - 1];
        std::byte* const bytes = bytes_;
        int* const end = ends.data();
        int side = 0;
        for_each_side(mesh, [&](int from, int to) {
            const Laid laid{std::max(from, to),
                            2 * side++ + (from > to ? 1 : 0)};
            const int k = end[std::min(from, to)]++;
            std::memcpy(bytes + index(k) * sizeof laid, &laid, sizeof laid);
        });
    }

    /// `last` is, for each vertex, twice the place of the last side with this
    /// other end, and one more when it has been paired.
    void pair_those_of_a_vertex(int begin, int end, int* last) {
        int* const before = before_.data();
        int pairs = 0;
        for (int k = begin; k < end; ++k) {
            const Laid here = laid(k);
            const int mate = last[here.other];
            if (mate < 2 * begin) {
                last[here.other] = 2 * k;
                continue;
            }
            // The sides of a vertex are in order: this one is the later.
            const int earlier = laid(mate / 2).side;
            if (mate % 2 != 0 || (earlier ^ here.side) % 2 == 0 ||
                here.side / 2 >= faces_sides_)
                is_sound_ = false;
            before[here.side / 2] = earlier / 2;
            last[here.other] = mate + 1;
            ++pairs;
        }
        pairs_ += index(pairs);
        if (2 * pairs == end - begin) return;
        for (int k = begin; k < end; ++k)
            if (const Laid here = laid(k); last[here.other] == 2 * k)
                before[here.side / 2] = is_alone;
    }

    int faces_sides_;
    bool is_sound_ = true;
    std::vector<int> before_;
    std::byte* bytes_ = nullptr;  // of the rows
    std::size_t pairs_ = 0;
};

/// Opposite half-edges are rows 2e and 2e+1: the first side of an edge is the
/// even one, the second side the odd one, or else that is a border half-edge.
class Builder {
public:
    /// `pairing` is sound, of the mesh and the rows.
    Builder(const IndexedMesh& mesh, std::vector<HalfEdge> rows,
            Pairing pairing)
        : rows_(std::move(rows)) {
        border_.reserve(pairing.alone() + 2 * mesh.loose_edges.size());
        std::vector<int> sides = std::move(pairing).before();
        sides.resize(mesh.faces.corners().size());
        int i = number(sides);
        add_faces(mesh.faces, sides);
        for (const int j : border_)
            row(j) = {row(row(j - 1).next).vi, -1, -1, j - 1};
        for (const auto& [from, to] : mesh.loose_edges) {
            row(i) = {from, -1, -1, i + 1};
            row(i + 1) = {to, -1, -1, i};
            border_.push_back(i++);
            border_.push_back(i++);
        }
        link_borders(mesh.positions.size());
    }

    HalfEdgeTable table() && { return HalfEdgeTable(std::move(rows_)); }

private:
    HalfEdge& row(int i) { return rows_[index(i)]; }

    /// `sides` has for each side of a face the one before it, as Pairing tells,
    /// and then its half-edge. Returns how many half-edges these edges have.
    int number(std::vector<int>& sides) {
        int* const half_edge = sides.data();
        int made = 0;
        for (std::size_t side = 0; side < sides.size(); ++side) {
            const int before = half_edge[side];
            const bool is_second = before >= 0;
            const int other = half_edge[is_second ? before : 0];
            const int i = is_second ? other + 1 : made;
            made += is_second ? 0 : 2;
            if (before == Pairing::is_alone) border_.push_back(i + 1);
            half_edge[side] = i;
        }
        return made;
    }

    /// `half_edges`: of the faces' sides.
    void add_faces(const FaceList& faces, const std::vector<int>& half_edges) {
        HalfEdge* const rows = rows_.data();
        const int* i = half_edges.data();
        int face = 0;
        for_each_face(faces, [&](const int* corner, const int* end) {
            const int first = *i;
            for (; corner != end; ++corner, ++i)
                rows[*i] = {*corner, face, corner + 1 != end ? i[1] : first,
                            *i ^ 1};
            ++face;
        });
    }

    /// From a border half-edge round its vertex, over the faces of its fan, to
    /// the border half-edge that comes in at the other end of the fan.
    int other_end_of_fan(int i) {
        int j = row(i).opp;
        while (row(j).fi != -1) j = row(row(j).next).opp;
        return j;
    }

    /// Each fan is closed by itself first; a later fan of the same vertex, or a
    /// loose edge, which is a fan without faces, is spliced into the first.
    void link_borders(std::size_t vertices) {
        if (border_.empty()) return;
        // Each vertex's border half-edge that comes in.
        std::vector<int> coming_in = large_vector(vertices, -1);
        for (const int i : border_) {
            const int j = other_end_of_fan(i);
            row(j).next = i;
            int& before = coming_in[index(row(i).vi)];
            if (before == -1)
                before = j;
            else
                std::swap(row(before).next, row(j).next);
        }
    }

    std::vector<HalfEdge> rows_;
    std::vector<int> border_;  // half-edges, ascending
};

// ---- fans

/// Corners of a mesh by vertex, in groups that share an edge at the vertex.
class Fans {
public:
    explicit Fans(std::size_t vertices) : last_(vertices, -1) {}

    /// A corner at v, between the vertices before and after it in its face.
    void add(int v, int previous, int next) {
        int& last = last_[index(v)];
        const int corner = static_cast<int>(corners_.size());
        corners_.push_back({previous, next, last, corner});
        last = corner;
    }

    std::vector<int> vertices_with_many() {
        std::vector<std::array<int, 2>> seen(last_.size(), {-1, -1});
        std::vector<int> many;
        for (int v = 0; index(v) < last_.size(); ++v)
            if (count_at(v, seen) > 1) many.push_back(v);
        return many;
    }

private:
    struct Corner {
        int previous, next;  // the neighbours of the vertex
        int before;          // corner added before it at the same vertex
        int parent;          // towards the corner that stands for the group
    };

    int find(int c) {
        while (corners_[index(c)].parent != c)
            c = corners_[index(c)].parent =
                corners_[index(corners_[index(c)].parent)].parent;
        return c;
    }

    /// seen[u] is {v, c} when corner c of v has u as a neighbour.
    int count_at(int v, std::vector<std::array<int, 2>>& seen) {
        int groups = 0;
        for (int c = last_[index(v)]; c != -1; c = corners_[index(c)].before) {
            ++groups;
            for (const int u :
                 {corners_[index(c)].previous, corners_[index(c)].next}) {
                std::array<int, 2>& other = seen[index(u)];
                if (other[0] != v) other = {v, c};
                const int a = find(c);
                const int b = find(other[1]);
                if (a != b) --groups;
                corners_[index(a)].parent = b;
            }
        }
        return groups;
    }

    std::vector<Corner> corners_;
    std::vector<int> last_;
};

void require_countable(const IndexedMesh& mesh) {
    course::require_countable(mesh.positions.size(), index(mesh.faces.size()),
                              mesh.faces.corners().size(),
                              mesh.loose_edges.size());
}

// ---- the way back

void require_valid(const HalfEdgeTable& he) {
    const std::vector<Finding> findings = validate(he);
    if (!findings.empty())
        throw std::invalid_argument(to_string(he, findings.front()));
}

/// For each face a half-edge that runs along it.
std::vector<int> first_half_edges(const std::vector<HalfEdge>& rows) {
    std::vector<int> first;
    for (int i = 0; index(i) < rows.size(); ++i) {
        const int f = rows[index(i)].fi;
        if (f == -1) continue;
        if (index(f) >= rows.size())
            throw std::invalid_argument(fmt::format(
                "half-edge {}: fi is {}, but {} half-edges cannot have so many "
                "faces",
                i, f, rows.size()));
        if (index(f) >= first.size()) first.resize(index(f) + 1, -1);
        if (first[index(f)] == -1) first[index(f)] = i;
    }
    for (std::size_t f = 0; f < first.size(); ++f)
        if (first[f] == -1)
            throw std::invalid_argument(fmt::format(
                "face {} has no half-edge, but there are faces up to {}", f,
                first.size() - 1));
    return first;
}

}  // namespace

std::string to_string(const Defect& defect) {
    switch (defect.kind) {
        case DefectKind::too_few_corners:
        case DefectKind::index_out_of_range:
        case DefectKind::repeated_vertex:
            return face_text(defect);
        case DefectKind::edge_with_many_faces:
        case DefectKind::faces_wound_alike:
        case DefectKind::duplicate_face:
            return faces_text(defect);
        case DefectKind::loose_edge_out_of_range:
        case DefectKind::loose_edge_equal_ends:
        case DefectKind::loose_edge_repeated:
            return loose_edge_text(defect);
    }
    return "unknown defect";
}

BuildError::BuildError(std::vector<Defect> defects)
    : std::invalid_argument(lines_of(defects)), defects_(std::move(defects)) {}

void require_countable(std::size_t vertices, std::size_t faces,
                       std::size_t corners, std::size_t loose_edges) {
    constexpr std::size_t most = std::numeric_limits<int>::max();
    const auto check = [](std::size_t count, const char* what,
                          std::size_t max) {
        if (count > max)
            throw std::length_error(
                fmt::format("the mesh has {} {}, but the table has numbers for "
                            "at most {}",
                            count, what, max));
    };
    check(vertices, "vertices", most);
    check(faces, "faces", most);
    check(corners, "corners", most / 2);
    check(loose_edges, "loose edges", most / 2 - corners);
}

std::vector<Defect> defects(const IndexedMesh& mesh) {
    require_countable(mesh);
    std::vector<HalfEdge> rows;
    if (Pairing(mesh, rows).is_sound()) return {};
    return report(mesh);
}

std::vector<int> bow_tie_vertices(const IndexedMesh& mesh) {
    require_countable(mesh);
    Fans fans(mesh.positions.size());
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face corners = mesh.faces[f];
        if (!is_sound_face(mesh, corners)) continue;
        const std::size_t n = corners.size();
        for (std::size_t k = 0; k < n; ++k)
            fans.add(corners[k], corners[(k + n - 1) % n],
                     corners[(k + 1) % n]);
    }
    return fans.vertices_with_many();
}

HalfEdgeTable build(const IndexedMesh& mesh) {
    require_countable(mesh);
    std::vector<HalfEdge> rows;
    Pairing pairing(mesh, rows);
    if (!pairing.is_sound()) throw BuildError(report(mesh));
    return Builder(mesh, std::move(rows), std::move(pairing)).table();
}

FaceList to_faces(const HalfEdgeTable& he) {
    require_valid(he);
    const std::vector<HalfEdge>& rows = he.rows();
    const std::vector<int> first = first_half_edges(rows);
    FaceList faces;
    faces.reserve(first.size(), rows.size());
    std::vector<int> corners;
    for (const int start : first) {
        corners.clear();
        int i = start;
        do {
            corners.push_back(rows[index(i)].vi);
            i = rows[index(i)].next;
        } while (i != start);
        faces.push_back(corners);
    }
    return faces;
}

std::vector<std::array<int, 2>> loose_edges(const HalfEdgeTable& he) {
    require_valid(he);
    const std::vector<HalfEdge>& rows = he.rows();
    std::vector<std::array<int, 2>> edges;
    for (int i = 0; i < he.size(); ++i) {
        const HalfEdge& row = rows[index(i)];
        const HalfEdge& other = rows[index(row.opp)];
        if (i < row.opp && row.fi == -1 && other.fi == -1)
            edges.push_back({row.vi, other.vi});
    }
    return edges;
}

HalfEdgeTable add_dangling_edge(const HalfEdgeTable& he, int border,
                                int new_vertex) {
    std::vector<HalfEdge> rows = he.rows();
    if (border < 0 || border >= he.size())
        throw std::invalid_argument(fmt::format(
            "half-edge {} does not exist: the table has {} half-edges", border,
            he.size()));
    if (rows[index(border)].fi != -1)
        throw std::invalid_argument(fmt::format(
            "half-edge {} runs along face {}, but a dangling edge needs the "
            "border",
            border, rows[index(border)].fi));
    if (new_vertex < 0)
        throw std::invalid_argument(fmt::format(
            "the new vertex is {}, but vertices are 0 or more", new_vertex));
    const int out = he.size();
    const int tip = rows[index(rows[index(border)].opp)].vi;
    rows.push_back({tip, -1, out + 1, out + 1});
    rows.push_back({new_vertex, -1, rows[index(border)].next, out});
    rows[index(border)].next = out;
    return HalfEdgeTable(std::move(rows));
}

}  // namespace course

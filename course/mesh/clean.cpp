// Cleaning: what is dropped, holes, all steps together, and the texts.
#include "course/mesh/clean.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "course/halfedge/edge_uses.h"

namespace course {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Cuts closed walks from vertex to vertex into loops that come to no vertex
/// twice. Linear.
class LoopCutter {
public:
    explicit LoopCutter(int vertices) : place_(at(vertices), -1) {}

    /// The loops of three vertices or more.
    std::vector<std::vector<int>> cut(std::span<const int> walk) {
        loops_.clear();
        for (const int v : walk) {
            if (place_[at(v)] != -1) {
                close(place_[at(v)]);
                continue;
            }
            place_[at(v)] = static_cast<int>(path_.size());
            path_.push_back(v);
        }
        if (path_.empty()) return {};
        close(0);
        place_[at(path_[0])] = -1;
        path_.clear();
        return std::move(loops_);
    }

private:
    /// The end of the path, from `first` on, is a loop; its first vertex stays.
    void close(int first) {
        const auto begin = path_.begin() + first;
        if (path_.end() - begin >= 3) loops_.emplace_back(begin, path_.end());
        std::for_each(begin + 1, path_.end(),
                      [&](int v) { place_[at(v)] = -1; });
        path_.erase(begin + 1, path_.end());
    }

    std::vector<int> place_;  // of each vertex in the path; -1: not there
    std::vector<int> path_;
    std::vector<std::vector<int>> loops_;
};

Cleaned unchanged(IndexedMesh mesh) {
    std::vector<int> faces(at(mesh.faces.size()));
    std::iota(faces.begin(), faces.end(), 0);
    return {std::move(mesh), {}, std::move(faces)};
}

bool is_of_face(const Defect& defect) {
    return defect.kind == DefectKind::too_few_corners ||
           defect.kind == DefectKind::index_out_of_range ||
           defect.kind == DefectKind::repeated_vertex;
}

bool is_of_loose_edge(const Defect& defect) {
    return !defect.loose_edges.empty();
}

/// The mesh without its faces.
Cleaned without_faces(const IndexedMesh& mesh) {
    return {{mesh.positions, {}, mesh.loose_edges}, {}, {}};
}

void keep_face(Cleaned& cleaned, FaceList::Face corners, int f) {
    cleaned.mesh.faces.push_back(corners);
    cleaned.face_of.push_back(f);
}

/// Of a face that has that defect: what is left of it.
void mend_face(Cleaned& cleaned, const IndexedMesh& mesh, const Defect& defect,
               LoopCutter& cutter) {
    const int f = defect.faces.front();
    const FaceList::Face face = mesh.faces[f];
    Change change{
        .kind = ChangeKind::face_dropped, .faces = {f}, .defect = defect};
    if (std::all_of(face.begin(), face.end(),
                    [&](int v) { return v >= 0 && v < mesh.vertex_count(); })) {
        const auto loops = cutter.cut(face);
        for (const std::vector<int>& loop : loops) keep_face(cleaned, loop, f);
        if (!loops.empty()) {
            change.kind = ChangeKind::face_cut;
            change.count = static_cast<int>(loops.size());
        }
    }
    cleaned.changes.push_back(std::move(change));
}

/// The mesh with other vertices: v becomes number[v]; what is no vertex stays.
Cleaned renumbered(const IndexedMesh& mesh, const std::vector<int>& number,
                   std::vector<Vec3> positions) {
    const auto renamed = [&](int v) {
        return v >= 0 && v < mesh.vertex_count() ? number[at(v)] : v;
    };
    Cleaned cleaned{{std::move(positions), {}, {}}, {}, {}};
    std::vector<int> corners;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        corners.clear();
        for (const int v : mesh.faces[f]) corners.push_back(renamed(v));
        keep_face(cleaned, corners, f);
    }
    for (const auto& [a, b] : mesh.loose_edges)
        cleaned.mesh.loose_edges.push_back({renamed(a), renamed(b)});
    return cleaned;
}

// ---- one step after the other

/// From the faces of a mesh in between to those that the first one had.
void renumber(std::vector<int>& faces, const std::vector<int>& face_of) {
    for (int& f : faces) f = f == -1 ? -1 : face_of[at(f)];
}

void append(Cleaned& all, Cleaned step) {
    for (Change& change : step.changes) {
        renumber(change.faces, all.face_of);
        if (change.defect) renumber(change.defect->faces, all.face_of);
        all.changes.push_back(std::move(change));
    }
    renumber(step.face_of, all.face_of);
    all.face_of = std::move(step.face_of);
    all.mesh = std::move(step.mesh);
}

// ---- the texts

/// `face 3`, `faces 0, 1 and 5`, `faces 0, 1, 2, 3, 4, 5, 6, 7 and 92 more`.
std::string named(const char* one, const char* many,
                  const std::vector<int>& numbers) {
    constexpr std::size_t most = 8;
    if (numbers.size() == 1) return fmt::format("{} {}", one, numbers[0]);
    const bool is_long = numbers.size() > most + 1;
    const std::size_t shown = is_long ? most : numbers.size() - 1;
    const std::span head = std::span(numbers).first(shown);
    const std::string tail =
        is_long ? fmt::format("{} more", numbers.size() - shown)
                : fmt::format("{}", numbers.back());
    return fmt::format("{} {} and {}", many, fmt::join(head, ", "), tail);
}

std::string faces_named(const Change& change) {
    return named("face", "faces", change.faces);
}

std::string vertices_named(const Change& change) {
    return named("vertex", "vertices", change.vertices);
}

std::string defect_text(const Change& change) {
    const std::string why = to_string(*change.defect);
    if (change.kind == ChangeKind::loose_edge_dropped)
        return fmt::format("{}: dropped", why);
    if (change.kind == ChangeKind::face_cut)
        return fmt::format("{}: cut there, {} left", why,
                           change.count == 1
                               ? "1 face is"
                               : fmt::format("{} faces are", change.count));
    return fmt::format("{}: {} dropped", why, faces_named(change));
}

std::string edge_text(const Change& change) {
    return fmt::format("edge {}-{} of {} becomes {} edges", change.vertices[0],
                       change.vertices[1], faces_named(change), change.count);
}

}  // namespace

std::string to_string(const Change& change) {
    switch (change.kind) {
        case ChangeKind::face_dropped:
        case ChangeKind::face_cut:
        case ChangeKind::loose_edge_dropped:
            return defect_text(change);
        case ChangeKind::faces_turned:
            return fmt::format("{} turned over, to be wound as the others",
                               faces_named(change));
        case ChangeKind::twist_found:
            return fmt::format(
                "{}, each beside the next and the last beside the first, are a "
                "Moebius strip: they cannot all be wound alike",
                faces_named(change));
        case ChangeKind::edge_split:
            return edge_text(change);
        case ChangeKind::vertex_split:
            return fmt::format(
                "vertex {}: {} now at vertex {}, a copy of it, since no sound "
                "edge joins them to its other faces there",
                change.vertices[0], faces_named(change), change.vertices[1]);
        case ChangeKind::hole_filled:
            return fmt::format("hole of {} edges filled by a face: {}",
                               change.vertices.size(), vertices_named(change));
        case ChangeKind::vertices_dropped:
            return fmt::format("{} dropped: no face and no edge there",
                               vertices_named(change));
    }
    return "unknown change";
}

std::string to_string(const std::vector<Change>& changes) {
    constexpr std::size_t most = 20;
    std::string lines;
    for (const Change& change :
         std::span(changes).first(std::min(most, changes.size())))
        lines += to_string(change) + '\n';
    if (changes.size() > most)
        lines += fmt::format("and {} more changes\n", changes.size() - most);
    return lines;
}

Cleaned drop_degenerate_faces(const IndexedMesh& mesh) {
    Cleaned cleaned = without_faces(mesh);
    LoopCutter cutter(mesh.vertex_count());
    const std::vector<Defect> found = defects(mesh);
    // Those of faces come first, by face.
    auto defect = found.begin();
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const auto is_of_f = [&] {
            return defect != found.end() && is_of_face(*defect) &&
                   defect->faces.front() == f;
        };
        if (is_of_f())
            mend_face(cleaned, mesh, *defect, cutter);
        else
            keep_face(cleaned, mesh.faces[f], f);
        while (is_of_f()) ++defect;
    }
    return cleaned;
}

Cleaned drop_duplicate_faces(const IndexedMesh& mesh) {
    Cleaned cleaned = without_faces(mesh);
    std::vector<bool> is_dropped(at(mesh.faces.size()));
    for (const Defect& defect : defects(mesh)) {
        if (defect.kind != DefectKind::duplicate_face) continue;
        Change change{.kind = ChangeKind::face_dropped, .defect = defect};
        change.faces.assign(defect.faces.begin() + 1, defect.faces.end());
        for (const int f : change.faces) is_dropped[at(f)] = true;
        cleaned.changes.push_back(std::move(change));
    }
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (!is_dropped[at(f)]) keep_face(cleaned, mesh.faces[f], f);
    return cleaned;
}

Cleaned drop_bad_loose_edges(const IndexedMesh& mesh) {
    Cleaned cleaned = unchanged(mesh);
    std::vector<bool> is_dropped(mesh.loose_edges.size());
    for (const Defect& defect : defects(mesh)) {
        if (!is_of_loose_edge(defect)) continue;
        const int e = defect.loose_edges.front();
        if (!is_dropped[at(e)])
            cleaned.changes.push_back(
                {.kind = ChangeKind::loose_edge_dropped, .defect = defect});
        is_dropped[at(e)] = true;
    }
    cleaned.mesh.loose_edges.clear();
    for (std::size_t e = 0; e < is_dropped.size(); ++e)
        if (!is_dropped[e])
            cleaned.mesh.loose_edges.push_back(mesh.loose_edges[e]);
    return cleaned;
}

Cleaned fill_holes(const IndexedMesh& mesh, int most_sides) {
    Cleaned cleaned = unchanged(mesh);
    const HalfEdgeTable he = build({mesh.positions, mesh.faces, {}});
    const std::vector<HalfEdge>& rows = he.rows();
    LoopCutter cutter(mesh.vertex_count());
    std::vector<bool> is_seen(rows.size());
    std::vector<int> walk;
    for (int start = 0; start < he.size(); ++start) {
        walk.clear();
        for (int i = start; rows[at(i)].fi == -1 && !is_seen[at(i)];
             i = rows[at(i)].next) {
            is_seen[at(i)] = true;
            walk.push_back(rows[at(i)].vi);
        }
        for (std::vector<int>& loop : cutter.cut(walk)) {
            if (std::ssize(loop) > most_sides) continue;
            keep_face(cleaned, loop, -1);
            cleaned.changes.push_back(
                {.kind = ChangeKind::hole_filled, .vertices = std::move(loop)});
        }
    }
    return cleaned;
}

Cleaned drop_unused_vertices(const IndexedMesh& mesh) {
    // The new number of each vertex, -1: dropped.
    std::vector<int> renamed(mesh.positions.size(), -1);
    const auto use = [&](int v) {
        if (v >= 0 && v < mesh.vertex_count()) renamed[at(v)] = 0;
    };
    std::for_each(mesh.faces.corners().begin(), mesh.faces.corners().end(),
                  use);
    for (const auto& edge : mesh.loose_edges)
        std::for_each(edge.begin(), edge.end(), use);
    Change change{.kind = ChangeKind::vertices_dropped};
    std::vector<Vec3> positions;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (renamed[at(v)] == -1) {
            change.vertices.push_back(v);
            continue;
        }
        renamed[at(v)] = static_cast<int>(positions.size());
        positions.push_back(mesh.positions[at(v)]);
    }
    Cleaned cleaned = renumbered(mesh, renamed, std::move(positions));
    if (!change.vertices.empty()) cleaned.changes.push_back(std::move(change));
    return cleaned;
}

Cleaned clean(IndexedMesh mesh, const CleanOptions& options) {
    Cleaned all = unchanged(std::move(mesh));
    for (const auto step :
         {drop_degenerate_faces, drop_duplicate_faces, drop_bad_loose_edges,
          orient_faces, split_non_manifold})
        append(all, step(all.mesh));
    if (options.most_sides > 0)
        append(all, fill_holes(all.mesh, options.most_sides));
    if (options.drop_unused) append(all, drop_unused_vertices(all.mesh));
    return all;
}

}  // namespace course

#include "exercises/09_processing/report_defects.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace {

using Edge = std::array<int, 2>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Numbers 0 .. n - 1 in groups that grow together (union-find).
class Groups {
public:
    explicit Groups(int n) : above_(at(n)) {
        std::iota(above_.begin(), above_.end(), 0);
    }
    int of(int i) {
        while (above_[at(i)] != i)
            i = above_[at(i)] = above_[at(above_[at(i)])];
        return i;
    }
    void join(int i, int j) { above_[at(of(i))] = of(j); }

private:
    std::vector<int> above_;
};

/// A side of a sound face: the corners that it joins, numbered over all faces.
struct Side {
    int face, corner, next_corner, from;
};

/// The sound faces, their corners, and the sides that lie along each edge.
struct Sound {
    std::vector<int> faces;
    std::vector<int> vertex_of_corner;
    std::map<Edge, std::vector<Side>> edges;
};

bool is_degenerate(FaceList::Face face) {
    return face.size() < 3 ||
           std::set<int>(face.begin(), face.end()).size() < face.size();
}

void add_sides(Sound& sound, FaceList::Face face, int f) {
    int first = static_cast<int>(sound.vertex_of_corner.size());
    int n = static_cast<int>(face.size());
    for (int k = 0; k < n; ++k) {
        int from = face[at(k)];
        int to = face[at((k + 1) % n)];
        sound.vertex_of_corner.push_back(from);
        sound.edges[{std::min(from, to), std::max(from, to)}].push_back(
            {f, first + k, first + (k + 1) % n, from});
    }
}

/// Fills in the faces that are not sound, and returns the others.
Sound sound_faces(const IndexedMesh& mesh, DefectReport& report) {
    Sound sound;
    std::set<std::vector<int>> seen;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
        if (is_degenerate(face)) {
            report.degenerate_faces.push_back(f);
            continue;
        }
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()),
                    face.end());
        if (seen.insert(face).second) {
            sound.faces.push_back(f);
            add_sides(sound, face, f);
        } else {
            report.duplicate_faces.push_back(f);
        }
    }
    return sound;
}

void look_at_edges(const Sound& sound, DefectReport& report) {
    for (const auto& [edge, sides] : sound.edges) {
        if (sides.size() > 2) report.non_manifold_edges.push_back(edge);
        if (sides.size() == 2 && sides[0].from == sides[1].from)
            report.badly_oriented_edges.push_back(edge);
    }
}

/// Joins corners at the same end of an edge; a vertex whose corners make more
/// than one group is no manifold.
void look_at_vertices(const Sound& sound, int vertices, DefectReport& report) {
    Groups fans(static_cast<int>(sound.vertex_of_corner.size()));
    for (const auto& [edge, sides] : sound.edges)
        for (const Side& side : sides) {
            bool alike = side.from == sides[0].from;
            fans.join(sides[0].corner, alike ? side.corner : side.next_corner);
            fans.join(sides[0].next_corner,
                      alike ? side.next_corner : side.corner);
        }
    std::vector<int> count(at(vertices), 0);
    std::vector<bool> used(at(vertices), false);
    for (int c = 0; c < static_cast<int>(sound.vertex_of_corner.size()); ++c) {
        used[at(sound.vertex_of_corner[at(c)])] = true;
        if (fans.of(c) == c) ++count[at(sound.vertex_of_corner[at(c)])];
    }
    for (int v = 0; v < vertices; ++v) {
        if (count[at(v)] > 1) report.non_manifold_vertices.push_back(v);
        if (!used[at(v)]) report.isolated_vertices.push_back(v);
    }
}

int count_components(const Sound& sound, int faces) {
    Groups pieces(faces);
    for (const auto& [edge, sides] : sound.edges)
        for (const Side& side : sides) pieces.join(sides[0].face, side.face);
    std::set<int> distinct;
    for (int f : sound.faces) distinct.insert(pieces.of(f));
    return static_cast<int>(distinct.size());
}

int count_borders(const Sound& sound, int vertices) {
    Groups pieces(vertices);
    std::set<int> ends;
    for (const auto& [edge, sides] : sound.edges) {
        if (sides.size() != 1) continue;
        pieces.join(edge[0], edge[1]);
        ends.insert(edge[0]);
    }
    std::set<int> distinct;
    for (int v : ends) distinct.insert(pieces.of(v));
    return static_cast<int>(distinct.size());
}

}  // namespace

DefectReport report_defects(const IndexedMesh& mesh) {
    DefectReport report;
    Sound sound = sound_faces(mesh, report);
    look_at_edges(sound, report);
    look_at_vertices(sound, mesh.vertex_count(), report);
    report.borders = count_borders(sound, mesh.vertex_count());
    report.components = count_components(sound, mesh.faces.size());
    return report;
}

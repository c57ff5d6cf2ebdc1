#include "grader/suites/09_processing/defect_oracle.h"

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <utility>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/face_lists.h"

namespace course::oracle {

namespace {

using Corners = std::vector<int>;
using Edge = std::array<int, 2>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

bool has_vertex_twice(const Corners& face) {
    for (const int v : face)
        if (std::count(face.begin(), face.end(), v) > 1) return true;
    return false;
}

bool is_rotation(const Corners& a, Corners b) {
    for (std::size_t k = 0; k < b.size(); ++k) {
        if (a == b) return true;
        std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    return false;
}

std::vector<Edge> edges_of(const Corners& face) {
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < face.size(); ++k) {
        const auto [a, b] = std::minmax(face[k], face[(k + 1) % face.size()]);
        edges.push_back({a, b});
    }
    return edges;
}

/// Whether the face runs from the smaller end of the edge to the larger one.
bool runs_upwards(const Corners& face, Edge edge) {
    for (std::size_t k = 0; k < face.size(); ++k)
        if (face[k] == edge[0] && face[(k + 1) % face.size()] == edge[1])
            return true;
    return false;
}

bool has(const std::vector<Edge>& edges, Edge edge) {
    return std::find(edges.begin(), edges.end(), edge) != edges.end();
}

/// How many pieces n things make, of which some lie beside each other.
int pieces(int n, const std::function<bool(int, int)>& beside) {
    std::vector<bool> reached(at(n), false);
    int count = 0;
    for (int first = 0; first < n; ++first) {
        if (reached[at(first)]) continue;
        ++count;
        std::vector<int> open{first};
        reached[at(first)] = true;
        while (!open.empty()) {
            const int i = open.back();
            open.pop_back();
            for (int j = 0; j < n; ++j)
                if (!reached[at(j)] && beside(i, j)) {
                    reached[at(j)] = true;
                    open.push_back(j);
                }
        }
    }
    return count;
}

/// The sound faces; the others go into the report.
std::vector<Corners> sound_only(const IndexedMesh& mesh, DefectReport& report) {
    std::vector<Corners> sound;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const Corners face(mesh.faces[f].begin(), mesh.faces[f].end());
        const auto same = [&](const Corners& other) {
            return is_rotation(face, other);
        };
        if (face.size() < 3 || has_vertex_twice(face))
            report.degenerate_faces.push_back(f);
        else if (std::any_of(sound.begin(), sound.end(), same))
            report.duplicate_faces.push_back(f);
        else
            sound.push_back(face);
    }
    return sound;
}

bool hangs_together(const std::vector<Corners>& sound, int v) {
    std::vector<std::vector<Edge>> at_v;  // for each face the two edges at v
    for (const Corners& face : sound) {
        std::vector<Edge> edges = edges_of(face);
        std::erase_if(edges, [&](Edge e) { return e[0] != v && e[1] != v; });
        if (!edges.empty()) at_v.push_back(edges);
    }
    return pieces(static_cast<int>(at_v.size()), [&](int i, int j) {
               return has(at_v[at(j)], at_v[at(i)][0]) ||
                      has(at_v[at(j)], at_v[at(i)][1]);
           }) < 2;
}

void report_edges(const std::vector<Corners>& sound, DefectReport& report) {
    std::set<Edge> edges;
    for (const Corners& face : sound)
        for (const Edge edge : edges_of(face)) edges.insert(edge);
    std::vector<Edge> border;
    for (const Edge edge : edges) {
        std::vector<bool> upwards;
        for (const Corners& face : sound)
            if (has(edges_of(face), edge))
                upwards.push_back(runs_upwards(face, edge));
        if (upwards.size() == 1) border.push_back(edge);
        if (upwards.size() > 2) report.non_manifold_edges.push_back(edge);
        if (upwards.size() == 2 && upwards[0] == upwards[1])
            report.badly_oriented_edges.push_back(edge);
    }
    report.borders = pieces(static_cast<int>(border.size()), [&](int i, int j) {
        const Edge a = border[at(i)], b = border[at(j)];
        return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
    });
}

}  // namespace

DefectReport all_defects(const IndexedMesh& mesh) {
    DefectReport report;
    const std::vector<Corners> sound = sound_only(mesh, report);
    report_edges(sound, report);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const bool used =
            std::any_of(sound.begin(), sound.end(), [&](const Corners& face) {
                return std::count(face.begin(), face.end(), v) > 0;
            });
        if (!used) report.isolated_vertices.push_back(v);
        if (!hangs_together(sound, v))
            report.non_manifold_vertices.push_back(v);
    }
    report.components =
        pieces(static_cast<int>(sound.size()), [&](int i, int j) {
            for (const Edge edge : edges_of(sound[at(i)]))
                if (has(edges_of(sound[at(j)]), edge)) return true;
            return false;
        });
    return report;
}

}  // namespace course::oracle

namespace course::hidden {

namespace {

using Faces = std::vector<std::vector<int>>;

std::size_t up_to(std::mt19937_64& random, std::size_t n) {
    return static_cast<std::size_t>(random() % n);
}

void spoil_faces(Faces& faces, std::mt19937_64& random) {
    const std::size_t n = faces.size();
    for (int k = 0; k < 3; ++k) {
        std::vector<int>& flipped = faces[up_to(random, n)];
        std::reverse(flipped.begin(), flipped.end());
        std::vector<int> again = faces[up_to(random, n)];
        std::rotate(again.begin(), again.begin() + 1, again.end());
        faces.push_back(again);
        std::vector<int> twice = faces[up_to(random, n)];
        twice.insert(twice.begin() + 1, twice[up_to(random, twice.size())]);
        faces.push_back(twice);
        faces.push_back({twice[0], twice[1]});
    }
    std::vector<int> behind = faces[up_to(random, n)];
    std::reverse(behind.begin(), behind.end());
    faces.push_back(behind);
}

void add_fins(Faces& faces, int vertices, std::mt19937_64& random) {
    const std::size_t n = faces.size();
    for (int k = 0; k < 4; ++k) {
        const std::vector<int>& face = faces[up_to(random, n)];
        const int tip =
            static_cast<int>(up_to(random, static_cast<std::size_t>(vertices)));
        faces.push_back({face[0], face[1], tip});
    }
}

}  // namespace

Fixture dirty_scan(std::uint64_t salt) {
    std::mt19937_64 random(seed() * 1000 + salt);
    RandomMesh options;
    options.faces = 40;
    options.parts = 2;
    options.hole_percent = 10;
    options.surface = salt % 2 == 0 ? Surface::mixed : Surface::open;
    options.bow_ties = BowTies::allowed;
    options.unused = Unused::kept;
    IndexedMesh mesh = random_polygons(seed() * 100 + salt, options);
    Faces faces;
    const auto n = static_cast<std::size_t>(mesh.vertex_count());
    const int lost = static_cast<int>(up_to(random, n));
    const int kept = static_cast<int>(up_to(random, n));
    for (const FaceList::Face face : mesh.faces) {
        faces.emplace_back(face.begin(), face.end());
        std::replace(faces.back().begin(), faces.back().end(), lost, kept);
    }
    spoil_faces(faces, random);
    add_fins(faces, mesh.vertex_count(), random);
    mesh.faces = {};
    for (const std::vector<int>& face : faces) mesh.faces.push_back(face);
    return {"dirty scan " + std::to_string(salt), shuffled(mesh, salt), {}};
}

}  // namespace course::hidden

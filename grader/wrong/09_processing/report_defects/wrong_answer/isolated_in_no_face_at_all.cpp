// A vertex of a degenerate face only does not count as isolated.
// Hint: You do not call a vertex isolated that only degenerate faces have for
// a corner.
#include "exercises/09_processing/report_defects.h"

#include <algorithm>
#include <map>
#include <set>

namespace {

using Edge = std::array<int, 2>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int top(std::vector<int>& up, int i) {
    while (up[at(i)] != i) i = up[at(i)] = up[at(up[at(i)])];
    return i;
}

std::vector<int> singles(int n) {
    std::vector<int> up;
    for (int i = 0; i < n; ++i) up.push_back(i);
    return up;
}

}  // namespace

DefectReport report_defects(const IndexedMesh& mesh) {
    DefectReport report;
    std::set<std::vector<int>> seen;
    std::vector<int> sound;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
        std::set<int> distinct(face.begin(), face.end());
        if (face.size() < 3 || distinct.size() < face.size()) {
            report.degenerate_faces.push_back(f);
            continue;
        }
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()),
                    face.end());
        if (!seen.insert(face).second) {
            report.duplicate_faces.push_back(f);
            continue;
        }
        sound.push_back(f);
    }

    std::map<Edge, std::vector<Edge>> uses;
    std::map<Edge, std::vector<int>> faces_of;
    for (int f : sound) {
        FaceList::Face face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k];
            int b = face[(k + 1) % face.size()];
            uses[{std::min(a, b), std::max(a, b)}].push_back({a, b});
            faces_of[{std::min(a, b), std::max(a, b)}].push_back(f);
        }
    }

    std::vector<int> rim = singles(mesh.vertex_count());
    std::set<int> on_rim;
    for (const auto& [edge, list] : uses) {
        if (list.size() > 2) report.non_manifold_edges.push_back(edge);
        if (list.size() == 2 && list[0] == list[1])
            report.badly_oriented_edges.push_back(edge);
        if (list.size() == 1) {
            rim[at(top(rim, edge[0]))] = top(rim, edge[1]);
            on_rim.insert(edge[0]);
        }
    }
    std::set<int> rims;
    for (int v : on_rim) rims.insert(top(rim, v));
    report.borders = static_cast<int>(rims.size());

    std::vector<int> piece = singles(mesh.faces.size());
    for (const auto& [edge, list] : faces_of)
        for (int f : list) piece[at(top(piece, f))] = top(piece, list[0]);
    std::set<int> pieces;
    for (int f : sound) pieces.insert(top(piece, f));
    report.components = static_cast<int>(pieces.size());

    std::map<int, std::map<int, int>> fans;  // by vertex: face -> fan
    for (int f : sound)
        for (int v : mesh.faces[f]) fans[v][f] = f;
    for (const auto& [edge, list] : faces_of)
        for (int v : edge)
            for (int f : list) {
                std::map<int, int>& fan = fans[v];
                auto up = [&](int i) {
                    while (fan[i] != i) i = fan[i];
                    return i;
                };
                fan[up(f)] = up(list[0]);
            }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        int count = 0;
        for (const auto& [f, above] : fans[v]) count += f == above;
        const std::vector<int>& all = mesh.faces.corners();
        if (count == 0 && std::count(all.begin(), all.end(), v) == 0) report.isolated_vertices.push_back(v);
        if (count > 1) report.non_manifold_vertices.push_back(v);
    }
    return report;
}

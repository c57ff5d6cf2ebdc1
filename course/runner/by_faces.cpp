// Brute force over the face list.
#include "course/runner/by_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace course::oracle {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

int wrapped(int k, FaceList::Face face) {
    return k % static_cast<int>(face.size());
}

/// Corner k of a face, counted on beyond its end.
int vertex(FaceList::Face face, int k) {
    return face[at(wrapped(k, face))];
}

}  // namespace

ByFaces::ByFaces(const Fixture& fixture)
    : fixture_(fixture), corners_(fixture.mesh.positions.size()) {
    const Wanted all(corners_.size(), true);
    add_faces(all);
    add_gaps(all);
}

ByFaces::ByFaces(const Fixture& fixture, const std::vector<int>& asked)
    : fixture_(fixture), corners_(fixture.mesh.positions.size()) {
    const Wanted wanted = near(asked);
    add_faces(wanted);
    add_gaps(wanted);
}

ByFaces::Wanted ByFaces::near(const std::vector<int>& asked) const {
    Wanted wanted(corners_.size(), false);
    for (const int i : asked) {
        wanted[at(start(i))] = wanted[at(tip(i))] = true;
        const int f = fixture_.he.rows()[at(i)].fi;
        if (f == -1) continue;
        for (const int v : fixture_.mesh.faces[f]) wanted[at(v)] = true;
    }
    return wanted;
}

void ByFaces::add_faces(const Wanted& wanted) {
    for (int f = 0; f < fixture_.mesh.faces.size(); ++f) {
        const FaceList::Face face = fixture_.mesh.faces[f];
        const int n = static_cast<int>(face.size());
        for (int k = 0; k < n; ++k)
            if (wanted.at(at(face[at(k)])))
                corners_[at(face[at(k)])].push_back(
                    {f, vertex(face, k + n - 1), vertex(face, k + 1), -1});
    }
}

/// Adds a corner where a half-edge arrives along which no face comes; then
/// tells each corner the half-edge that leaves by it.
void ByFaces::add_gaps(const Wanted& wanted) {
    const std::vector<HalfEdge>& rows = fixture_.he.rows();
    std::vector<int> leaving;
    for (int i = 0; i < fixture_.he.size(); ++i)
        if (wanted.at(at(start(i)))) leaving.push_back(i);
    for (const int i : leaving) {
        std::vector<Corner>& corners = corners_[at(start(i))];
        const int on = rows[at(rows[at(i)].opp)].next;
        if (std::ranges::find(corners, tip(i), &Corner::before) ==
            corners.end())
            corners.push_back({-1, tip(i), tip(on), -1});
    }
    for (const int i : leaving)
        std::ranges::find(corners_[at(start(i))], tip(i), &Corner::after)
            ->half_edge = i;
}

int ByFaces::start(int i) const {
    return fixture_.he.rows()[at(i)].vi;
}

int ByFaces::tip(int i) const {
    return start(fixture_.he.rows()[at(i)].opp);
}

const std::vector<ByFaces::Corner>& ByFaces::corners_at(int v) const {
    return corners_[at(v)];
}

int ByFaces::face_from_to(int a, int b) const {
    const auto corner = std::ranges::find(corners_at(a), b, &Corner::after);
    return corner == corners_at(a).end() ? -1 : corner->face;
}

int ByFaces::face(int i) const {
    return face_from_to(start(i), tip(i));
}

int ByFaces::face_sides(int i) const {
    const int f = face(i);
    return f == -1 ? 0 : static_cast<int>(fixture_.mesh.faces[f].size());
}

std::vector<int> ByFaces::face_vertices(int i) const {
    const int f = face(i);
    if (f == -1) return {};
    const FaceList::Face corners = fixture_.mesh.faces[f];
    int first = 0;
    while (vertex(corners, first) != start(i) ||
           vertex(corners, first + 1) != tip(i))
        ++first;
    std::vector<int> vertices;
    for (int k = 0; k < static_cast<int>(corners.size()); ++k)
        vertices.push_back(vertex(corners, first + k));
    return vertices;
}

/// The corners round the start of i, each beginning where the one before it
/// ends; the first is the one that half-edge i leaves.
std::vector<ByFaces::Corner> ByFaces::round(int i) const {
    const std::vector<Corner>& corners = corners_at(start(i));
    std::vector<Corner> found = {
        *std::ranges::find(corners, tip(i), &Corner::after)};
    while (true) {
        const auto on =
            std::ranges::find(corners, found.back().after, &Corner::before);
        if (on == corners.end() || found.size() > corners.size())
            throw std::logic_error(
                fmt::format("{}: the faces at vertex {} do not close",
                            fixture_.name, start(i)));
        if (on->after == found.front().after) return found;
        found.push_back(*on);
    }
}

std::vector<int> ByFaces::vertex_star(int i) const {
    std::vector<int> neighbours;
    for (const Corner& corner : round(i)) neighbours.push_back(corner.after);
    return neighbours;
}

std::vector<int> ByFaces::outgoing(int i) const {
    std::vector<int> half_edges;
    for (const Corner& corner : round(i))
        half_edges.push_back(corner.half_edge);
    return half_edges;
}

std::vector<int> ByFaces::faces_met(int i) const {
    std::vector<int> faces;
    for (const Corner& corner : round(i))
        if (corner.face != -1) faces.push_back(corner.face);
    return faces;
}

std::optional<int> ByFaces::face_across(int i) const {
    const int f = face_from_to(tip(i), start(i));
    return f == -1 ? std::nullopt : std::optional<int>(f);
}

int ByFaces::adjacent_edge_count(int i) const {
    const std::vector<int> corners = face_vertices(i);
    int count = 0;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (face_from_to(corners[(k + 1) % corners.size()], corners[k]) != -1)
            ++count;
    return count;
}

std::vector<int> ByFaces::adjacent_faces(int i) const {
    const std::vector<int> corners = face_vertices(i);
    std::set<int> others;
    for (std::size_t k = 0; k < corners.size(); ++k)
        others.insert(
            face_from_to(corners[(k + 1) % corners.size()], corners[k]));
    others.erase(-1);
    others.erase(face(i));
    return {others.begin(), others.end()};
}

int ByFaces::vertex_degree(int i) const {
    return static_cast<int>(round(i).size());
}

std::map<int, int> ByFaces::valences() const {
    std::map<int, int> histogram;
    for (const std::vector<Corner>& corners : corners_) {
        std::set<int> neighbours;
        for (const Corner& corner : corners)
            neighbours.insert({corner.before, corner.after});
        ++histogram[static_cast<int>(neighbours.size())];
    }
    return histogram;
}

Place ByFaces::place_of_vertex(int i) const {
    const std::vector<Corner>& corners = corners_at(start(i));
    const auto gaps = std::ranges::count(corners, -1, &Corner::face);
    std::set<int> faces;
    for (const Corner& corner : corners) faces.insert(corner.face);
    const bool twice = faces.size() < corners.size();
    const bool one_fan = round(i).size() == corners.size();
    const bool no_face = faces == std::set<int>{-1};
    if (twice || !one_fan || no_face) return Place::degenerate;
    return gaps == 0 ? Place::interior : Place::border;
}

Place ByFaces::place_of_edge(int i) const {
    const int f = face(i);
    const std::optional<int> across = face_across(i);
    if (across.value_or(-1) == f) return Place::degenerate;
    return f != -1 && across ? Place::interior : Place::border;
}

Place ByFaces::place_of_face(int i) const {
    const auto shared = static_cast<std::size_t>(adjacent_edge_count(i));
    const std::size_t neighbours = adjacent_faces(i).size();
    if (place_of_edge(i) == Place::degenerate || neighbours < shared)
        return Place::degenerate;
    return shared > 0 && shared == face_vertices(i).size() ? Place::interior
                                                           : Place::border;
}

}  // namespace course::oracle

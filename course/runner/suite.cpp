#include "course/runner/suite.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "course/halfedge/build.h"
#include "course/halfedge/renumber.h"
#include "course/mesh/generators.h"
#include "course/runner/case_record.h"
#include "course/runner/client.h"

namespace Catch {

std::string StringMaker<Fault>::convert(Fault fault) {
    constexpr std::array<const char*, 11> names = {
        "vertex_out_of_range", "face_out_of_range", "next_out_of_range",
        "opp_out_of_range",    "opp_is_itself",     "opp_not_mutual",
        "opp_same_start",      "next_not_at_tip",   "next_changes_face",
        "next_shared",         "face_in_two_loops"};
    const auto index = static_cast<std::size_t>(fault);
    return index < names.size() ? names[index] : "no fault that there is";
}

std::string StringMaker<HalfEdgeTable>::convert(const HalfEdgeTable& he) {
    constexpr int most = 24;
    std::string text = "{ ";
    for (int i = 0; i < he.size() && i < most; ++i)
        text +=
            (i > 0 ? ", " : "") +
            ::Catch::Detail::stringify(he.rows()[static_cast<std::size_t>(i)]);
    if (he.size() > most)
        text += ", ... " + std::to_string(he.size() - most) + " more";
    return text + " }";
}

std::string StringMaker<FaceList>::convert(const FaceList& faces) {
    constexpr int most = 60;
    std::vector<std::vector<int>> lists;
    for (int f = 0; f < faces.size() && f < most; ++f)
        lists.emplace_back(faces[f].begin(), faces[f].end());
    std::string text = ::Catch::Detail::stringify(lists);
    if (faces.size() > most)
        text += " and " + std::to_string(faces.size() - most) + " more";
    return text;
}

}  // namespace Catch

namespace course {

namespace {

std::uint64_t the_seed = 1;

/// Begun where the list reads smallest, so that repeated numbers do no harm.
/// Linear: whatever follows i loses against j as soon as one number does.
/// (Booth's least rotation, in the form with two candidates.)
std::vector<int> rotated_to_smallest(std::vector<int> cycle) {
    const std::size_t n = cycle.size();
    std::size_t i = 0, j = 1, same = 0;
    while (i < n && j < n && same < n) {
        const int a = cycle[(i + same) % n];
        const int b = cycle[(j + same) % n];
        if (a == b) {
            ++same;
            continue;
        }
        (a > b ? i : j) += same + 1;
        if (i == j) ++j;
        same = 0;
    }
    std::rotate(cycle.begin(),
                cycle.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)),
                cycle.end());
    return cycle;
}

/// Nobody reads more, and a hostile answer may be megabytes long.
void shorten(std::string& text) {
    constexpr std::size_t most = 4000;
    if (text.size() > most) text = text.substr(0, most) + " ... (cut)";
}

std::vector<int> sorted(std::vector<int> list) {
    std::sort(list.begin(), list.end());
    return list;
}

std::vector<std::vector<int>> sorted_loops(
    std::vector<std::vector<int>> loops) {
    for (std::vector<int>& loop : loops)
        loop = rotated_to_smallest(std::move(loop));
    std::sort(loops.begin(), loops.end());
    return loops;
}

}  // namespace

void CaseRecord::add(Verdict failed, Failure failure) {
    constexpr std::size_t most = 3;
    verdict = std::max(verdict, failed);
    for (std::string* text :
         {&failure.call, &failure.expected, &failure.got, &failure.note})
        shorten(*text);
    if (failures.size() < most) failures.push_back(std::move(failure));
}

CaseRecord& case_record() {
    static CaseRecord record;
    return record;
}

void set_seed(std::uint64_t seed) {
    the_seed = seed;
}

std::uint64_t seed() {
    return the_seed;
}

void hint(std::string text) {
    case_record().hint = std::move(text);
}

OnMesh::OnMesh(const Fixture& fixture) {
    case_record().meshes.push_back(&fixture);
}

OnMesh::~OnMesh() {
    case_record().meshes.pop_back();
}

ReadBudget::ReadBudget(const HalfEdgeTable& he, std::int64_t reads) : he_(he) {
    he_.begin_call(reads);
}

ReadBudget::~ReadBudget() {
    he_.begin_call(HalfEdgeTable::unwatched);
}

AskAhead::AskAhead(const HalfEdgeTable& he, std::vector<int> starts) {
    if (Client::current() != nullptr)
        Client::current()->ask_ahead(he, std::move(starts));
}

std::vector<int> all_half_edges(const HalfEdgeTable& he) {
    std::vector<int> all(static_cast<std::size_t>(he.size()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

AskAhead::~AskAhead() {
    if (Client::current() != nullptr) Client::current()->stop_asking_ahead();
}

Fixture renumbered(const Fixture& fixture, std::uint64_t salt) {
    if (fixture.he.empty() && !fixture.mesh.faces.empty())
        throw std::logic_error(fixture.name + " has no table to renumber");
    Renumbering map = renumber_all(fixture.he, seed() * 1000 + salt);
    Fixture result{fixture.name + " (renumbered)", fixture.mesh,
                   std::move(map.he)};
    for (std::size_t v = 0; v < fixture.mesh.positions.size(); ++v)
        if (v < map.vertex.size() && map.vertex[v] >= 0)
            result.mesh.positions[static_cast<std::size_t>(map.vertex[v])] =
                fixture.mesh.positions[v];
    std::vector<int> face_at(
        static_cast<std::size_t>(fixture.mesh.faces.size()));
    for (std::size_t f = 0; f < face_at.size(); ++f)
        face_at[static_cast<std::size_t>(map.face[f])] = static_cast<int>(f);
    result.mesh.faces = {};
    for (const int f : face_at) {
        std::vector<int> corners;
        for (const int v : fixture.mesh.faces[f])
            corners.push_back(map.vertex[static_cast<std::size_t>(v)]);
        result.mesh.faces.push_back(corners);
    }
    for (auto& edge : result.mesh.loose_edges)
        for (int& v : edge) v = map.vertex[static_cast<std::size_t>(v)];
    return result;
}

std::vector<Fixture> all_fixtures() {
    std::vector<Fixture> all = zoo::with_table();
    const std::size_t n = all.size();
    for (std::size_t k = 0; k < n; ++k) all.push_back(renumbered(all[k], k));
    return all;
}

std::vector<Fixture> generated_fixtures() {
    std::vector<Fixture> all;
    // The first one can be drawn.
    constexpr Surface surfaces[] = {Surface::plane,  Surface::closed,
                                    Surface::mixed,  Surface::open,
                                    Surface::closed, Surface::mixed};
    for (std::uint64_t k = 0; k < std::size(surfaces); ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k) / 2;
        options.surface = surfaces[k];
        const IndexedMesh mesh = random_polygons(seed() * 100 + k, options);
        all.push_back(renumbered({"", mesh, build(mesh)}, k));
        all.back().name = "generated mesh " + std::to_string(k);
    }
    return all;
}

namespace {

LargeMesh copies_of_grid() {
    constexpr int side = 25, count = 387;
    const IndexedMesh mesh = grid(side, side);
    const HalfEdgeTable tile = build(mesh);
    Copies copies{tile.rows(), mesh.vertex_count(), mesh.faces.size(), count,
                  seed()};
    const MixedNumbers half_edges(tile.size(), copies);
    const MixedNumbers vertices(copies.vertices, copies);
    const MixedNumbers faces(copies.faces, copies);
    return {{"a grid of 25 x 25 quads", mesh, tile},
            copies,
            table_of(copies),
            half_edges,
            vertices,
            faces};
}

std::vector<int> renamed(std::vector<int> list, const MixedNumbers& numbers,
                         int copy) {
    for (int& number : list) number = numbers(number, copy);
    return list;
}

}  // namespace

const LargeMesh& a_million_half_edges() {
    static const LargeMesh mesh = copies_of_grid();
    if (Client::current() != nullptr) {
        Client::current()->limit_cpu(large_mesh_cpu);
        Client::current()->send_as(mesh.he, mesh.copies);
    }
    return mesh;
}

std::vector<int> InLargeMesh::half_edges(std::vector<int> of_tile) const {
    return renamed(std::move(of_tile), mesh->half_edges, copy);
}

std::vector<int> InLargeMesh::vertices(std::vector<int> of_tile) const {
    return renamed(std::move(of_tile), mesh->vertices, copy);
}

std::vector<int> InLargeMesh::faces(std::vector<int> of_tile) const {
    return renamed(std::move(of_tile), mesh->faces, copy);
}

std::vector<InLargeMesh> some_of(const LargeMesh& mesh, int n) {
    std::vector<InLargeMesh> some;
    some.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
        some.push_back(
            {&mesh, k % mesh.tile.he.size(),
             static_cast<int>(std::int64_t{k} * mesh.copies.count / n)});
    return some;
}

}  // namespace course

course::ListMatcher<std::vector<int>> IsRotationOf(std::vector<int> expected) {
    return {std::move(expected), course::rotated_to_smallest,
            "is, begun anywhere: "};
}

course::ListMatcher<std::vector<int>> IsPermutationOf(
    std::vector<int> expected) {
    return {std::move(expected), course::sorted, "is, in any order: "};
}

course::ListMatcher<std::vector<std::vector<int>>> AreLoops(
    std::vector<std::vector<int>> expected) {
    return {std::move(expected), course::sorted_loops,
            "is, in any order and each begun anywhere: "};
}

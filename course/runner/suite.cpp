#include "course/runner/suite.h"

#include <algorithm>
#include <array>
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

AskAhead::~AskAhead() {
    if (Client::current() != nullptr) Client::current()->stop_asking_ahead();
}

Fixture renumbered(const Fixture& fixture, std::uint64_t salt) {
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
    constexpr Surface surfaces[] = {Surface::open, Surface::closed,
                                    Surface::mixed};
    for (std::uint64_t k = 0; k < 6; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k) / 2;
        options.surface = surfaces[k % 3];
        const IndexedMesh mesh = random_polygons(seed() * 100 + k, options);
        Fixture fixture{"generated mesh " + std::to_string(k), mesh,
                        build(mesh)};
        all.push_back(renumbered(fixture, k));
    }
    return all;
}

const Fixture& a_million_half_edges() {
    if (Client::current() != nullptr) Client::current()->limit_cpu(1);
    static const Fixture fixture = [] {
        const IndexedMesh mesh = grid(500, 500);
        return renumbered({"a grid of 500 x 500 quads", mesh, build(mesh)});
    }();
    return fixture;
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

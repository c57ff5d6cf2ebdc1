// How a mesh on which a check fails is made smaller, and what is reported then.
#include "course/runner/smallest_failing.h"

#include <algorithm>
#include <utility>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/case_record.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

constexpr int plenty = 1000;

bool has_face_of(const IndexedMesh& mesh, std::size_t sides) {
    return std::ranges::any_of(
        mesh.faces, [&](FaceList::Face face) { return face.size() >= sides; });
}

/// Whether two faces have an edge in common.
bool has_neighbours(const IndexedMesh& mesh) {
    const std::vector<HalfEdge> rows = build(mesh).rows();
    return std::ranges::any_of(rows, [&](const HalfEdge& row) {
        return row.fi != -1 && rows[static_cast<std::size_t>(row.opp)].fi != -1;
    });
}

IndexedMesh generated(std::uint64_t seed, BowTies bow_ties = BowTies::none) {
    RandomMesh options;
    options.faces = 200;
    options.hole_percent = 20;
    options.bow_ties = bow_ties;
    return random_polygons(seed, options);
}

/// What a suite and the judge's listener would do.
void note_failure(const std::string& call) {
    Failure failure;
    failure.call = call;
    case_record().add(Verdict::wrong_answer, failure);
}

/// The failures of a case with this check on one mesh.
std::vector<Failure> failures_of(
    const IndexedMesh& mesh, const std::function<void(const Fixture&)>& check) {
    case_record() = {};
    on_generated_meshes({{"a mesh", mesh, build(mesh)}}, check);
    CHECK(case_record().meshes.empty());
    return std::exchange(case_record(), {}).failures;
}

}  // namespace

TEST_CASE("what is needed is left, and nothing else") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const IndexedMesh mesh = generated(seed);
        for (const std::size_t sides : {3U, 5U}) {
            const IndexedMesh face = smallest_failing(
                mesh,
                [&](const auto& part) { return has_face_of(part, sides); },
                plenty);
            REQUIRE(face.faces.size() == 1);
            CHECK(face.faces[0].size() >= sides);
            CHECK(face.positions.size() == face.faces[0].size());
        }
        const IndexedMesh two = smallest_failing(mesh, has_neighbours, plenty);
        CHECK(two.faces.size() == 2);
    }
}

TEST_CASE("a face is tried again when another one is gone") {
    const IndexedMesh mesh = grid(3, 1);
    const auto has = [&](const IndexedMesh& part, std::size_t corner) {
        return std::ranges::find(part.positions, mesh.positions[corner]) !=
               part.positions.end();
    };
    // The two on the left, and then the one in the middle.
    const auto is_wrong = [&](const IndexedMesh& part) {
        return has(part, 0) == (part.faces.size() > 1) && !has(part, 3);
    };
    CHECK(smallest_failing(mesh, is_wrong, plenty).faces.size() == 1);
}

TEST_CASE("many faces are left out at a time") {
    const IndexedMesh mesh = torus(60, 60);
    int asked = 0;
    const auto is_there = [&](const IndexedMesh& part) {
        ++asked;
        return std::ranges::find(part.positions, mesh.positions[1234]) !=
               part.positions.end();
    };
    CHECK(smallest_failing(mesh, is_there, plenty).faces.size() == 1);
    CHECK(asked < 60);
}

TEST_CASE("a part is asked about only if it has a table, a face, no bow-tie") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        int asked = 0;
        const auto is_allowed = [&](const IndexedMesh& part) {
            ++asked;
            CHECK(defects(part).empty());
            CHECK(bow_tie_vertices(part).empty());
            CHECK_FALSE(part.faces.empty());
            return part.faces.size() > 20;
        };
        const IndexedMesh mesh = generated(seed);
        const IndexedMesh least = smallest_failing(mesh, is_allowed, plenty);
        CHECK(least.faces.size() == 21);
        CHECK(asked > 20);
    }
}

TEST_CASE("a mesh with bow-ties may stay one") {
    const auto has_bow_tie = [](const IndexedMesh& part) {
        return !bow_tie_vertices(part).empty();
    };
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const IndexedMesh mesh = generated(seed, BowTies::allowed);
        if (!has_bow_tie(mesh)) continue;
        ++found;
        const IndexedMesh least = smallest_failing(mesh, has_bow_tie, plenty);
        CHECK(least.faces.size() == 2);
    }
    CHECK(found > 0);
}

TEST_CASE("no more is asked than is allowed, and no answer is believed twice") {
    const IndexedMesh mesh = generated(1);
    int asked = 0;
    const auto never = [&](const IndexedMesh&) { return ++asked, false; };
    CHECK(smallest_failing(mesh, never, 10) == mesh);
    CHECK(asked == 10);
    CHECK(smallest_failing(mesh, never, 0) == mesh);

    IndexedMesh last;
    const auto by_turns = [&](const IndexedMesh& part) {
        if (++asked % 3 != 0) return false;
        last = part;
        return true;
    };
    const IndexedMesh least = smallest_failing(mesh, by_turns, plenty);
    CHECK(least.faces.size() < mesh.faces.size());
    CHECK(least == last);
}

TEST_CASE("a failure is told once, on the smallest mesh, with its origin") {
    const IndexedMesh mesh = generated(1);
    const auto failures = failures_of(mesh, [](const Fixture& part) {
        if (has_face_of(part.mesh, 5))
            note_failure(std::to_string(part.mesh.faces.size()) + " faces");
    });
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].call == "1 faces");
    CHECK(failures[0].note == "found on a mesh (seed 1), shrunk from " +
                                  std::to_string(mesh.faces.size()) +
                                  " faces to 1");
}

TEST_CASE("a failure that does not come again is told on its own mesh") {
    const IndexedMesh mesh = generated(1);
    int calls = 0;
    const auto failures = failures_of(mesh, [&](const Fixture& part) {
        if (++calls == 1)
            note_failure(std::to_string(part.he.size()) + " rows");
    });
    CHECK(calls > 1);
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].call == std::to_string(build(mesh).size()) + " rows");
    CHECK(failures[0].note == "found on a mesh (seed 1)");
}

TEST_CASE("a failure of another kind is not taken for the same") {
    const auto failures = failures_of(generated(1), [](const Fixture& part) {
        if (part.mesh.faces.size() > 10) return note_failure("many");
        case_record().add(Verdict::run_time_error, {});
    });
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].call == "many");
    CHECK(failures[0].note.ends_with(" to 11"));
}

TEST_CASE("what depends on the numbering is shrunk with other numbers") {
    // As a mesh is built, opposites lie side by side.
    const auto check = [](const Fixture& part) {
        for (std::size_t i = 0; i < part.he.rows().size(); ++i)
            if (part.he.rows()[i].opp != static_cast<int>(i ^ 1))
                return note_failure(part.name);
    };
    case_record() = {};
    on_generated_meshes(generated_fixtures(), check);
    const auto failures = std::exchange(case_record(), {}).failures;
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].call == "generated mesh 0, shrunk (renumbered)");
    CHECK(failures[0].note.ends_with(" to 1"));
}

TEST_CASE("on a mesh that passes, nothing is recorded and all are asked") {
    int calls = 0;
    case_record() = {};
    on_generated_meshes(generated_fixtures(), [&](const Fixture&) { ++calls; });
    CHECK(calls == 6);
    CHECK(case_record().verdict == Verdict::accepted);
    CHECK(case_record().failures.empty());
}

TEST_CASE("what ends a check ends the case, with the record of the smallest") {
    case_record() = {};
    hint("kept");
    const auto check = [](const Fixture& part) {
        note_failure(part.name);
        throw std::runtime_error("the end");
    };
    CHECK_THROWS_WITH(on_generated_meshes(generated_fixtures(), check),
                      "the end");
    CHECK(case_record().verdict == Verdict::wrong_answer);
    REQUIRE(case_record().failures.size() == 1);
    CHECK(case_record().failures[0].call == "generated mesh 0, shrunk");
    CHECK(case_record().hint == "kept");
    // One that records nothing is no failure to be made smaller.
    int calls = 0;
    case_record() = {};
    const auto stumble = [&](const Fixture&) {
        ++calls;
        throw std::logic_error("ours");
    };
    CHECK_THROWS_AS(on_generated_meshes(generated_fixtures(), stumble),
                    std::logic_error);
    CHECK(calls == 1);
    case_record() = {};
}

// A check on generated meshes, and the smallest mesh on which it fails.
#include <fmt/format.h>

#include <exception>
#include <utility>

#include "course/halfedge/build.h"
#include "course/runner/case_record.h"
#include "course/runner/client.h"
#include "course/runner/smallest_failing.h"
#include "course/runner/suite.h"

namespace course {

namespace {

// Mostly a few dozens are enough, and less than 50 ms.
constexpr int most_smaller_meshes = 250;
// Of all of them together. No limit in time: reports are to be the same on a
// busy machine.
constexpr int most_half_edges = 20'000;

using Check = std::function<void(const Fixture&)>;

/// What came of the check on one mesh.
struct Outcome {
    Verdict verdict = Verdict::accepted;
    std::vector<Failure> failures = {};
    std::exception_ptr thrown = nullptr;  ///< what ended it, if anything did
};

/// Carries out the check, and keeps what it records apart from the case.
Outcome outcome_on(const Fixture& mesh, const Check& check) {
    CaseRecord of_the_case = std::exchange(case_record(), {});
    Outcome outcome;
    try {
        const OnMesh on(mesh);
        check(mesh);
    } catch (...) {
        outcome.thrown = std::current_exception();
    }
    CaseRecord now = std::exchange(case_record(), std::move(of_the_case));
    outcome.verdict = now.verdict;
    outcome.failures = std::move(now.failures);
    return outcome;
}

/// Looks for smaller meshes on which the check fails as it did on the first.
class Search {
public:
    Search(const Fixture& first, const Check& check, Outcome outcome)
        : first_(first), check_(check), smallest_(std::move(outcome)) {}

    /// Numbered as it is built, which is easier to read, or else anew.
    bool fails_on(const IndexedMesh& mesh) {
        const Fixture built{first_.name + ", shrunk", mesh, build(mesh)};
        if (!fails_alike(built) && !fails_alike(renumbered(built)))
            return false;
        shrunk_ = fmt::format(", shrunk from {} faces to {}",
                              first_.mesh.faces.size(), mesh.faces.size());
        return true;
    }

    /// Records the failure on the smallest mesh, and where that comes from.
    void report() {
        for (Failure& failure : smallest_.failures) {
            failure.note += fmt::format("found on {} (seed {}){}", first_.name,
                                        seed(), shrunk_);
            case_record().add(smallest_.verdict, std::move(failure));
        }
    }

private:
    bool fails_alike(const Fixture& mesh) {
        Client* client = Client::current();
        left_ -= mesh.he.size();
        if (left_ < 0 || (client != nullptr && !client->try_again()))
            return false;
        Outcome outcome = outcome_on(mesh, check_);
        if (outcome.verdict != smallest_.verdict) return false;
        smallest_ = std::move(outcome);
        return true;
    }

    const Fixture& first_;
    const Check& check_;
    Outcome smallest_;
    int left_ = most_half_edges;
    std::string shrunk_;  ///< how far, in words
};

void report_smallest(const Fixture& mesh, const Outcome& outcome,
                     const Check& check) {
    Search search(mesh, check, outcome);
    smallest_failing(
        mesh.mesh,
        [&](const IndexedMesh& smaller) { return search.fails_on(smaller); },
        most_smaller_meshes);
    search.report();
}

}  // namespace

void on_generated_meshes(const std::vector<Fixture>& meshes,
                         const Check& check) {
    for (const Fixture& mesh : meshes) {
        const Outcome outcome = outcome_on(mesh, check);
        if (outcome.verdict != Verdict::accepted)
            report_smallest(mesh, outcome, check);
        if (outcome.thrown) std::rethrow_exception(outcome.thrown);
        if (outcome.verdict != Verdict::accepted) return;
    }
}

}  // namespace course

#include "grader/cli/past_results.h"

#include <fmt/format.h>

#include <set>

#include "course/report/text.h"
#include "course/runner/nearest.h"
#include "grader/cli/commands.h"
#include "grader/report/class_results.h"

namespace grader {

namespace {

std::string score_text(const std::optional<course::Verdict>& verdict,
                       double points) {
    return verdict ? fmt::format("{:g} ({})", points, words(*verdict))
                   : "no grade";
}

bool changes_score(const Change& change) {
    return !change.old_verdict || change.points != change.old_points;
}

}  // namespace

void expect_gradebook(const std::filesystem::path& out) {
    if (!std::filesystem::exists(out / "gradebook.sqlite"))
        throw CannotBegin(fmt::format(
            "{}: has no gradebook.sqlite; expected the folder of an earlier "
            "`grader run`",
            out.string()));
}

Gradebook gradebook_in(const std::filesystem::path& out,
                       Gradebook::Access access) {
    expect_gradebook(out);
    return Gradebook(out / "gradebook.sqlite", access);
}

Assignment unweighted_assignment(const Gradebook& gradebook) {
    std::vector<std::string> names;
    if (const auto run = gradebook.last_run())
        for (const Suite& suite : run->suites) names.push_back(suite.exercise);
    return default_assignment(names);
}

const Student& student_named(const Run& run, const std::string& name) {
    if (const Student* found = find_student(run.students, name)) return *found;
    std::vector<std::string> ids;
    for (const Student& student : run.students) ids.push_back(student.id);
    throw CannotBegin(fmt::format("the newest run has no student \"{}\"{}",
                                  course::visible(name),
                                  course::did_you_mean(name, ids)));
}

const Suite& suite_named(const Run& run, const std::string& name) {
    std::vector<std::string> names;
    for (const Suite& suite : run.suites) {
        if (suite.exercise == name || short_name(suite.exercise) == name)
            return suite;
        names.emplace_back(short_name(suite.exercise));
    }
    throw CannotBegin(fmt::format("the newest run has no exercise \"{}\"{}",
                                  course::visible(name),
                                  course::did_you_mean(name, names)));
}

void print_changes(const std::vector<Change>& changes) {
    int up = 0, down = 0;
    std::set<std::string> students;
    for (const Change& change : changes) {
        if (!changes_score(change)) continue;
        ++(change.points > change.old_points ? up : down);
        students.insert(change.student);
        fmt::print("{}  {}  {} -> {}\n", course::visible(change.student),
                   change.exercise,
                   score_text(change.old_verdict, change.old_points),
                   score_text(change.verdict, change.points));
    }
    if (changes.empty()) {
        fmt::print("No grade changes.\n");
        return;
    }
    fmt::print(
        "{} scores change, of {} students: {} up, {} down. {} results "
        "change in other ways.\n",
        up + down, students.size(), up, down,
        changes.size() - static_cast<std::size_t>(up + down));
}

}  // namespace grader

#include "grader/report/history.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "course/report/escape.h"
#include "course/report/text.h"
#include "grader/pipeline/assignment.h"

namespace grader {

namespace {

using course::escape_csv;
using course::escape_json;
using course::escape_terminal;
using Json = nlohmann::ordered_json;
using Kind = HistoryEntry::Kind;

bool is_judged(const HistoryEntry& entry) {
    return entry.kind == Kind::judged || entry.kind == Kind::counted_again;
}

std::string_view name(Kind kind) {
    constexpr std::array<std::string_view, 4> all = {
        "judged", "counted_again", "set_by_hand", "taken_back"};
    return all.at(static_cast<std::size_t>(kind));
}

// ---- for people

std::string judged_text(const HistoryEntry& entry) {
    const std::string score =
        entry.verdict == course::Verdict::not_submitted
            ? ""
            : fmt::format(", {} of {}", course::points_text(entry.points),
                          course::points_text(entry.max));
    return fmt::format(
        "{}{} (run {}{}{}, suite {})", words(entry.verdict), score, entry.run,
        entry.user.empty() ? "" : " by " + entry.user,
        entry.kind == Kind::counted_again ? ", counts again" : "",
        entry.suite.empty() ? "unknown" : entry.suite);
}

std::string what(const HistoryEntry& entry) {
    if (is_judged(entry))
        return judged_text(entry) + (entry.proposed ? ", only proposed" : "");
    if (entry.kind == Kind::taken_back)
        return fmt::format("what was set by hand is taken back by {}: {}",
                           entry.user, entry.reason);
    return fmt::format("set by hand to {} by {}: {}",
                       course::points_text(entry.points), entry.user,
                       entry.reason);
}

// ---- for programs

std::string csv_line(const HistoryEntry& entry, const std::string& name_of) {
    const bool judged = is_judged(entry);
    return fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(entry.when),
        name(entry.kind), escape_csv(entry.student), escape_csv(name_of),
        escape_csv(entry.exercise), judged ? std::to_string(entry.run) : "",
        escape_csv(entry.suite), judged ? name(entry.verdict) : "",
        entry.kind == Kind::taken_back ? "" : course::points_text(entry.points),
        judged ? course::points_text(entry.max) : "",
        judged ? (entry.proposed ? "yes" : "no") : "", escape_csv(entry.source),
        escape_csv(entry.user), escape_csv(entry.reason));
}

Json json_of(const HistoryEntry& entry, const std::string& name_of) {
    Json one = {{"when", escape_json(entry.when)},
                {"what", name(entry.kind)},
                {"student", escape_json(entry.student)},
                {"name", escape_json(name_of)},
                {"exercise", escape_json(entry.exercise)}};
    if (is_judged(entry)) {
        one["run"] = entry.run;
        one["suite"] = escape_json(entry.suite);
        one["verdict"] = name(entry.verdict);
    }
    if (entry.kind != Kind::taken_back) one["points"] = entry.points;
    if (is_judged(entry)) {
        one["max"] = entry.max;
        one["proposed"] = entry.proposed;
        one["source"] = escape_json(entry.source);
    }
    one["user"] = escape_json(entry.user);
    if (!is_judged(entry)) one["reason"] = escape_json(entry.reason);
    return one;
}

Json json_of(const PastRun& run) {
    Json suites = Json::object();
    for (const Suite& suite : run.facts.suites)
        suites[suite.exercise] = suite.version;
    return {{"run", run.number},
            {"started_at", escape_json(run.facts.started_at)},
            {"user", escape_json(run.facts.user)},
            {"grader", escape_json(run.facts.version)},
            {"sandbox", escape_json(run.facts.sandbox)},
            {"seed", run.facts.seed},
            {"jobs", run.facts.jobs},
            {"proposed", run.facts.proposed},
            {"suites", suites}};
}

}  // namespace

std::string history_text(const std::vector<HistoryEntry>& entries) {
    std::string text;
    for (const HistoryEntry& entry : entries)
        text += fmt::format("{}  {}  {}\n", course::time_text(entry.when),
                            short_name(entry.exercise),
                            escape_terminal(what(entry)));
    return text;
}

std::string runs_text(const std::vector<PastRun>& runs) {
    std::string text;
    for (const PastRun& run : runs)
        text += fmt::format("run {}  {}  {} exercises, grader {}{}{}\n",
                            run.number, course::time_text(run.facts.started_at),
                            run.facts.suites.size(), run.facts.version,
                            run.facts.user.empty()
                                ? ""
                                : ", by " + escape_terminal(run.facts.user),
                            run.facts.proposed ? ", only proposed" : "");
    return text;
}

std::string history_csv(const Gradebook& gradebook) {
    std::string text =
        "when,what,student,name,exercise,run,suite,verdict,points,max,"
        "proposed,source,user,reason\n";
    for (const Student& student : gradebook.students_ever())
        for (const HistoryEntry& entry : gradebook.history(student.id))
            text += csv_line(entry, student.name);
    return text;
}

std::string history_json(const Gradebook& gradebook) {
    Json all = {{"runs", Json::array()}, {"entries", Json::array()}};
    for (const PastRun& run : gradebook.runs())
        all["runs"].push_back(json_of(run));
    for (const Student& student : gradebook.students_ever())
        for (const HistoryEntry& entry : gradebook.history(student.id))
            all["entries"].push_back(json_of(entry, student.name));
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader

#include "grader/pipeline/export_people.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "grader/pipeline/gradescope_metadata.h"

namespace grader {

namespace {

/// What tells people apart: the first of these that there is.
const std::string& identity(const Member& member) {
    if (!member.number.empty()) return member.number;
    return member.email.empty() ? member.name : member.email;
}

std::string names_of(const std::vector<Member>& members) {
    std::string text;
    for (const Member& one : members)
        text += (text.empty() ? "" : ", ") + one.name;
    return text;
}

// ---- Gradescope

std::optional<Instant> time_of(const std::string& text, Participant& one) {
    if (text.empty()) return std::nullopt;
    try {
        return instant_in(text, "UTC");
    } catch (const TimeError& error) {
        one.notes.push_back(
            fmt::format("when it came cannot be told: {}", error.what()));
        return std::nullopt;
    }
}

void tell(const GradescopeSubmission& facts, Participant& one) {
    one.members = facts.submitters;
    one.person = names_of(one.members);
    one.submitted_at = time_of(facts.created_at, one);
}

/// Newer before older; without a time by the number, which grows.
bool is_newer(const Participant& a, const Participant& b) {
    if (a.submitted_at != b.submitted_at)
        return a.submitted_at > b.submitted_at;
    return std::pair(a.key.size(), a.key) > std::pair(b.key.size(), b.key);
}

/// Takes away who has a newer submission; the names of those.
std::vector<Member> take_known(Participant& one,
                               std::map<std::string, std::string>& newest,
                               const std::string& student) {
    std::vector<Member> gone;
    std::erase_if(one.members, [&](const Member& member) {
        const bool is_known = !newest.emplace(identity(member), student).second;
        if (is_known) gone.push_back(member);
        return is_known;
    });
    return gone;
}

void drop(ExportLayout& layout, const std::string& student) {
    for (const auto& [entry, path] : layout.participants[student].entries)
        layout.owners.erase(entry);
    layout.participants.erase(student);
}

/// Each person counts in their newest submission only.
void keep_newest(ExportLayout& layout) {
    std::vector<std::string> students;
    for (const auto& [student, one] : layout.participants)
        if (!one.members.empty()) students.push_back(student);
    std::stable_sort(students.begin(), students.end(),
                     [&](const std::string& a, const std::string& b) {
                         return is_newer(layout.participants[a],
                                         layout.participants[b]);
                     });
    std::map<std::string, std::string> newest;  // by identity, the student
    for (const std::string& student : students) {
        Participant& one = layout.participants[student];
        const std::vector<Member> gone = take_known(one, newest, student);
        if (gone.empty()) continue;
        const std::string text = fmt::format(
            "{}: of {} a newer submission, {}, is there and counts{}", student,
            names_of(gone), newest.at(identity(gone[0])),
            one.members.empty() ? ": ignored" : "");
        layout.notes.push_back(text);
        one.person = names_of(one.members);
        if (one.members.empty()) drop(layout, student);
    }
}

void add_gradescope(const ExportSurvey& survey, ExportLayout& layout) {
    const std::string file(gradescope_metadata_file);
    if (!survey.metadata)
        return layout.notes.push_back(
            file + ": is missing: names and times are not known");
    try {
        for (const auto& facts : read_gradescope_metadata(*survey.metadata)) {
            const auto known = layout.participants.find(facts.folder);
            if (known != layout.participants.end())
                tell(facts, known->second);
            else
                layout.notes.push_back(
                    fmt::format("{} of {} has no folder: not graded",
                                facts.folder, names_of(facts.submitters)));
        }
    } catch (const MetadataError& error) {
        layout.notes.push_back(fmt::format(
            "{}: {}: names and times are not known", file, error.what()));
    }
    keep_newest(layout);
}

// ---- git

/// "<old> <new> Name <mail> 1700000000 +0100<tab>commit: message". A clone or
/// a pull moves HEAD at a time of its own, which says nothing.
std::optional<Instant> time_of_commit(std::string_view line) {
    const std::size_t tab = line.find('\t');
    if (tab == line.npos || !line.substr(tab + 1).starts_with("commit"))
        return std::nullopt;
    line = line.substr(0, tab);
    const std::size_t mail = line.rfind("> ");
    if (mail == line.npos) return std::nullopt;
    line.remove_prefix(mail + 2);
    std::int64_t seconds = 0;
    const auto [end, error] =
        std::from_chars(line.data(), line.data() + line.size(), seconds);
    if (error != std::errc() || seconds < 0 || seconds > 1'000'000'000'000)
        return std::nullopt;
    return Instant(std::chrono::seconds(seconds));
}

void add_commits(const ExportSurvey& survey, ExportLayout& layout) {
    for (const auto& [entry, line] : survey.git_logs) {
        const auto owner = layout.owners.find(entry);
        if (owner != layout.owners.end())
            layout.participants[owner->second].submitted_at =
                time_of_commit(line);
    }
}

}  // namespace

void add_people(const ExportSurvey& survey, ExportLayout& layout) {
    if (survey.platform == Platform::gradescope) add_gradescope(survey, layout);
    if (survey.platform == Platform::github) add_commits(survey, layout);
}

}  // namespace grader

#include "grader/pipeline/ingest.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/collector.h"
#include "grader/pipeline/safe_id.h"
#include "grader/pipeline/submitted_names.h"
#include "grader/pipeline/walk.h"

namespace grader {

namespace {

using course::Descriptor;

constexpr std::size_t most_notes_on_a_class = 400;
constexpr unsigned seconds_for_a_class = 1200;  // of CPU

/// The students of a class, by what they have in its folder or archive.
class ClassCollector {
public:
    ClassCollector(const std::vector<std::string>& file_names,
                   const IngestLimits& limits)
        : file_names_(file_names),
          limits_(limits),
          notes_(most_notes_on_a_class) {}

    Collector& folder(const std::string& student) {
        return folders_.try_emplace(student, student, file_names_, limits_)
            .first->second;
    }

    /// "anna.zip", the submission of anna.
    Collector& archive(const std::string& file_name) {
        return archives_
            .try_emplace(file_name, std::string(archive_stem(file_name)),
                         file_names_, limits_)
            .first->second;
    }

    void note(std::string text) { notes_.add(std::move(text)); }

    /// Something else beside the students' folders; noted once.
    void ignore(const std::string& name) {
        if (ignored_.insert(name).second)
            note(name + ": ignored; expected a folder for each student");
    }

    SubmittedClass finish() {
        for (auto& [file_name, collector] : archives_)
            take_archive(file_name, std::move(collector));
        SubmittedClass all;
        for (auto& [student, collector] : folders_)
            all.submissions.push_back(collector.finish());
        all.notes = notes_.take();
        return all;
    }

private:
    /// Unless she has a folder, too, or another archive before it.
    void take_archive(const std::string& file_name, Collector&& collector) {
        const std::string student(archive_stem(file_name));
        const auto taken = folders_.find(student);
        if (taken == folders_.end()) {
            folders_.emplace(student, std::move(collector));
            from_.emplace(student, file_name);
            return;
        }
        const auto archive = from_.find(student);
        const std::string text = fmt::format(
            "{}: ignored, as {} is there as well and counts", file_name,
            archive == from_.end() ? "the folder " + student + "/"
                                   : archive->second);
        note(text);
        taken->second.note(text);
    }

    const std::vector<std::string>& file_names_;
    const IngestLimits& limits_;
    Notes notes_;
    std::set<std::string> ignored_;
    std::map<std::string, Collector> folders_;
    std::map<std::string, Collector> archives_;
    std::map<std::string, std::string> from_;  ///< archive taken of a student
};

// ---- a folder of a class

void look_at_student(int dir, const std::string& name,
                     const IngestLimits& limits, ClassCollector& to) {
    const FileKind kind = kind_of(dir, name);
    if (kind == FileKind::link) {
        to.note(name +
                ": is a symbolic link, and links are never followed: ignored");
    } else if (kind == FileKind::folder && !is_left_behind(name)) {
        Collector& student = to.folder(name);
        if (const Descriptor root = open_folder(dir, name))
            walk_folder(root.get(), limits, student);
        else
            student.note(fmt::format("the folder cannot be read ({})",
                                     std::strerror(errno)));
    } else if (kind == FileKind::file && archive_format(name) &&
               !is_left_behind(name)) {
        look_at_file(dir, name, name, limits, to.archive(name));
    } else {
        to.ignore(name);
    }
}

// ---- an archive of a class

/// "anna" and "week1/prev.cpp" of "anna/week1/prev.cpp".
struct StudentPath {
    std::string student, rest;
};

StudentPath split(std::string_view path) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    return {std::string(path.substr(0, slash)),
            std::string(path.substr(std::min(slash + 1, path.size())))};
}

/// Hands the entries of a class's archive to its students.
class ClassArchive {
public:
    ClassArchive(const std::vector<std::string>& file_names,
                 const IngestLimits& limits, ClassCollector& to)
        : names_({}, file_names, limits), limits_(limits), to_(to) {}

    /// How much is wanted of the file of that path.
    std::optional<std::size_t> most_bytes(std::string_view path) const {
        const auto [student, rest] = split(path);
        if (is_left_behind(student)) return std::nullopt;
        if (rest.empty())
            return archive_format(student)
                       ? std::optional(limits_.archive_bytes)
                       : std::nullopt;
        if (names_.wants(name_in(rest)) && is_open(folder_of(rest)))
            return limits_.file_bytes;
        if (opened_as(name_in(rest), names_) && is_open(rest))
            return limits_.archive_bytes;
        return std::nullopt;
    }

    void take(ArchiveEntry entry) {
        const auto [student, rest] = split(entry.path);
        if (entry.kind == ArchiveEntry::Kind::refused)
            take_refused(entry, student, rest);
        else if (is_left_behind(student))
            to_.ignore(student);
        else if (entry.kind == ArchiveEntry::Kind::folder)
            take_folder(student, rest);
        else if (rest.empty())
            take_beside(student, entry);
        else
            take_file(student, rest, entry);
    }

private:
    bool is_open(std::string_view folder) const {
        return way_to(folder, limits_).entrance == Entrance::open;
    }

    /// The note stands with the student in whose folder the entry claims to be.
    void take_refused(ArchiveEntry& entry, const std::string& student,
                      const std::string& rest) {
        const bool is_name = !student.empty() && why_refused(student).empty() &&
                             !is_left_behind(student);
        if (is_name && !rest.empty()) {
            entry.path = rest;
            to_.folder(student).note(refusal_of(entry, ""));
        } else if (is_name && archive_format(student)) {
            to_.archive(student).note(refusal_of(entry, ""));
        } else {
            to_.note(refusal_of(entry, ""));
        }
    }

    void take_folder(const std::string& student, const std::string& rest) {
        if (student.empty()) return;  // the folder of the class
        Collector& collector = to_.folder(student);
        if (!rest.empty() && collector.enters(rest))
            has_room(student, collector);
    }

    void take_beside(const std::string& name, const ArchiveEntry& entry) {
        if (const auto format = archive_format(name))
            open_archive(*entry.bytes, *format, name, limits_,
                         to_.archive(name));
        else
            to_.ignore(name);
    }

    void take_file(const std::string& student, const std::string& path,
                   ArchiveEntry& entry) {
        Collector& collector = to_.folder(student);
        if (!collector.enters(folder_of(path)) || !has_room(student, collector))
            return;
        const auto format = opened_as(name_in(path), collector);
        if (collector.wants(name_in(path)))
            collector.offer(path, [&] {
                return ReadFile{std::move(entry.bytes), {}};
            });
        else if (!format)
            collector.pass_over(path);
        else if (collector.enters(path))
            open_archive(*entry.bytes, *format, path, limits_, collector);
    }

    /// Counts one entry of the student; what is too much is noted once.
    bool has_room(const std::string& student, Collector& collector) {
        if (collector.count_entries(1)) return true;
        if (full_.insert(student).second)
            collector.note(
                fmt::format("at most {} files and folders are looked at, and "
                            "there are more: what follows in the archive was "
                            "left out",
                            limits_.entries));
        return false;
    }

    const Collector names_;  ///< of no student: knows the exercises' files
    const IngestLimits& limits_;
    ClassCollector& to_;
    std::set<std::string> full_;
};

void read_class_archive(const std::filesystem::path& path, int file,
                        const std::vector<std::string>& file_names,
                        const IngestLimits& limits, ClassCollector& to) {
    const auto format = archive_format(path.filename().string());
    if (!format)
        throw IngestError(fmt::format(
            "{}: is neither a folder nor an archive (.zip, .tar, .tar.gz, "
            ".tgz, .tar.bz2, .tar.xz, .tar.zst)",
            path.string()));
    ClassArchive archive(file_names, limits, to);
    try {
        read_archive_confined(
            file, *format,
            {limits.class_entries, limits.class_bytes,
             std::max(limits.file_bytes, limits.archive_bytes)},
            seconds_for_a_class,
            [&](std::string_view entry) { return archive.most_bytes(entry); },
            [&](ArchiveEntry entry) { archive.take(std::move(entry)); });
    } catch (const ArchiveError& error) {
        throw IngestError(
            fmt::format("{}: {}; the archive of a class is read as a whole or "
                        "not at all",
                        path.string(), error.what()));
    }
}

// ---- either of them

Descriptor open_class(const std::filesystem::path& dir) {
    Descriptor file(open(dir.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!file)
        throw IngestError(fmt::format(
            "{}: cannot be read ({}); expected a folder with a folder for "
            "each student, or an archive of it",
            dir.string(), std::strerror(errno)));
    return file;
}

mode_t type_of(int file) {
    struct stat status {};
    return fstat(file, &status) == 0 ? status.st_mode & S_IFMT : 0;
}

void sort_by_id(std::vector<Submission>& submissions) {
    std::vector<std::string> names;
    for (const Submission& one : submissions) names.push_back(one.student);
    const std::vector<std::string> ids = safe_ids(names);
    for (std::size_t k = 0; k < ids.size(); ++k) submissions[k].id = ids[k];
    std::sort(submissions.begin(), submissions.end(),
              [](const auto& a, const auto& b) { return a.id < b.id; });
}

}  // namespace

SubmittedClass find_submissions(const std::filesystem::path& dir,
                                const std::vector<std::string>& file_names,
                                const IngestLimits& limits) {
    const Descriptor file = open_class(dir);
    const mode_t type = type_of(file.get());
    ClassCollector students(file_names, limits);
    if (S_ISDIR(type))
        for (const std::string& name :
             names_in(file.get(), static_cast<std::size_t>(-1)).names)
            look_at_student(file.get(), name, limits, students);
    else if (S_ISREG(type))
        read_class_archive(dir, file.get(), file_names, limits, students);
    else
        throw IngestError(dir.string() +
                          ": is neither a folder nor a regular file");
    SubmittedClass all = students.finish();
    sort_by_id(all.submissions);
    return all;
}

}  // namespace grader

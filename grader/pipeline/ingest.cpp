#include "grader/pipeline/ingest.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/collector.h"
#include "grader/pipeline/export_people.h"
#include "grader/pipeline/safe_id.h"
#include "grader/pipeline/submitted_names.h"
#include "grader/pipeline/walk.h"

namespace grader {

namespace {

using course::Descriptor;

constexpr std::size_t most_notes_on_a_class = 400;
constexpr unsigned seconds_for_a_class = 1200;  // of CPU

/// What is said about the class as a whole.
class ClassNotes {
public:
    void add(std::string text) { notes_.add(std::move(text)); }

    /// Something else beside the students' folders; noted once.
    void ignore(const std::string& name) {
        if (ignored_.insert(name).second)
            add(name + ": ignored; expected a folder for each student");
    }

    std::vector<std::string> take() { return notes_.take(); }

private:
    Notes notes_{most_notes_on_a_class};
    std::set<std::string> ignored_;
};

/// What the reading of a whole class works with.
struct Reading {
    const std::vector<std::string>& file_names;
    const IngestLimits& limits;
    Spool& spool;
    ClassNotes notes;
    std::optional<Platform> wanted;
    std::string root;     ///< see ExportSurvey
    ExportLayout layout;  ///< empty for plain folders

    Collector collector_of(const std::string& student) {
        return {student, file_names, limits, spool};
    }

    bool is_plain() const { return layout.platform == Platform::plain; }

    void take(const ExportSurvey& survey) {
        if (survey.platform == Platform::plain) return;
        root = survey.root;
        layout = export_layout(survey.platform, survey.entries, file_names);
        add_people(survey, layout);
        notes.add(fmt::format(
            "recognised as an export of {}, with {} submissions (another "
            "platform can be given with --platform)",
            words(layout.platform), layout.participants.size()));
        for (std::string& text : layout.notes) notes.add(std::move(text));
    }

    /// The submission that the collector has, with what the layout knows.
    Submission finish(const std::string& student, Collector& collector) {
        const auto known = layout.participants.find(student);
        if (known == layout.participants.end()) return collector.finish();
        Participant& one = known->second;
        for (std::string& text : one.notes) collector.note(std::move(text));
        Submission done = collector.finish();
        done.person = one.person;
        done.key = one.key;
        done.marked_late = one.marked_late;
        done.members = std::move(one.members);
        done.submitted_at = one.submitted_at;
        return done;
    }
};

/// On an archive of a student who has a folder, too, or another before it.
std::string not_counted(const std::string& archive, const std::string& counts) {
    return fmt::format("{}: ignored, as {} is there as well and counts",
                       archive,
                       counts.ends_with('/') ? "the folder " + counts : counts);
}

// ---- a folder of a class

/// By student, what there is of each: "anna/", "anna.tar", "anna.zip". Sorted,
/// and so the folder is the first.
using Places = std::map<std::string, std::vector<std::string>>;

Places places_in(int dir, ClassNotes& notes) {
    Places places;
    const Listing listing = names_in(dir, static_cast<std::size_t>(-1));
    for (const std::string& name : listing.names) {
        const FileKind kind = kind_of(dir, name);
        if (kind == FileKind::link)
            notes.add(name +
                      ": is a symbolic link, and links are never followed: "
                      "ignored");
        else if (kind == FileKind::folder && !is_left_behind(name))
            places[name].push_back(name + "/");
        else if (kind == FileKind::file && archive_format(name) &&
                 !is_left_behind(name))
            places[std::string(archive_stem(name))].push_back(name);
        else
            notes.ignore(name);
    }
    return places;
}

void look_at_student(int dir, const std::string& student,
                     const std::string& place, const IngestLimits& limits,
                     Collector& to) {
    if (!place.ends_with('/'))
        look_at_file(dir, place, place, limits, to);
    else if (const Descriptor root = open_folder(dir, student))
        walk_folder(root.get(), limits, to);
    else
        to.note(fmt::format("the folder cannot be read ({})",
                            std::strerror(errno)));
}

/// The folder or the file `entry`, which is the student's at `path`.
void look_at_entry(int dir, const std::string& entry, const std::string& path,
                   const IngestLimits& limits, Collector& to) {
    if (path.empty())
        look_at_student(dir, entry, entry + "/", limits, to);
    else
        look_at_file(dir, entry, path, limits, to);
}

/// One student after the other: no more than one is in memory.
std::vector<Submission> read_class_folder(int dir, Reading& reading) {
    std::vector<Submission> all;
    std::map<std::string, std::string> not_counted_notes;  // by archive
    for (const auto& [student, places] : places_in(dir, reading.notes)) {
        Collector collector = reading.collector_of(student);
        look_at_student(dir, student, places[0], reading.limits, collector);
        for (std::size_t k = 1; k < places.size(); ++k) {
            const std::string text = not_counted(places[k], places[0]);
            collector.note(text);
            not_counted_notes.emplace(places[k], text);
        }
        all.push_back(collector.finish());
    }
    for (const auto& [archive, text] : not_counted_notes)
        reading.notes.add(text);
    return all;
}

/// The same for the export of a platform.
std::vector<Submission> read_export_folder(int dir, Reading& reading) {
    std::vector<Submission> all;
    const Descriptor root = open_below(dir, reading.root);
    for (const auto& [student, one] : reading.layout.participants) {
        Collector collector = reading.collector_of(student);
        for (const auto& [entry, path] : one.entries)
            look_at_entry(root.get(), entry, path, reading.limits, collector);
        all.push_back(reading.finish(student, collector));
    }
    return all;
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

/// The students of a class, by what they have in its archive.
class ClassCollector {
public:
    explicit ClassCollector(Reading& reading) : reading_(reading) {}

    Collector& folder(const std::string& student) {
        return known_or_new(folders_, student, student);
    }

    /// "anna.zip", the submission of anna.
    Collector& archive(const std::string& file_name) {
        return known_or_new(archives_, file_name,
                            std::string(archive_stem(file_name)));
    }

    ClassNotes& notes() { return reading_.notes; }

    std::vector<Submission> finish() {
        for (auto& [file_name, collector] : archives_)
            take_archive(file_name, std::move(collector));
        for (const auto& [student, one] : reading_.layout.participants)
            folder(student);
        std::vector<Submission> all;
        for (auto& [student, collector] : folders_)
            all.push_back(reading_.finish(student, collector));
        return all;
    }

    /// Whose file that is; of a plain class the first folder's.
    StudentPath owner_of(std::string_view path) const {
        const std::string& root = reading_.root;
        if (reading_.is_plain()) return split(path);
        if (!root.empty()) {
            if (!path.starts_with(root + "/")) return {};
            path.remove_prefix(root.size() + 1);
        }
        const auto place = reading_.layout.place_of(path);
        return place ? StudentPath{place->student, place->path} : StudentPath();
    }

private:
    using Collectors = std::map<std::string, Collector>;

    Collector& known_or_new(Collectors& among, const std::string& key,
                            const std::string& student) {
        const auto known = among.find(key);
        if (known != among.end()) return known->second;
        return among.emplace(key, reading_.collector_of(student)).first->second;
    }

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
        const std::string text =
            not_counted(file_name, archive == from_.end() ? student + "/"
                                                          : archive->second);
        notes().add(text);
        taken->second.note(text);
    }

    Reading& reading_;
    Collectors folders_;
    Collectors archives_;
    std::map<std::string, std::string> from_;  ///< archive taken of a student
};

/// Hands the entries of a class's archive to its students.
class ClassArchive {
public:
    ClassArchive(Reading& reading, ClassCollector& to)
        : names_(reading.collector_of({})), limits_(reading.limits), to_(to) {}

    /// How much is wanted of the file of that path.
    std::optional<std::size_t> most_bytes(std::string_view path) const {
        const auto [student, rest] = to_.owner_of(path);
        if (student.empty() || is_left_behind(student)) return std::nullopt;
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
        const auto [student, rest] = to_.owner_of(entry.path);
        if (entry.kind == ArchiveEntry::Kind::refused)
            take_refused(entry, student, rest);
        else if (student.empty())
            return;  // the folder of the class, or what was noted already
        else if (is_left_behind(student))
            to_.notes().ignore(student);
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
            to_.notes().add(refusal_of(entry, ""));
        }
    }

    void take_folder(const std::string& student, const std::string& rest) {
        Collector& collector = to_.folder(student);
        if (!rest.empty() && collector.enters(rest))
            has_room(student, collector);
    }

    void take_beside(const std::string& name, const ArchiveEntry& entry) {
        if (const auto format = archive_format(name))
            open_archive(*entry.bytes, *format, name, limits_,
                         to_.archive(name));
        else
            to_.notes().ignore(name);
    }

    void take_file(const std::string& student, const std::string& path,
                   ArchiveEntry& entry) {
        Collector& collector = to_.folder(student);
        if (!collector.enters(folder_of(path)) || !has_room(student, collector))
            return;
        const auto format = opened_as(name_in(path), collector);
        if (collector.wants(name_in(path)))
            collector.offer(path, [&] {
                return ReadFile{std::move(entry.bytes), {}, entry.modified};
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

std::vector<Submission> read_class_archive(const std::filesystem::path& path,
                                           int file, Reading& reading) {
    const auto format = archive_format(path.filename().string());
    if (!format)
        throw IngestError(fmt::format(
            "{}: is neither a folder nor an archive (.zip, .tar, .tar.gz, "
            ".tgz, .tar.bz2, .tar.xz, .tar.zst)",
            path.string()));
    const IngestLimits& limits = reading.limits;
    ClassCollector students(reading);
    ClassArchive archive(reading, students);
    try {
        reading.take(survey_archive(file, *format, limits, seconds_for_a_class,
                                    reading.wanted));
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
    return students.finish();
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

bool is_named(const Submission& submission, std::string_view name) {
    return !name.empty() &&
           (name == submission.id || name == submission.student ||
            name == submission.person || name == submission.key);
}

SubmittedClass find_submissions(const std::filesystem::path& dir,
                                const std::vector<std::string>& file_names,
                                const IngestLimits& limits,
                                std::optional<Platform> platform) {
    const Descriptor file = open_class(dir);
    const mode_t type = type_of(file.get());
    auto spool = std::make_unique<Spool>();
    Reading reading{file_names, limits, *spool, {}, platform, {}, {}};
    SubmittedClass all;
    if (S_ISDIR(type)) {
        reading.take(survey_folder(file.get(), platform));
        all.submissions = reading.is_plain()
                              ? read_class_folder(file.get(), reading)
                              : read_export_folder(file.get(), reading);
    } else if (S_ISREG(type))
        all.submissions = read_class_archive(dir, file.get(), reading);
    else
        throw IngestError(dir.string() +
                          ": is neither a folder nor a regular file");
    sort_by_id(all.submissions);
    all.platform = reading.layout.platform;
    all.notes = reading.notes.take();
    all.spool = std::move(spool);
    return all;
}

}  // namespace grader

#include "grader/pipeline/export_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "grader/pipeline/archive.h"
#include "grader/pipeline/gradescope_metadata.h"
#include "grader/pipeline/submitted_names.h"

namespace grader {

namespace {

bool is_archive(const ExportEntry& entry) {
    return !entry.is_folder && archive_format(entry.name).has_value();
}

std::string_view stem_of(const ExportEntry& entry) {
    return is_archive(entry) ? archive_stem(entry.name)
                             : std::string_view(entry.name);
}

/// A folder, or an archive that counts as one.
bool is_like_folder(const ExportEntry& entry) {
    return entry.is_folder || is_archive(entry);
}

// ---- what one name says

std::optional<PlatformName> moodle_name(const ExportEntry& entry) {
    auto name = parse_moodle(entry.name);
    if (name && entry.is_folder == name->file.empty()) return name;
    if (!is_archive(entry)) return std::nullopt;
    name = parse_moodle(stem_of(entry));
    return name && name->file.empty() ? name : std::nullopt;
}

std::optional<PlatformName> name_of(Platform platform,
                                    const ExportEntry& entry) {
    switch (platform) {
        case Platform::moodle:
            return moodle_name(entry);
        case Platform::canvas:
            return entry.is_folder ? std::nullopt : parse_canvas(entry.name);
        case Platform::gradescope:
            return is_like_folder(entry) ? parse_gradescope(stem_of(entry))
                                         : std::nullopt;
        case Platform::github:
            if (entry.has_git) return PlatformName{entry.name, {}};
            return std::nullopt;
        case Platform::plain:
            break;
    }
    return std::nullopt;
}

/// The beginning up to a hyphen that all names of clones share.
std::string shared_beginning(const std::vector<ExportEntry>& entries) {
    std::optional<std::string> shared;
    int clones = 0;
    for (const ExportEntry& entry : entries) {
        if (!entry.has_git) continue;
        ++clones;
        const std::string& name = entry.name;
        if (!shared) shared = name;
        const auto part = std::mismatch(shared->begin(), shared->end(),
                                        name.begin(), name.end());
        shared->erase(part.first, shared->end());
    }
    if (clones < 2) return {};
    const std::size_t hyphen = shared->rfind('-');
    return hyphen == shared->npos ? "" : shared->substr(0, hyphen + 1);
}

// ---- Canvas

/// "prev.cpp" of "prev-1.cpp", where an exercise asks for it.
std::string without_number(const std::string& file,
                           const std::vector<std::string>& file_names) {
    const auto wanted = [&](const std::string& name) {
        return std::find(file_names.begin(), file_names.end(), name) !=
               file_names.end();
    };
    const std::size_t dot = std::min(file.rfind('.'), file.size());
    std::size_t begin = dot;
    while (begin > 0 && file[begin - 1] >= '0' && file[begin - 1] <= '9')
        --begin;
    if (wanted(file) || begin == dot || begin == 0 || file[begin - 1] != '-')
        return file;
    const std::string plain = file.substr(0, begin - 1) + file.substr(dot);
    return wanted(plain) ? plain : file;
}

/// Numbers of any length.
bool is_newer(const PlatformName& a, const PlatformName& b) {
    return std::pair(a.upload.size(), a.upload) >
           std::pair(b.upload.size(), b.upload);
}

struct Upload {
    std::string entry;
    PlatformName name;
};

/// The newest upload of a student comes first; it tells which attempt counts.
void add_uploads(Participant& to, std::vector<Upload>& uploads,
                 const std::vector<std::string>& file_names) {
    std::stable_sort(uploads.begin(), uploads.end(),
                     [](const Upload& a, const Upload& b) {
                         return is_newer(a.name, b.name);
                     });
    to.marked_late = uploads.front().name.marked_late;
    std::map<std::string, std::string> taken;  // by path, the entry
    for (const Upload& one : uploads) {
        const std::string path = without_number(one.name.file, file_names);
        if (one.name.marked_late != to.marked_late)
            to.notes.push_back(fmt::format(
                "{}: belongs to an earlier attempt, and only the newest "
                "counts: ignored",
                one.entry));
        else if (const auto [other, is_new] = taken.emplace(path, one.entry);
                 is_new)
            to.entries.emplace(one.entry, path);
        else
            to.notes.push_back(
                fmt::format("{}: ignored, as {} was uploaded later and counts",
                            one.entry, other->second));
    }
}

// ---- the whole

class LayoutMaker {
public:
    LayoutMaker(Platform platform, const std::vector<ExportEntry>& entries,
                const std::vector<std::string>& file_names)
        : entries_(entries), file_names_(file_names) {
        layout_.platform = platform;
        if (platform == Platform::github)
            beginning_ = shared_beginning(entries);
    }

    ExportLayout make() {
        for (const ExportEntry& entry : entries_)
            if (const auto name = name_of(layout_.platform, entry))
                add_named(entry, *name);
            else
                add_other(entry);
        for (auto& [student, uploads] : uploads_)
            add_uploads(layout_.participants[student], uploads, file_names_);
        note_namesakes();
        for (const auto& [student, one] : layout_.participants)
            for (const auto& [entry, path] : one.entries)
                layout_.owners.emplace(entry, student);
        return std::move(layout_);
    }

private:
    void note(std::string text) { layout_.notes.push_back(std::move(text)); }

    /// Distinct, and the same in every export of the assignment.
    std::string student_of(const PlatformName& name) const {
        switch (layout_.platform) {
            case Platform::gradescope:
                return "submission_" + name.key;
            case Platform::github:
                return name.person.substr(beginning_.size());
            default:
                return name.key.empty() ? name.person
                                        : name.person + "_" + name.key;
        }
    }

    /// By the key, as somebody's name may change between two attempts.
    std::string known_student(const PlatformName& name) {
        std::string student = student_of(name);
        if (name.key.empty()) return student;
        const auto [known, is_new] = by_key_.emplace(name.key, student);
        if (!is_new && known->second != student && said_.insert(student).second)
            note(fmt::format("{} and {} have one number: taken as one student",
                             known->second, student));
        return known->second;
    }

    void add_named(const ExportEntry& entry, const PlatformName& name) {
        const std::string student = known_student(name);
        Participant& one = layout_.participants[student];
        if (one.person.empty() && one.key.empty()) {
            one.person =
                layout_.platform == Platform::github ? student : name.person;
            one.key = layout_.platform == Platform::github ? student : name.key;
        }
        if (layout_.platform == Platform::canvas)
            uploads_[student].push_back({entry.name, name});
        else if (!name.kind.empty() && name.kind != "file")
            one.notes.push_back(entry.name +
                                ": is no file that was handed in: ignored");
        else
            add_entry(one, entry, name.file);
    }

    /// A folder counts before an archive, and of several the first.
    void add_entry(Participant& one, const ExportEntry& entry,
                   const std::string& file) {
        const std::string path = is_like_folder(entry) && file.empty()
                                     ? path_of_folder(entry)
                                     : file;
        for (const auto& [other, place] : one.entries)
            if (place == path || place.empty() || path.empty()) {
                const std::string text = fmt::format(
                    "{}: ignored, as {} is there as well and counts",
                    entry.name, other);
                one.notes.push_back(text);
                return note(text);
            }
        one.entries.emplace(entry.name, path);
    }

    /// What is in an archive lies in a folder of its name.
    static std::string path_of_folder(const ExportEntry& entry) {
        return entry.is_folder ? "" : entry.name;
    }

    void add_other(const ExportEntry& entry) {
        if (is_left_behind(entry.name) ||
            entry.name == gradescope_metadata_file)
            return;
        if (!is_like_folder(entry))
            return note(fmt::format(
                "{}: is not named as {} names what was handed in: ignored",
                entry.name, words(layout_.platform)));
        const std::string student(stem_of(entry));
        add_entry(layout_.participants[student], entry, "");
        note(fmt::format(
            "{}: is not named as {} names what was handed in; it counts as the "
            "submission of {}",
            entry.name, words(layout_.platform), student));
    }

    void note_namesakes() {
        std::map<std::string, std::vector<std::string>> keys;
        for (const auto& [student, one] : layout_.participants)
            if (!one.person.empty() && !one.key.empty())
                keys[one.person].push_back(one.key);
        for (const auto& [person, all] : keys)
            if (all.size() > 1)
                note(fmt::format("{} is the name of {}: taken as {} students",
                                 person, fmt::join(all, " and of "),
                                 all.size()));
    }

    const std::vector<ExportEntry>& entries_;
    const std::vector<std::string>& file_names_;
    ExportLayout layout_;
    std::string beginning_;
    std::map<std::string, std::string> by_key_;
    std::set<std::string> said_;
    std::map<std::string, std::vector<Upload>> uploads_;
};

}  // namespace

std::optional<ExportLayout::Place> ExportLayout::place_of(
    std::string_view path) const {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string entry(path.substr(0, slash));
    const auto owner = owners.find(entry);
    if (owner == owners.end()) return std::nullopt;
    const std::string& own = participants.at(owner->second).entries.at(entry);
    const std::string rest(path.substr(std::min(slash + 1, path.size())));
    return Place{owner->second, own.empty() ? rest : own};
}

Platform platform_of(const std::vector<ExportEntry>& entries) {
    constexpr std::array<Platform, 4> all = {
        Platform::moodle, Platform::gradescope, Platform::canvas,
        Platform::github};
    for (const Platform platform : all) {
        std::size_t named = 0, others = 0;
        for (const ExportEntry& entry : entries)
            if (name_of(platform, entry))
                ++named;
            else if (is_like_folder(entry) && !is_left_behind(entry.name))
                ++others;
        if (named > others) return platform;
    }
    return Platform::plain;
}

Platform platform_of(const std::vector<ExportEntry>& entries, Platform wanted) {
    const bool is_so = std::any_of(
        entries.begin(), entries.end(), [&](const ExportEntry& entry) {
            return name_of(wanted, entry).has_value();
        });
    return is_so ? wanted : Platform::plain;
}

ExportLayout export_layout(Platform platform,
                           const std::vector<ExportEntry>& entries,
                           const std::vector<std::string>& file_names) {
    return LayoutMaker(platform, entries, file_names).make();
}

}  // namespace grader

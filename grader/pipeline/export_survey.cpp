#include "grader/pipeline/export_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/folders.h"
#include "grader/pipeline/gradescope_metadata.h"
#include "grader/pipeline/submitted_names.h"

namespace grader {

namespace {

using course::Descriptor;

constexpr std::string_view git_log = ".git/logs/HEAD";
constexpr std::size_t largest_git_log = 1u << 20;
constexpr std::size_t longest_line = 2000;

std::string last_line(std::string_view text) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    const std::size_t feed = text.rfind('\n');
    const std::string_view line =
        feed == text.npos ? text : text.substr(feed + 1);
    return std::string(line.substr(0, longest_line));
}

/// What lies in one folder of an export, and what is said beside it.
struct Level {
    std::map<std::string, ExportEntry> entries;
    std::optional<std::string> metadata;
    std::map<std::string, std::string> git_logs;

    std::vector<ExportEntry> list() const {
        std::vector<ExportEntry> all;
        for (const auto& [name, entry] : entries) all.push_back(entry);
        return all;
    }

    /// The name of the folder that alone lies here; empty where more do.
    std::string only_folder() const {
        std::string only;
        for (const auto& [name, entry] : entries) {
            if (!entry.is_folder || is_left_behind(name)) continue;
            if (!only.empty()) return {};
            only = name;
        }
        return only;
    }
};

std::optional<Platform> platform_at(const Level& level,
                                    std::optional<Platform> wanted) {
    const Platform found =
        wanted ? platform_of(level.list(), *wanted) : platform_of(level.list());
    return found == Platform::plain ? std::nullopt : std::optional(found);
}

ExportSurvey taken(Platform platform, std::string root, Level&& level) {
    return {platform, std::move(root), level.list(), std::move(level.metadata),
            std::move(level.git_logs)};
}

/// The platform of the top, or of the one folder in it.
template <class Inner>
ExportSurvey chosen(Level&& top, std::optional<Platform> wanted, Inner inner) {
    if (wanted == Platform::plain) return {};
    if (const auto platform = platform_at(top, wanted))
        return taken(*platform, "", std::move(top));
    if (const std::string root = top.only_folder(); !root.empty()) {
        Level level = inner(root);
        if (const auto platform = platform_at(level, wanted))
            return taken(*platform, root, std::move(level));
    }
    if (wanted)
        throw IngestError(
            fmt::format("nothing there is named as {} names what was handed in",
                        words(*wanted)));
    return {};
}

// ---- a folder

Level level_of(int dir) {
    Level level;
    for (const std::string& name :
         names_in(dir, static_cast<std::size_t>(-1)).names) {
        const FileKind kind = kind_of(dir, name);
        if (kind != FileKind::folder && kind != FileKind::file) continue;
        ExportEntry entry{name, kind == FileKind::folder, false};
        if (entry.is_folder) {
            const Descriptor folder = open_folder(dir, name);
            entry.has_git =
                folder && kind_of(folder.get(), ".git") == FileKind::folder;
        }
        level.entries.emplace(name, entry);
    }
    return level;
}

std::string log_of(int dir, const std::string& entry) {
    const Descriptor logs = open_below(dir, entry + "/.git/logs");
    if (!logs) return {};
    const ReadFile file = read_file(logs.get(), "HEAD", largest_git_log);
    return file.bytes ? last_line(*file.bytes) : "";
}

void read_beside(int dir, ExportSurvey& survey) {
    const Descriptor root = open_below(dir, survey.root);
    if (!root) return;
    if (survey.platform == Platform::gradescope)
        survey.metadata =
            read_file(root.get(), std::string(gradescope_metadata_file),
                      largest_gradescope_metadata)
                .bytes;
    if (survey.platform != Platform::github) return;
    for (const ExportEntry& entry : survey.entries)
        if (entry.has_git)
            survey.git_logs[entry.name] = log_of(root.get(), entry.name);
}

// ---- an archive

/// Puts down the two upper levels of an archive.
class ArchiveSurvey {
public:
    static std::optional<std::size_t> most_bytes(std::string_view path) {
        if (parts(path).size() <= 2 &&
            name_in(path) == gradescope_metadata_file)
            return largest_gradescope_metadata;
        if (const auto repository = repository_of(path);
            repository && parts(*repository).size() <= 2)
            return largest_git_log;
        return std::nullopt;
    }

    void take(const ArchiveEntry& entry) {
        if (entry.kind == ArchiveEntry::Kind::refused || entry.path.empty())
            return;
        const std::vector<std::string_view> at = parts(entry.path);
        const bool is_folder = entry.kind == ArchiveEntry::Kind::folder;
        put(top_, at, 0, is_folder);
        if (at.size() > 1) put(inner(at[0]), at, 1, is_folder);
        if (entry.bytes) take_bytes(entry);
    }

    Level take_top() { return std::move(top_); }
    Level take_inner(const std::string& root) {
        return std::move(inner_[root]);
    }

private:
    /// At most four, as no more are looked at.
    static std::vector<std::string_view> parts(std::string_view path) {
        std::vector<std::string_view> all;
        while (!path.empty() && all.size() < 4) {
            const std::size_t slash = std::min(path.find('/'), path.size());
            all.push_back(path.substr(0, slash));
            path.remove_prefix(std::min(slash + 1, path.size()));
        }
        return all;
    }

    static std::optional<std::string_view> repository_of(
        std::string_view path) {
        if (!path.ends_with(git_log) || path.size() <= git_log.size() + 1)
            return std::nullopt;
        path.remove_suffix(git_log.size());
        if (!path.ends_with('/')) return std::nullopt;
        path.remove_suffix(1);
        return path;
    }

    static void put(Level& level, const std::vector<std::string_view>& at,
                    std::size_t depth, bool is_folder) {
        ExportEntry& entry = level.entries[std::string(at[depth])];
        entry.name = at[depth];
        const bool goes_on = at.size() > depth + 1;
        entry.is_folder = entry.is_folder || goes_on || is_folder;
        if (at.size() > depth + 1 && at[depth + 1] == ".git")
            entry.has_git = true;
    }

    /// Is wanted of one folder only; when there is another, of none.
    Level& inner(std::string_view folder) {
        if (is_left_behind(folder)) return nowhere_ = {};
        if (inner_.size() == 1 && !inner_.contains(std::string(folder))) {
            inner_.clear();
            several_ = true;
        }
        return several_ ? nowhere_ = {} : inner_[std::string(folder)];
    }

    void take_bytes(const ArchiveEntry& entry) {
        const std::vector<std::string_view> at = parts(entry.path);
        if (const auto repository = repository_of(entry.path)) {
            const std::string name(name_in(*repository));
            Level& level =
                repository->find('/') == repository->npos ? top_ : inner(at[0]);
            level.git_logs[name] = last_line(*entry.bytes);
        } else {
            (at.size() == 1 ? top_ : inner(at[0])).metadata = *entry.bytes;
        }
    }

    Level top_;
    std::map<std::string, Level> inner_;
    Level nowhere_;
    bool several_ = false;
};

}  // namespace

ExportSurvey survey_folder(int dir, std::optional<Platform> wanted) {
    ExportSurvey survey =
        chosen(level_of(dir), wanted, [&](const std::string& root) {
            const Descriptor folder = open_folder(dir, root);
            return folder ? level_of(folder.get()) : Level();
        });
    read_beside(dir, survey);
    return survey;
}

ExportSurvey survey_archive(int file, ArchiveFormat format,
                            const IngestLimits& limits, unsigned cpu_seconds,
                            std::optional<Platform> wanted) {
    if (wanted == Platform::plain) return {};
    ArchiveSurvey survey;
    read_archive_confined(
        file, format,
        {limits.class_entries, limits.class_bytes, largest_gradescope_metadata},
        cpu_seconds, ArchiveSurvey::most_bytes,
        [&](const ArchiveEntry& entry) { survey.take(entry); });
    return chosen(survey.take_top(), wanted, [&](const std::string& root) {
        return survey.take_inner(root);
    });
}

}  // namespace grader

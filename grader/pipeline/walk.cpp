#include "grader/pipeline/walk.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <utility>
#include <vector>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/submitted_names.h"

namespace grader {

namespace {

using course::Descriptor;

constexpr unsigned seconds_for_an_archive = 20;  // of CPU

// ---- folders

/// False when the submission is too large to be looked at further. Which
/// entries a system lists first is chance: a folder counts as a whole.
bool list_folder(int fd, const std::string& path, const IngestLimits& limits,
                 Collector& to, std::vector<std::string>& names) {
    Listing listing = names_in(fd, to.entries_left());
    if (!listing.whole) {
        to.note(
            fmt::format("at most {} files and folders are looked at, and {}/ "
                        "has more than are left: it and what follows it was "
                        "left out",
                        limits.entries, path));
        return false;
    }
    to.count_entries(listing.names.size());
    names = std::move(listing.names);
    return true;
}

void look_at(int folder, const std::string& name, const std::string& path,
             const IngestLimits& limits, Collector& to,
             std::deque<std::string>& waiting) {
    const FileKind kind = kind_of(folder, name);
    if (kind == FileKind::file)
        look_at_file(folder, name, path, limits, to);
    else if (kind == FileKind::link)
        to.note(path +
                ": is a symbolic link, and links are never followed: refused");
    else if (kind == FileKind::other)
        to.note(path + ": is not a regular file: refused");
    else if (kind == FileKind::folder && to.enters(path))
        waiting.push_back(path);
}

// ---- archives

/// What a student's archive is asked for.
MostBytes wanted_in(const std::string& archive, const IngestLimits& limits,
                    const Collector& to) {
    return [&](std::string_view path) -> std::optional<std::size_t> {
        const std::string whole = fmt::format("{}/{}", archive, path);
        if (way_to(folder_of(whole), limits).entrance != Entrance::open ||
            !to.wants(name_in(path)))
            return std::nullopt;
        return limits.file_bytes;
    };
}

void look_at_file_in_archive(ArchiveEntry& entry, const std::string& path,
                             Collector& to) {
    if (entry.bytes)
        to.offer(path, [&] {
            return ReadFile{std::move(entry.bytes), {}, entry.modified};
        });
    else if (opened_as(name_in(path), to))
        to.note(path + ": is an archive in an archive: not opened");
    else
        to.pass_over(path);
}

void look_at_entry(ArchiveEntry& entry, const std::string& archive,
                   Collector& to) {
    const std::string path = fmt::format("{}/{}", archive, entry.path);
    if (entry.kind == ArchiveEntry::Kind::refused)
        to.note(refusal_of(entry, archive + "/"));
    else if (entry.kind == ArchiveEntry::Kind::folder)
        to.enters(path);
    else if (to.enters(folder_of(path)))
        look_at_file_in_archive(entry, path, to);
}

/// How many of the entries count as looked at.
std::size_t looked_at(const std::vector<ArchiveEntry>& entries,
                      const std::string& archive, const IngestLimits& limits) {
    std::size_t count = 0;
    for (const ArchiveEntry& entry : entries) {
        const std::string path = fmt::format("{}/{}", archive, entry.path);
        if (way_to(folder_of(path), limits).entrance == Entrance::open) ++count;
    }
    return count;
}

}  // namespace

void walk_folder(int root, const IngestLimits& limits, Collector& to) {
    std::deque<std::string> waiting = {""};
    for (; !waiting.empty(); waiting.pop_front()) {
        const std::string folder = waiting.front();
        const Descriptor fd = open_below(root, folder);
        if (!fd) {
            to.note(fmt::format("the folder {}/ cannot be read ({})", folder,
                                std::strerror(errno)));
            continue;
        }
        std::vector<std::string> names;
        if (!list_folder(fd.get(), folder, limits, to, names)) return;
        for (const std::string& name : names)
            look_at(fd.get(), name,
                    folder.empty() ? name : fmt::format("{}/{}", folder, name),
                    limits, to, waiting);
    }
}

void look_at_file(int folder, const std::string& name, const std::string& path,
                  const IngestLimits& limits, Collector& to) {
    const std::string_view own_name = name_in(path);
    const auto format = opened_as(own_name, to);
    if (to.wants(own_name)) {
        to.offer(path,
                 [&] { return read_file(folder, name, limits.file_bytes); });
    } else if (format && to.enters(path)) {
        const OpenedFile opened = open_file(folder, name, limits.archive_bytes);
        if (opened.why_not.empty())
            open_archive(opened.file.get(), *format, path, limits, to);
        else
            to.note(path + ": " + opened.why_not);
    } else if (!format) {
        to.pass_over(path);
    }
}

void open_archive(int file, ArchiveFormat format, const std::string& path,
                  const IngestLimits& limits, Collector& to) {
    if (!to.count_archive(path)) return;
    std::vector<ArchiveEntry> entries;
    try {
        read_archive_confined(
            file, format,
            {limits.archive_entries, limits.archive_bytes, limits.file_bytes},
            seconds_for_an_archive, wanted_in(path, limits, to),
            [&](ArchiveEntry e) { entries.push_back(std::move(e)); });
    } catch (const ArchiveError& error) {
        to.note(fmt::format("{}: {}: nothing is taken from it", path,
                            error.what()));
        return;
    }
    if (!to.count_entries(looked_at(entries, path, limits))) {
        to.note(
            fmt::format("at most {} files and folders are looked at, and {} "
                        "has more than are left: it was left out",
                        limits.entries, path));
        return;
    }
    if (entries.empty()) to.note(path + ": has no entries");
    for (ArchiveEntry& entry : entries) look_at_entry(entry, path, to);
}

void open_archive(const std::string& bytes, ArchiveFormat format,
                  const std::string& path, const IngestLimits& limits,
                  Collector& to) {
    const Descriptor file = course::anonymous_file();
    if (!course::write_all(file.get(), bytes.data(), bytes.size()))
        course::throw_errno("write");
    open_archive(file.get(), format, path, limits, to);
}

std::string refusal_of(const ArchiveEntry& entry, const std::string& folder) {
    const std::string which =
        entry.path.empty() ? fmt::format("entry {}", entry.index) : entry.path;
    return fmt::format("{}{}: {}: refused", folder, which, entry.refusal);
}

std::optional<ArchiveFormat> opened_as(std::string_view file_name,
                                       const Collector& to) {
    if (is_left_behind(file_name) || to.wants(file_name)) return std::nullopt;
    return archive_format(file_name);
}

}  // namespace grader

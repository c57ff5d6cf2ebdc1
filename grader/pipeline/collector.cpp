#include "grader/pipeline/collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/submitted_names.h"

namespace grader {

namespace {

constexpr std::size_t most_notes = 40;
constexpr std::size_t most_names_in_a_note = 10;

/// In the order of a walk: less deep first, then name by name.
bool comes_before(std::string_view a, std::string_view b) {
    const auto depth_a = std::count(a.begin(), a.end(), '/');
    const auto depth_b = std::count(b.begin(), b.end(), '/');
    if (depth_a != depth_b) return depth_a < depth_b;
    const auto rank = [](char c) { return c == '/' ? '\0' : c; };
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) {
            return static_cast<unsigned char>(rank(x)) <
                   static_cast<unsigned char>(rank(y));
        });
}

/// The slash behind a folder's name is no level.
bool listed_before(std::string_view a, std::string_view b) {
    if (a.ends_with('/')) a.remove_suffix(1);
    if (b.ends_with('/')) b.remove_suffix(1);
    return comes_before(a, b);
}

std::string names(std::vector<std::string> paths) {
    std::sort(paths.begin(), paths.end(), listed_before);
    std::string text;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        if (k == most_names_in_a_note)
            return text + fmt::format(" and {} more", paths.size() - k);
        text += (k > 0 ? ", " : "") + paths[k];
    }
    return text;
}

}  // namespace

void Notes::add(std::string text) {
    if (notes_.size() < most_)
        notes_.push_back(std::move(text));
    else
        ++silent_;
}

std::vector<std::string> Notes::take() {
    if (silent_ > 0)
        notes_.push_back(fmt::format("and {} more notes", silent_));
    silent_ = 0;
    return std::exchange(notes_, {});
}

Way way_to(std::string_view folder, const IngestLimits& limits) {
    std::size_t at = 0;
    for (int depth = 1; at < folder.size(); ++depth) {
        const std::size_t end = std::min(folder.find('/', at), folder.size());
        if (is_left_behind(folder.substr(at, end - at)))
            return {Entrance::left_behind, folder.substr(0, end)};
        if (depth > limits.folders)
            return {Entrance::too_deep, folder.substr(0, end)};
        at = end + 1;
    }
    return {Entrance::open, folder};
}

Collector::Collector(std::string student,
                     const std::vector<std::string>& file_names,
                     const IngestLimits& limits, Spool& spool)
    : file_names_(file_names),
      limits_(limits),
      spool_(spool),
      notes_(most_notes) {
    submission_.student = std::move(student);
}

bool Collector::wants(std::string_view name) const {
    return std::find(file_names_.begin(), file_names_.end(), name) !=
           file_names_.end();
}

std::size_t Collector::entries_left() const {
    return static_cast<std::size_t>(limits_.entries) - entries_;
}

bool Collector::count_entries(std::size_t entries) {
    if (entries > entries_left()) return false;
    entries_ += entries;
    return true;
}

bool Collector::count_archive(const std::string& path) {
    if (archives_ == limits_.archives) {
        note(
            fmt::format("{}: at most {} archives of a student are opened: "
                        "refused",
                        path, limits_.archives));
        return false;
    }
    ++archives_;
    return true;
}

bool Collector::enters(std::string_view folder) {
    const Way way = way_to(folder, limits_);
    if (way.entrance == Entrance::open) return true;
    if (!not_entered_.emplace(way.folder).second) return false;
    if (way.entrance == Entrance::left_behind)
        unasked_.push_back(std::string(way.folder) + "/");
    else
        note(fmt::format("{}/: lies more than {} folders deep: not looked at",
                         way.folder, limits_.folders));
    return false;
}

void Collector::offer(const std::string& path,
                      const std::function<ReadFile()>& read) {
    const std::string name(name_in(path));
    const auto known = found_.find(name);
    if (known != found_.end() && comes_before(known->second.path, path)) {
        known->second.others.push_back(path);
        return;
    }
    ReadFile file = read();
    if (!file.bytes) {
        note(path + ": " + file.why_not);
        return;
    }
    const std::size_t instead =
        known == found_.end() ? 0 : known->second.stored.size;
    if (has_room(path, file.bytes->size(), instead))
        keep(found_[name], path, file);
}

/// Whether a file may be taken in the place of so many bytes; false with a
/// note.
bool Collector::has_room(const std::string& path, std::size_t size,
                         std::size_t instead) {
    if (bytes_ - instead + size > limits_.total_bytes)
        note(
            fmt::format("{}: at most {} bytes of a student are taken in all, "
                        "and this file has {} more: refused",
                        path, limits_.total_bytes, size));
    else if (written_ + size > limits_.written_bytes)
        note(
            fmt::format("{}: at most {} bytes of a student are taken in all, "
                        "with files that others of their name replaced, and "
                        "this file has {} more: refused",
                        path, limits_.written_bytes, size));
    else
        return true;
    return false;
}

void Collector::keep(Candidate& candidate, const std::string& path,
                     const ReadFile& file) {
    const std::string& bytes = *file.bytes;
    if (candidate.path == path)
        note(path +
             ": is in the archive more than once: the last of them counts");
    else if (!candidate.path.empty())
        candidate.others.push_back(candidate.path);
    bytes_ += bytes.size() - candidate.stored.size;
    written_ += bytes.size();
    candidate.path = path;
    candidate.stored = spool_.keep(bytes);
    candidate.modified = file.modified;
}

void Collector::pass_over(const std::string& path) {
    const std::string_view name = name_in(path);
    if (const auto meant = meant_by(name, file_names_))
        note(
            fmt::format("{}: ignored, as file names must be exact; did you "
                        "mean {}?",
                        path, *meant));
    else
        unasked_.push_back(path);
}

void Collector::note_others(const std::string& name, Candidate& candidate) {
    if (candidate.others.empty()) return;
    note(fmt::format("{} is there {} times: {} was taken, ignored: {}", name,
                     candidate.others.size() + 1, candidate.path,
                     names(candidate.others)));
}

Submission Collector::finish() {
    for (const std::string& name : file_names_) {
        std::optional<Stored>& file = submission_.files.emplace_back();
        const auto found = found_.find(name);
        if (found == found_.end()) continue;
        note_others(name, found->second);
        file = found->second.stored;
        if (const auto& time = found->second.modified)
            submission_.modified.push_back(*time);
    }
    if (!unasked_.empty())
        note(fmt::format("ignored, as no exercise asks for them: {}",
                         names(unasked_)));
    submission_.notes = notes_.take();
    return std::move(submission_);
}

}  // namespace grader

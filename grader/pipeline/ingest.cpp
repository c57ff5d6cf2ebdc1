#include "grader/pipeline/ingest.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "course/runner/descriptors.h"
#include "course/runner/nearest.h"
#include "grader/pipeline/safe_id.h"

namespace grader {

namespace {

using course::Descriptor;

constexpr std::size_t most_notes = 40;
constexpr std::size_t most_names_in_a_note = 10;

// ---- folders, by descriptor: no component of a path may be a link

Descriptor open_folder(int parent, const std::string& name) {
    return Descriptor(openat(parent, name.c_str(),
                             O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// The folder `path` ("a/b", or "" for `root` itself) below `root`.
Descriptor open_below(int root, std::string_view path) {
    Descriptor folder = open_folder(root, ".");
    while (folder && !path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        folder = open_folder(folder.get(), std::string(path.substr(0, slash)));
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return folder;
}

struct Listing {
    std::vector<std::string> names;  ///< sorted
    bool whole = true;               ///< false: there are more
};

/// The names in a folder, at most `most` of them.
Listing names_in(int folder, std::size_t most) {
    Listing listing;
    const int copy = fcntl(folder, F_DUPFD_CLOEXEC, 0);
    const std::unique_ptr<DIR, int (*)(DIR*)> stream(fdopendir(copy), closedir);
    if (!stream) {
        close(copy);
        return listing;
    }
    while (const dirent* entry = readdir(stream.get())) {
        const std::string name = entry->d_name;
        if (name == "." || name == "..") continue;
        listing.whole = listing.names.size() < most;
        if (!listing.whole) break;
        listing.names.push_back(name);
    }
    std::sort(listing.names.begin(), listing.names.end());
    return listing;
}

enum class Kind { file, folder, link, other, gone };

Kind kind_of(int folder, const std::string& name) {
    struct stat status {};
    if (fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return Kind::gone;
    if (S_ISREG(status.st_mode)) return Kind::file;
    if (S_ISDIR(status.st_mode)) return Kind::folder;
    return S_ISLNK(status.st_mode) ? Kind::link : Kind::other;
}

/// Folders that tools leave behind and that hold no submission.
bool is_left_behind(std::string_view name) {
    return name.starts_with('.') || name == "__MACOSX";
}

// ---- names that are not quite right

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

bool strip_suffix(std::string& text, std::string_view suffix) {
    if (!text.ends_with(suffix)) return false;
    text.resize(text.size() - suffix.size());
    return true;
}

/// "face_sides" of "Face-Sides (1).cpp.txt": what a copy, a browser or a file
/// manager adds is taken away.
std::string bare_stem(std::string_view file_name) {
    std::string stem = lower(file_name.substr(0, file_name.find('.')));
    for (char& c : stem)
        if (c == ' ' || c == '-') c = '_';
    strip_suffix(stem, "copy");
    strip_suffix(stem, "copia");
    strip_suffix(stem, ")");
    while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9')
        stem.pop_back();
    strip_suffix(stem, "(");
    while (strip_suffix(stem, "_")) continue;
    return stem;
}

/// A header or a note beside the file is no mistake.
bool is_companion(std::string_view file_name) {
    constexpr std::array<std::string_view, 4> ends = {".h", ".hpp", ".md",
                                                      ".o"};
    return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) {
        return file_name.ends_with(end);
    });
}

/// The file name that was meant by one that is not among them, if it is near.
std::optional<std::string> meant_by(
    std::string_view name, const std::vector<std::string>& file_names) {
    if (is_companion(name)) return std::nullopt;
    const std::string stem = bare_stem(name);
    std::optional<std::string> best;
    std::size_t least = 3;  // two letters wrong, and one at a third of the name
    for (const std::string& wanted : file_names) {
        const std::string right = bare_stem(wanted);
        const std::size_t distance = course::edit_distance(stem, right);
        if (distance >= least || 3 * distance > right.size()) continue;
        best = wanted;
        least = distance;
    }
    return best;
}

// ---- one file

/// Either the bytes of a file or why it was refused.
struct ReadFile {
    std::optional<std::string> bytes;
    std::string why_not;
};

ReadFile refused_by_system() {
    return {{},
            fmt::format("cannot be read ({}): refused", std::strerror(errno))};
}

ReadFile read_bytes(int fd, std::size_t size) {
    std::string bytes(size + 1, '\0');  // one more, to see whether it grows
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = read(fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return refused_by_system();
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    if (done > size) return {{}, "grew while it was read: refused"};
    bytes.resize(done);
    return {std::move(bytes), {}};
}

/// Opens without following a link and without waiting for a FIFO's writer, and
/// looks at what was opened, not at what stood there before.
ReadFile read_file(int folder, const std::string& name, std::size_t most) {
    const Descriptor file(
        openat(folder, name.c_str(),
               O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat status {};
    if (!file || fstat(file.get(), &status) != 0) return refused_by_system();
    if (!S_ISREG(status.st_mode)) return {{}, "is not a regular file: refused"};
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > most)
        return {{},
                fmt::format("has {} bytes; at most {} are taken: refused", size,
                            most)};
    return read_bytes(file.get(), size);
}

// ---- one submission

/// Walks through the folder of one student, least deep folders first.
class Collector {
public:
    Collector(int root, const std::vector<std::string>& file_names,
              const IngestLimits& limits, Submission& to)
        : root_(root), file_names_(file_names), limits_(limits), to_(to) {}

    void collect() {
        std::deque<Folder> waiting = {{"", 0}};
        while (!waiting.empty()) {
            const Folder folder = waiting.front();
            waiting.pop_front();
            if (!visit(folder, waiting)) break;
        }
        for (const std::string& name : file_names_) take(name);
        if (!others_.empty())
            note(fmt::format("ignored, as no exercise asks for them: {}",
                             names(others_)));
        if (silent_ > 0)
            to_.notes.push_back(fmt::format("and {} more notes", silent_));
    }

private:
    struct Folder {
        std::string path;  ///< below the student's; "" is the student's own
        int depth;
    };

    void note(std::string text) {
        if (to_.notes.size() < most_notes)
            to_.notes.push_back(std::move(text));
        else
            ++silent_;
    }

    static std::string names(const std::vector<std::string>& paths) {
        std::string text;
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (k == most_names_in_a_note)
                return text + fmt::format(" and {} more", paths.size() - k);
            text += (k > 0 ? ", " : "") + paths[k];
        }
        return text;
    }

    /// False when the submission is too large to be looked at further. Which
    /// entries a system lists first is chance: a folder counts as a whole.
    bool visit(const Folder& folder, std::deque<Folder>& waiting) {
        const Descriptor fd = open_below(root_, folder.path);
        if (!fd) {
            note(fmt::format("the folder {}/ cannot be read ({})", folder.path,
                             std::strerror(errno)));
            return true;
        }
        const auto left = static_cast<std::size_t>(limits_.entries) - seen_;
        const Listing listing = names_in(fd.get(), left);
        if (!listing.whole) {
            note(
                fmt::format("at most {} files and folders are looked at, and "
                            "{}/ has more than are left: it and what follows "
                            "it was left out",
                            limits_.entries, folder.path));
            return false;
        }
        seen_ += listing.names.size();
        for (const std::string& name : listing.names)
            look_at(folder, name, kind_of(fd.get(), name), waiting);
        return true;
    }

    void look_at(const Folder& folder, const std::string& name, Kind kind,
                 std::deque<Folder>& waiting) {
        const std::string path =
            folder.path.empty() ? name : folder.path + "/" + name;
        if (kind == Kind::file)
            look_at_file(path, name);
        else if (kind == Kind::link)
            note(path +
                 ": is a symbolic link, and links are never followed: "
                 "refused");
        else if (kind == Kind::other)
            note(path + ": is not a regular file: refused");
        else if (kind == Kind::folder && is_left_behind(name))
            others_.push_back(path + "/");
        else if (kind == Kind::folder && folder.depth == limits_.folders)
            note(
                fmt::format("{}/: lies more than {} folders deep: not looked "
                            "at",
                            path, limits_.folders));
        else if (kind == Kind::folder)
            waiting.push_back({path, folder.depth + 1});
    }

    void look_at_file(const std::string& path, const std::string& name) {
        if (std::count(file_names_.begin(), file_names_.end(), name) > 0)
            found_[name].push_back(path);
        else if (const auto meant = meant_by(name, file_names_))
            note(
                fmt::format("{}: ignored, as file names must be exact; did "
                            "you mean {}?",
                            path, *meant));
        else
            others_.push_back(path);
    }

    /// The first of the files of that name that can be read.
    void take(const std::string& name) {
        std::vector<std::string> passed_over;
        std::string taken;
        for (const std::string& path : found_[name]) {
            if (!taken.empty())
                passed_over.push_back(path);
            else if (read(path, name))
                taken = path;
        }
        if (!passed_over.empty())
            note(fmt::format("{} is there {} times: {} was taken, ignored: {}",
                             name, passed_over.size() + 1, taken,
                             names(passed_over)));
    }

    bool read(const std::string& path, const std::string& name) {
        const std::size_t parent = path.size() - name.size();
        const Descriptor folder =
            open_below(root_, path.substr(0, parent > 0 ? parent - 1 : 0));
        ReadFile file = read_file(folder.get(), name, limits_.file_bytes);
        if (!file.bytes) {
            note(path + ": " + file.why_not);
            return false;
        }
        if (bytes_ + file.bytes->size() > limits_.total_bytes) {
            note(
                fmt::format("{}: at most {} bytes of a student are taken in "
                            "all, and this file has {} more: refused",
                            path, limits_.total_bytes, file.bytes->size()));
            return false;
        }
        bytes_ += file.bytes->size();
        to_.files[name] = {std::move(*file.bytes), path};
        return true;
    }

    int root_;
    const std::vector<std::string>& file_names_;
    const IngestLimits& limits_;
    Submission& to_;
    std::map<std::string, std::vector<std::string>> found_;
    std::vector<std::string> others_;
    std::size_t seen_ = 0;
    std::size_t bytes_ = 0;
    std::size_t silent_ = 0;
};

// ---- the class

Submission collect(int dir, const std::string& student,
                   const std::vector<std::string>& file_names,
                   const IngestLimits& limits) {
    Submission submission;
    submission.student = student;
    const Descriptor root = open_folder(dir, student);
    if (root)
        Collector(root.get(), file_names, limits, submission).collect();
    else
        submission.notes.push_back(fmt::format("the folder cannot be read ({})",
                                               std::strerror(errno)));
    return submission;
}

Descriptor open_class(const std::filesystem::path& dir) {
    Descriptor folder(open(dir.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder)
        throw IngestError(fmt::format(
            "{}: cannot be read ({}); expected a folder with a folder for "
            "each student",
            dir.string(), std::strerror(errno)));
    return folder;
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
    const Descriptor folder = open_class(dir);
    SubmittedClass all;
    for (const std::string& name :
         names_in(folder.get(), static_cast<std::size_t>(-1)).names) {
        const Kind kind = kind_of(folder.get(), name);
        if (kind == Kind::folder && !is_left_behind(name))
            all.submissions.push_back(
                collect(folder.get(), name, file_names, limits));
        else if (kind == Kind::link)
            all.notes.push_back(name +
                                ": is a symbolic link, and links are "
                                "never followed: ignored");
        else
            all.notes.push_back(name +
                                ": ignored; expected a folder for each "
                                "student");
    }
    sort_by_id(all.submissions);
    return all;
}

}  // namespace grader

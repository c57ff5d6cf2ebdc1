// What counts of all that was found in one submission: folders and archives
// are walked elsewhere, the choice among their files is made here.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "grader/pipeline/folders.h"
#include "grader/pipeline/ingest.h"
#include "grader/pipeline/spool.h"

namespace grader {

/// Notes, of which only the first are kept.
class Notes {
public:
    explicit Notes(std::size_t most) : most_(most) {}

    void add(std::string text);

    /// All of them; the last says how many were not kept.
    std::vector<std::string> take();

private:
    std::size_t most_;
    std::size_t silent_ = 0;
    std::vector<std::string> notes_;
};

/// Paths are below the student's folder: "week1/face_sides.cpp". What is in an
/// archive lies in a folder of its name: "homework.zip/week1/face_sides.cpp".
/// The bytes of files go to the spool at once.
class Collector {
public:
    Collector(std::string student, const std::vector<std::string>& file_names,
              const IngestLimits& limits, Spool& spool);

    void note(std::string text) { notes_.add(std::move(text)); }

    /// Whether an exercise asks for a file of that name.
    bool wants(std::string_view name) const;

    /// Takes so many of the files and folders that may be looked at; false,
    /// and takes none, where fewer are left.
    bool count_entries(std::size_t entries);
    std::size_t entries_left() const;

    /// The same for one archive to be opened; false with a note.
    bool count_archive(const std::string& path);

    /// Whether the folder of that path is one to look into, and so are those
    /// that it lies in. Where it is not, that is noted once.
    bool enters(std::string_view folder);

    /// A file that an exercise asks for. It is read only when it may be taken.
    void offer(const std::string& path, const std::function<ReadFile()>& read);

    /// A file that no exercise asks for.
    void pass_over(const std::string& path);

    /// What is the result; the collector is done.
    Submission finish();

private:
    struct Candidate {
        Stored stored;
        std::string path;
        std::vector<std::string> others;  ///< paths of the same name
        std::optional<FileTime> modified = {};
    };

    bool has_room(const std::string& path, std::size_t size,
                  std::size_t instead);
    void keep(Candidate& candidate, const std::string& path,
              const ReadFile& file);
    void note_others(const std::string& name, Candidate& candidate);

    const std::vector<std::string>& file_names_;
    const IngestLimits& limits_;
    Spool& spool_;
    Submission submission_;
    Notes notes_;
    std::map<std::string, Candidate> found_;
    std::set<std::string, std::less<>> not_entered_;
    std::vector<std::string> unasked_;
    std::size_t entries_ = 0;
    int archives_ = 0;
    std::size_t bytes_ = 0;    ///< of the candidates
    std::size_t written_ = 0;  ///< and of those that were one before
};

/// Whether a walk goes into that folder of a submission.
enum class Entrance { open, left_behind, too_deep };

/// The least deep folder on the way to `folder`, or itself, that is not
/// walked into, and why; the whole path where all are.
struct Way {
    Entrance entrance = Entrance::open;
    std::string_view folder;
};
Way way_to(std::string_view folder, const IngestLimits& limits);

}  // namespace grader

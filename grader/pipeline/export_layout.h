// Whose is what in the export of a course platform: told by names alone.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/gradebook/member.h"
#include "grader/pipeline/lateness.h"
#include "grader/pipeline/platform_names.h"

namespace grader {

/// A folder or a file at the top of an export.
struct ExportEntry {
    std::string name;  ///< any bytes
    bool is_folder = false;
    bool has_git = false;  ///< a folder with a folder .git
};

/// Somebody who handed in.
struct Participant {
    std::string person, key;   ///< see PlatformName
    bool marked_late = false;  ///< by the platform
    /// What counts of theirs: its path below their own folder by the name of
    /// the entry; "" for a folder, which is their own.
    std::map<std::string, std::string> entries;
    std::vector<std::string> notes;  ///< what does not count, and why
    std::vector<Member> members;     ///< where the export says who they are
    std::optional<Instant> submitted_at;  ///< where the export says it
};

/// An export, taken apart.
struct ExportLayout {
    Platform platform = Platform::plain;
    /// By a name that stays when a mark of lateness or the layout changes:
    /// "Anna Rossi_1234", "submission_77". Of plain folders none.
    std::map<std::string, Participant> participants;
    std::map<std::string, std::string> owners;  ///< by name of the entry
    std::vector<std::string> notes;             ///< about the class

    /// What is the student's at that path of the export ("" for the folder
    /// itself): "week1/prev.cpp". Nothing where it is nobody's.
    struct Place {
        std::string student, path;
    };
    std::optional<Place> place_of(std::string_view path) const;
};

/// The platform whose names more than half of the entries have. Files that no
/// platform names so, and what tools leave behind, do not count. plain where
/// there is none.
Platform platform_of(const std::vector<ExportEntry>& entries);

/// That platform where a single entry is named so, else plain.
Platform platform_of(const std::vector<ExportEntry>& entries, Platform wanted);

/// Gives each entry to who handed it in, as that platform names them.
/// `file_names` are those that exercises ask for.
///
/// Moodle: by the number behind the name. Canvas: by the user's number; "-1"
/// and the like, which Canvas adds to a name that was there before, is taken
/// away where an exercise asks for such a file. A download of Canvas holds the
/// files of the newest attempt; where files with and without the mark of
/// lateness show that two downloads lie there, only the attempt with the newest
/// upload counts, as a whole. Of two uploads of one name the newer counts.
/// GitHub: the login is what follows the beginning that all names share.
///
/// A folder or an archive that is not named so is the submission of its name,
/// as in plain folders, with a note: nobody is dropped. What does not count is
/// noted. Precondition: names differ, and the platform is not plain.
ExportLayout export_layout(Platform platform,
                           const std::vector<ExportEntry>& entries,
                           const std::vector<std::string>& file_names);

}  // namespace grader

// The names that course platforms give to what students handed in, taken apart.
// Only names are looked at; any bytes may stand in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace grader {

/// Where an export comes from. plain: a folder or archive for each student.
enum class Platform { plain, moodle, canvas, gradescope, github };

/// "Moodle", "Gradescope"; of plain "plain folders".
std::string_view words(Platform platform);

/// What the name of one folder or file of an export says.
struct PlatformName {
    /// Full name (Moodle), sortable name without spaces and in small letters
    /// (Canvas); of a team its name. Gradescope's names have none.
    std::string person;
    /// What the platform's own tables know them by: Moodle's number (that of
    /// "Participant 1234" in its worksheet, of a team the group's), Canvas's
    /// user id, Gradescope's submission id. Empty where the name has none.
    std::string key;
    bool marked_late = false;
    /// Canvas and Moodle without folders: the student's own file name.
    std::string file = {};
    /// Canvas: the number of the upload, larger for later ones.
    std::string upload = {};
    /// Moodle: "file", "onlinetext" or another way of handing in.
    std::string kind = {};

    friend bool operator==(const PlatformName&, const PlatformName&) = default;
};

/// "Anna Rossi_1234_assignsubmission_file", a folder or (with "_prev.cpp"
/// behind it) a file. Also those of onlinetext and other kinds; "Participant"
/// where names are hidden, which becomes the person "Participant 1234"; teams;
/// and "Default group_assignsubmission_file", without a key.
/// Names and groups have no underscore, but a student's file may have any: the
/// first place that fits is taken. (moodle: mod/assign/classes/downloader.php)
std::optional<PlatformName> parse_moodle(std::string_view entry);

/// "rossianna_LATE_77_4711_prev.cpp", "rossianna_77_text.html",
/// "anon_Xy1z2_4711_prev.cpp" (key Xy1z2). The first place that fits is taken.
/// (canvas-lms: lib/content_zipper.rb)
std::optional<PlatformName> parse_canvas(std::string_view entry);

/// "submission_123456", the name of a folder.
std::optional<PlatformName> parse_gradescope(std::string_view entry);

}  // namespace grader

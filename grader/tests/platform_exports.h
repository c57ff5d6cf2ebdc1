// The exports of a class of 40 from three platforms, made up: late, double,
// empty and misnamed submissions, and teams. Equal on every machine.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "grader/tests/archive_maker.h"

namespace grader::tests {

inline constexpr int class_size = 40;

inline constexpr const char* right_face_sides =
    "#include \"exercises/01_traversal/face_sides.h\"\n"
    "int face_sides(const HalfEdgeTable& he, int i) {\n"
    "    if (he[i].fi == -1) return 0;\n"
    "    int start = i, sides = 0;\n"
    "    do { ++sides; i = he[i].next; } while (i != start);\n"
    "    return sides;\n}\n";

/// What a student of the class handed in is the same on all platforms.
struct MadeUp {
    enum class Kind { plain, late, twice, empty, misnamed };

    int number = 0;  ///< 1 to 40
    Kind kind = Kind::plain;
    std::string first, last;
    std::string name() const { return first + " " + last; }
    /// The bytes of their file of that name: face_sides is right.
    std::string file(const std::string& file_name) const {
        const std::string head = fmt::format("// {}\n", name());
        return file_name == "face_sides.cpp" ? head + right_face_sides
                                             : head + "// not begun\n";
    }
};

inline MadeUp made_up(int number) {
    constexpr const char* first[] = {"Anna",         "Bruno", "Carla",
                                     "D\xC3\xA1rio", "Elena", "<b>Fabio",
                                     "=Gina",        "O'Hugo"};
    constexpr const char* last[] = {"Rossi", "de' Medici", "van der Berg",
                                    "M\xC3\xBCller", "Neri"};
    MadeUp one;
    one.number = number;
    one.first = first[number % 8];
    one.last = last[number % 5];
    using Kind = MadeUp::Kind;
    if (number % 10 == 3) one.kind = Kind::late;
    if (number % 10 == 5) one.kind = Kind::twice;
    if (number % 10 == 7) one.kind = Kind::empty;
    if (number == 19) one.kind = Kind::misnamed;
    return one;
}

inline std::vector<MadeUp> made_up_class() {
    std::vector<MadeUp> all;
    for (int number = 1; number <= class_size; ++number)
        all.push_back(made_up(number));
    return all;
}

/// The two files of a student of that kind.
inline const std::vector<std::string> made_up_files = {"face_sides.cpp",
                                                       "prev.cpp"};

/// Moodle's number of a student, Canvas's and Gradescope's.
inline int moodle_number(const MadeUp& one) {
    return 5000 + one.number;
}
inline int canvas_number(const MadeUp& one) {
    return 700 + one.number;
}
inline int gradescope_number(const MadeUp& one) {
    return 90000 + one.number;
}

/// Folders as Moodle makes them.
inline std::string moodle_export() {
    std::vector<Packed> entries;
    for (const MadeUp& one : made_up_class()) {
        const std::string folder =
            one.kind == MadeUp::Kind::misnamed
                ? one.name()
                : fmt::format("{}_{}_assignsubmission_file", one.name(),
                              moodle_number(one));
        if (one.kind == MadeUp::Kind::empty)
            entries.push_back({folder + "/", "", AE_IFDIR, 0755});
        else
            for (const std::string& file : made_up_files)
                entries.push_back({folder + "/" + file, one.file(file)});
        if (one.kind == MadeUp::Kind::twice)
            entries.push_back({folder + "/old/prev.cpp", "// older\n"});
    }
    return packed(zip, entries);
}

/// Eight teams of five, by the last digit of eight: only the name of the team
/// is in the export.
inline int team_of(const MadeUp& one) {
    return 1 + one.number % 8;
}

inline std::string moodle_team_export() {
    std::vector<Packed> entries;
    for (int team = 1; team <= 8; ++team)
        entries.push_back(
            {fmt::format("Team {0}_{1}_assignsubmission_file/face_sides.cpp",
                         team, 900 + team),
             made_up(team).file("face_sides.cpp")});
    return packed(zip, entries);
}

inline std::string csv_text(const std::string& text) {
    return "\"" + text + "\"";  // no name has a quote
}

/// The worksheet of these teams; the third handed in two days after the due
/// date, 2026-12-11 23:59.
inline std::string moodle_team_worksheet() {
    std::string text =
        "Identifier,\"Full name\",\"Email address\",Status,Group,Grade,"
        "\"Maximum Grade\",\"Grade can be changed\","
        "\"Last modified (submission)\",\"Last modified (grade)\","
        "\"Feedback comments\"\n";
    for (const MadeUp& one : made_up_class())
        text += fmt::format(
            "Participant {},{},s{}@example.org,Submitted,Team {},,100.00,Yes,"
            "\"{}\",-,\n",
            moodle_number(one), csv_text(one.name()), one.number, team_of(one),
            team_of(one) == 3 ? "Sunday, 13 December 2026, 11:00 AM"
                              : "Friday, 11 December 2026, 11:59 PM");
    return text;
}

/// "rossianna", as Canvas writes a sortable name.
inline std::string canvas_name(const MadeUp& one) {
    std::string name;
    for (const char c : one.last + one.first)
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0)
            name += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return name;
}

/// All files in one folder. Who handed in twice has an older upload, too.
inline std::string canvas_export() {
    std::vector<Packed> entries;
    int upload = 41000;
    for (const MadeUp& one : made_up_class()) {
        const std::string who = fmt::format(
            "{}{}_{}", canvas_name(one),
            one.kind == MadeUp::Kind::late ? "_LATE" : "", canvas_number(one));
        if (one.kind == MadeUp::Kind::empty) {
            entries.push_back({who + "_text.html", "<p>sorry</p>"});
            continue;
        }
        const bool twice = one.kind == MadeUp::Kind::twice;
        if (twice)
            entries.push_back(
                {fmt::format("{}_{}_prev.cpp", who, ++upload), "// older\n"});
        for (const std::string& file : made_up_files) {
            const std::string stem = file.substr(0, file.find('.'));
            entries.push_back({fmt::format("{}_{}_{}{}.cpp", who, ++upload,
                                           stem, twice ? "-1" : ""),
                               one.file(file)});
        }
        if (one.kind == MadeUp::Kind::misnamed)
            entries.push_back({one.name() + ".cpp", "// whose?\n"});
    }
    return packed(zip, entries);
}

/// A quoted scalar of YAML.
inline std::string yaml_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return quoted + "'";
}

/// Of a team its members; a student alone is one.
inline std::vector<MadeUp> gradescope_team(const MadeUp& one) {
    if (one.number == 31) return {one, made_up(33), made_up(34)};
    if (one.number == 32) return {one, made_up(35)};
    return {one};
}

/// Whether another's submission has this student as a member.
inline bool hands_in_with_another(const MadeUp& one) {
    return one.number >= 33 && one.number <= 35;
}

inline std::string gradescope_facts(const std::string& folder,
                                    const std::vector<MadeUp>& members,
                                    const std::string& time) {
    std::string text = folder + ":\n  :submitters:\n";
    for (const MadeUp& one : members)
        text += fmt::format(
            "  - :name: {}\n    :sid: '{}'\n    :email: s{}@example.org\n",
            yaml_text(one.name()), 100 + one.number, one.number);
    return text + "  :created_at: " + time + "\n  :score: 0.0\n";
}

/// Due 2026-12-11 23:59 in Rome: late are those of two days later.
inline std::string gradescope_export() {
    const std::string root = "assignment_77_export/";
    std::vector<Packed> entries;
    std::string facts = "---\n";
    for (const MadeUp& one : made_up_class()) {
        if (hands_in_with_another(one)) continue;
        const std::string folder =
            fmt::format("submission_{}", gradescope_number(one));
        const bool late = one.kind == MadeUp::Kind::late;
        facts += gradescope_facts(folder, gradescope_team(one),
                                  late ? "2026-12-13 10:00:00.000000000 Z"
                                       : "2026-12-11 10:00:00.000000000 Z");
        if (one.kind == MadeUp::Kind::empty)
            entries.push_back({root + folder + "/", "", AE_IFDIR, 0755});
        else
            for (const std::string& file : made_up_files)
                entries.push_back({root + folder + "/" + file, one.file(file)});
        if (one.kind != MadeUp::Kind::twice) continue;
        const std::string older =
            fmt::format("submission_{}", 10000 + one.number);
        facts +=
            gradescope_facts(older, {one}, "2026-12-10 10:00:00.000000000 Z");
        entries.push_back({root + older + "/prev.cpp", "// older\n"});
    }
    entries.push_back({root + "submission_metadata.yml", facts});
    return packed(zip, entries);
}

}  // namespace grader::tests

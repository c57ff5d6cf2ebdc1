// grader release DIR
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "course/runner/exercises.h"
#include "grader/cli/commands.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

/// What of the top level a student gets; everything else stays here.
constexpr const char* released[] = {
    "CMakeLists.txt", "course",  "exercises", "data",         ".clang-format",
    ".gitignore",     ".clangd", ".vscode",   ".devcontainer"};

/// Of data/, what holds submissions is not for students.
bool is_withheld(const fs::path& path) {
    return path.filename().string().rfind("sample_class", 0) == 0;
}

void copy_tree(const fs::path& from, const fs::path& to) {
    if (is_withheld(from)) return;
    if (fs::is_directory(from)) {
        fs::create_directories(to);
        for (const auto& entry : fs::directory_iterator(from))
            copy_tree(entry.path(), to / entry.path().filename());
    } else {
        fs::copy_file(from, to);
    }
}

/// `lab reset` puts a student's file back to what stands here.
void keep_originals(const fs::path& dir) {
    for (const course::Exercise& exercise : course::all_exercises()) {
        const fs::path folder = dir / ".lab" / "originals" / exercise.topic;
        fs::create_directories(folder);
        fs::copy_file(exercise.skeleton(), folder / exercise.file_name());
    }
}

/// The student's part of the README: title, and from its heading to the next.
std::string student_readme(const std::string& readme) {
    const std::string heading = "## For students";
    const auto begin = readme.find(heading);
    if (begin == std::string::npos)
        throw CannotBegin("README.md has no section \"" + heading + "\"");
    const auto end = readme.find("\n## ", begin + heading.size());
    const std::string title = readme.substr(0, readme.find('\n'));
    return title + "\n\n" +
           readme.substr(begin, end == std::string::npos ? end : end - begin) +
           "\n";
}

void write_readme(const fs::path& file) {
    std::ofstream out(file);
    out << student_readme(
        course::read_file(course::source_root() / "README.md"));
    if (!out.flush())
        throw course::SystemError("cannot write " + file.string());
}

/// The same place, without a slash at its end.
fs::path plain(const fs::path& given) {
    const fs::path path = fs::absolute(given).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

int release_command(const fs::path& given) {
    const fs::path dir = plain(given);
    if (fs::exists(dir) && !fs::is_empty(dir))
        throw CannotBegin(fmt::format(
            "{} is not empty: the student's copy wants a folder of its own",
            dir.string()));
    // Made beside its place and renamed: nobody finds half a copy.
    const fs::path making = dir.string() + ".making";
    if (fs::exists(making))
        throw CannotBegin(fmt::format(
            "{} is in the way: remove it if a release that was cut short has "
            "left it",
            making.string()));
    fs::create_directories(making);
    for (const char* name : released)
        if (const fs::path from = course::source_root() / name;
            fs::exists(from))
            copy_tree(from, making / name);
    keep_originals(making);
    write_readme(making / "README.md");
    if (fs::exists(dir)) fs::remove(dir);
    fs::rename(making, dir);
    fmt::print(
        "The student's copy is in {}: {} exercises, no solutions, "
        "nothing of the grader.\n",
        dir.string(), course::all_exercises().size());
    return 0;
}

}  // namespace

void add_release(CLI::App& program, int& code) {
    auto dir = std::make_shared<fs::path>();
    CLI::App* command = program.add_subcommand(
        "release",
        "Make the student's copy: this tree without solutions and grader");
    command->add_option("dir", *dir, "a new or empty folder")->required();
    command->footer("Exit code: 0 made, 2 wrong usage.");
    command->callback([dir, &code] { code = release_command(*dir); });
}

}  // namespace grader

// lab demo: walks on the half-edge table as pages.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "course/cli/commands.h"
#include "course/cli/demo_set.h"
#include "course/cli/live.h"
#include "course/halfedge/build.h"
#include "course/mesh/clean.h"
#include "course/mesh/file_defects.h"
#include "course/mesh/mesh_file.h"
#include "course/player/record.h"
#include "course/player/walk_page.h"
#include "course/runner/process.h"

namespace course {

namespace {

namespace fs = std::filesystem;

struct DemoOptions {
    std::string exercise;
    fs::path file, mesh;
    std::vector<int> starts;
    fs::path out, json, all;
    bool clean = false;
    bool open = false;
    bool live = false;
    int port = 0;
};

IndexedMesh cleaned(const fs::path& file, IndexedMesh mesh) {
    Cleaned result = clean(std::move(mesh));
    fmt::print("{}: {}\n{}", file.string(),
               counted(result.changes.size(), "change"),
               to_string(result.changes));
    return std::move(result.mesh);
}

Fixture fixture_from(const DemoOptions& options) {
    const fs::path& file = options.mesh;
    try {
        Fixture fixture;
        fixture.name = file.stem();
        fixture.mesh = read_mesh(file);
        if (options.clean)
            fixture.mesh = cleaned(file, std::move(fixture.mesh));
        fixture.he = build(fixture.mesh);
        return fixture;
    } catch (const UnknownMeshFile& error) {
        throw CannotShow(error.what());
    } catch (const MeshFileError& error) {
        throw CannotShow(error.what());
    } catch (const BuildError& error) {
        throw CannotShow(fmt::format("{}: {}\n(with --clean it is mended)",
                                     file.string(), error.what()));
    }
}

RecordOptions record_options(const Desk& desk, const Exercise& exercise,
                             const DemoOptions& options) {
    RecordOptions recorded;
    recorded.file = options.file;
    if (recorded.file.empty() && (options.live || !has_solutions()))
        recorded.file = desk.file(exercise);
    if (!recorded.file.empty() && !fs::is_regular_file(recorded.file))
        throw CannotShow(fmt::format("{} is no file", recorded.file.string()));
    recorded.starts = options.starts;
    if (!options.mesh.empty()) recorded.mesh = fixture_from(options);
    // Of a large mesh nobody wants all walks; from the others one walks by
    // hand.
    if (recorded.mesh && recorded.mesh->mesh.faces.size() > most_drawn_faces &&
        recorded.starts.empty())
        recorded.starts = {0};
    if (const char* compiler = std::getenv("COURSE_CXX"))
        recorded.compiler = compiler;
    return recorded;
}

/// Where there is a screen, and a program that opens pages on it.
void open_page(const fs::path& page) {
    Command command;
    command.arguments = {"sh", "-c",
                         "[ \"$(uname)\" != Darwin ] || exec open \"$0\"; "
                         "[ -n \"$DISPLAY$WAYLAND_DISPLAY\" ] || exit 1; "
                         "if command -v wslview; then exec wslview \"$0\"; fi; "
                         "exec xdg-open \"$0\"",
                         fs::absolute(page).string()};
    for (char** variable = environ; *variable != nullptr; ++variable)
        command.environment.emplace_back(*variable);
    Process(command).wait();
}

void write(const DemoOptions& options, const Recording& recording) {
    if (!options.json.empty()) {
        replace_text(options.json, to_json(recording));
        fmt::print("The recording is in {}.\n", options.json.string());
    }
    if (!options.json.empty() && options.out.empty()) return;
    const fs::path page = options.out.empty()
                              ? fs::path(recording.exercise + ".html")
                              : options.out;
    replace_text(page, walk_page(recording));
    fmt::print("{} {} in {}: open it in a browser.\n", recording.walks.size(),
               recording.walks.size() == 1 ? "walk is" : "walks are",
               page.string());
    if (options.open) open_page(page);
}

int demo_one(const Exercise& exercise, const RecordOptions& recorded,
             const DemoOptions& options) {
    try {
        const Recording recording = record(exercise, recorded);
        for (const std::string& note : recording.notes)
            fmt::print(stderr, "lab: {}\n", note);
        write(options, recording);
    } catch (const DoesNotCompile& error) {
        fmt::print(stderr, "{} does not compile:\n{}\n", exercise.name,
                   error.what());
        return 1;
    }
    return 0;
}

int demo(const Desk& desk, const DemoOptions& options) {
    if (!options.all.empty()) return demo_set(desk, options.all);
    if (options.exercise.empty())
        throw CannotShow("which exercise? What can be shown is" +
                         what_can_be_shown());
    const Exercise exercise = exercise_named(options.exercise);
    require_can_be_shown(exercise);
    const RecordOptions recorded = record_options(desk, exercise, options);
    make_ready_to_record({exercise});
    if (options.live)
        return live(recorded.file, options.port,
                    [&] { return walk_page(record(exercise, recorded)); });
    return demo_one(exercise, recorded, options);
}

CLI::App* add_options(CLI::App& program, DemoOptions& options) {
    CLI::App* command = program.add_subcommand(
        "demo", "Show walks on the half-edge table, step by step, as a page");
    command->add_option("exercise", options.exercise,
                        "its name; without it: what can be shown");
    command->add_option("--file", options.file,
                        "a student's file, right or wrong, beside the "
                        "reference");
    CLI::Option* mesh = command->add_option(
        "--mesh", options.mesh,
        "an .obj or .off file in place of the slide's mesh; from 200 faces on "
        "the page shows it in 3D");
    command
        ->add_flag("--clean", options.clean,
                   "mend a mesh that has no table, and say how")
        ->needs(mesh);
    command->add_option("--start", options.starts,
                        "the half-edges (or vertices) to start from (default: "
                        "each of them; on large meshes 0)");
    command->add_option("--out", options.out,
                        "the page (default NAME.html here)");
    command->add_option("--json", options.json,
                        "the recording itself, for other programs; then no "
                        "page, unless --out asks for one");
    command->add_flag("--open", options.open, "open the page in a browser");
    CLI::Option* live = command->add_flag(
        "--live", options.live,
        "a page on this machine that follows your file: each save is "
        "recorded and shown");
    for (const char* other : {"--out", "--json", "--open"})
        live->excludes(command->get_option(other));
    command
        ->add_option("--port", options.port,
                     "of the live page (default: one that is free)")
        ->needs(live)
        ->check(CLI::Range(1, 65535));
    CLI::Option* all = command->add_option(
        "--all", options.all,
        "a folder for the whole set: the pictures of the lecture notes, the "
        "walks of all exercises, and index.html");
    for (CLI::Option* other : command->get_options())
        if (other != all && other != command->get_help_ptr())
            all->excludes(other);
    command->footer(
        "COURSE_CXX in the environment is another compiler to use.\n"
        "Exit code: 0 written, 1 a file does not compile, 2 wrong usage, 3 "
        "the recording itself failed.");
    return command;
}

}  // namespace

void add_demo(CLI::App& program, const Desk& desk, int& code) {
    const auto options = std::make_shared<DemoOptions>();
    add_options(program, *options)->callback([options, &desk, &code] {
        code = demo(desk, *options);
    });
}

}  // namespace course

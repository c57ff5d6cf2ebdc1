// What lab remembers: states over a series of checks, the file that holds
// them, what comes next, and files put back.
#include "course/cli/progress.h"

#include <fstream>

#include "course/cli/commands.h"
#include "course/runner/catch2.h"
#include "course/runner/temporary_folder.h"

using namespace course;
namespace fs = std::filesystem;

namespace {

struct DeskFolder {
    TemporaryFolder folder;
    Desk desk{folder.path()};
};

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

std::string complaint_about(const Desk& desk) {
    try {
        read_progress(desk);
    } catch (const CannotBegin& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a solved exercise that fails later is broken, and solved again") {
    const Exercise exercise = exercise_named("tip");
    Progress progress;
    CHECK(progress.state(exercise) == State::untouched);
    progress.note(exercise, "a", false);
    CHECK(progress.state(exercise) == State::tried);
    progress.note(exercise, "b", true);
    CHECK(progress.state(exercise) == State::solved);
    progress.note(exercise, "c", false);
    CHECK(progress.state(exercise) == State::broken);
    progress.note(exercise, "d", false);
    CHECK(progress.state(exercise) == State::broken);
    progress.note(exercise, "e", true);
    CHECK(progress.state(exercise) == State::solved);
}

TEST_CASE("what is written is read again") {
    const DeskFolder at;
    change_progress(at.desk, [](Progress& progress) {
        progress.current = "prev";
        progress.note(exercise_named("tip"), "text", true);
        progress.note(exercise_named("prev"), "other", false);
    });
    const Progress progress = read_progress(at.desk);
    CHECK(progress.current == "prev");
    CHECK(progress.state(exercise_named("tip")) == State::solved);
    CHECK(progress.entries.at("tip").mark == mark_of("text"));
    CHECK(progress.state(exercise_named("prev")) == State::tried);
    const std::string text = read_file(at.desk.memory() / "progress");
    CHECK(text.find("solved tip ") != std::string::npos);
}

TEST_CASE("a line that lab did not write is refused by its number") {
    const DeskFolder at;
    for (const char* line :
         {"solved", "solved tip", "solvd tip 0123", "solved tip 0123 more",
          "current", "current a b c"}) {
        write(at.desk.memory() / "progress",
              std::string("# note\n\n") + line + "\n");
        INFO(line);
        CHECK(complaint_about(at.desk).find("progress:3: ") !=
              std::string::npos);
    }
}

TEST_CASE("next passes over what is solved and comes round") {
    const auto all = all_exercises();
    Progress progress;
    CHECK(progress.current_exercise().name == all[0].name);
    CHECK(progress.next_after(all[0]).name == all[1].name);
    progress.note(all[1], "", true);
    CHECK(progress.next_after(all[0]).name == all[2].name);
    CHECK(progress.next_after(all.back()).name == all[0].name);
    for (const Exercise& exercise : all) progress.note(exercise, "", true);
    CHECK(progress.next_after(all[3]).name == all[3].name);
}

TEST_CASE("an exercise that is gone is no current one") {
    Progress progress;
    progress.current = "no_such_exercise";
    CHECK(progress.current_exercise().name == all_exercises()[0].name);
}

TEST_CASE("reset puts the original back, keeps each file, and forgets") {
    const DeskFolder at;
    const Exercise exercise = exercise_named("face_sides");
    CHECK_FALSE(reset_exercise(at.desk, exercise).has_value());
    CHECK(at.desk.is_untouched(exercise));
    std::vector<std::string> kept;
    for (const char* text : {"first", "second"}) {
        write(at.desk.file(exercise), text);
        CHECK_FALSE(at.desk.is_untouched(exercise));
        change_progress(at.desk, [&](Progress& progress) {
            progress.note(exercise, text, true);
        });
        const auto backup = reset_exercise(at.desk, exercise);
        REQUIRE(backup.has_value());
        CHECK(read_file(*backup) == text);
        kept.push_back(backup->string());
    }
    CHECK(kept[0] != kept[1]);
    CHECK(read_file(kept[0]) == "first");
    CHECK(read_progress(at.desk).state(exercise) == State::untouched);
    CHECK(read_file(at.desk.file(exercise)) == read_file(exercise.skeleton()));
}

TEST_CASE("a tree without originals says so and changes nothing") {
    const Exercise exercise = exercise_named("face_sides");
    if (fs::exists(source_root() / ".lab" / "originals")) return;
    const std::string before = read_file(exercise.skeleton());
    CHECK_THROWS_AS(Desk().reset(exercise), CannotBegin);
    CHECK(read_file(exercise.skeleton()) == before);
}

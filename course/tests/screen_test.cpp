// What is shown on a screen: lines broken in the right places, keys told apart,
// pages of two sizes as golden files.
#include "course/cli/screen.h"

#include <algorithm>

#include "course/cli/explain_result.h"
#include "course/cli/watch_page.h"
#include "course/mesh/zoo.h"
#include "course/report/mesh_text.h"
#include "course/report/text.h"
#include "course/runner/statement.h"
#include "course/tests/golden.h"

using namespace course;

namespace {

using Lines = std::vector<std::string>;

/// Without the escape sequences: what a person reads.
std::string plain(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) {
        for (std::size_t k = 0; k < line.size(); ++k)
            if (line[k] == '\033')
                k = line.find('m', k);
            else
                text += line[k];
        text += "\n";
    }
    return text;
}

void check_golden(const std::string& name, const std::string& got) {
    tests::check_golden("course/tests/golden", name, got);
}

/// A walk that never ends, as the judge reports it.
ExerciseResult endless() {
    const Fixture slide = zoo::slide();
    CaseResult failed;
    failed.info = {"the faces of the slide mesh have 3, 4 and 3 sides", 2,
                   Visibility::shown};
    failed.verdict = Verdict::time_limit_exceeded;
    failed.hint = "What do you count, and when have you counted every side?";
    Failure failure;
    failure.call = "face_sides(he, 1)";
    failure.got =
        "line 8: the walk does not end: he[2] he[6] he[7] he[10] he[13] he[0] "
        "are visited again and again (stopped after 101024 reads); the start, "
        "he[1], is never met again";
    failure.mesh = {"slide", slide.he.rows(), slide.mesh.positions};
    for (int turn = 0; turn < 6; ++turn)
        for (const int i : {2, 6, 7, 10, 13, 0}) failure.walk.push_back({i, 8});
    failure.reads = 101024;
    failed.failures = {failure};
    CaseResult passed;
    passed.info = {"a half-edge on the border has no face to count", 1,
                   Visibility::shown};
    passed.verdict = Verdict::accepted;
    return {Verdict::time_limit_exceeded, "", {failed, passed}};
}

ExerciseView view_of_endless() {
    ExerciseView view;
    view.exercise = exercise_named("face_sides");
    view.statement = statement_of(view.exercise);
    view.file = "exercises/01_traversal/face_sides.cpp";
    view.outcome = {explain_result(view.exercise, view.file, endless()), 1};
    view.hints = 1;
    return view;
}

void check_fits(const Lines& lines, ScreenSize size) {
    CHECK(lines.size() == size.lines);
    std::string text = plain(lines);
    for (std::size_t end = 0; (end = text.find('\n')) != text.npos;
         text.erase(0, end + 1)) {
        INFO(text.substr(0, end));
        CHECK(width(text.substr(0, end)) <= size.columns);
    }
}

Lines screen_of_endless(ScreenSize size, std::size_t top = 0) {
    Lines lines = screen_of(exercise_page(view_of_endless(), size), size, top);
    check_fits(lines, size);
    return lines;
}

}  // namespace

TEST_CASE("long lines are broken between words, and keep their margin") {
    CHECK(wrapped("one two three", 8) == Lines{"one two", "three"});
    CHECK(wrapped("  one two three", 10) == Lines{"  one two", "  three"});
    CHECK(wrapped("abcdefghij", 4) == Lines{"abcd", "efgh", "ij"});
    CHECK(wrapped("a\n\nb\n", 9) == Lines{"a", "", "b"});
    CHECK(wrapped("\tx", 9) == Lines{"    x"});
    CHECK(wrapped("", 9).empty());
    // Characters are counted, not bytes.
    CHECK(wrapped("äöü äöü", 7) == Lines{"äöü äöü"});
    CHECK(wrapped("bbää", 3) == Lines{"bbä", "ä"});
    CHECK(wrapped("one two", 3) == Lines{"one", "two"});
    CHECK(wrapped("面面 面", 5) == Lines{"面面", "面"});
}

TEST_CASE("no width is too small to be tried") {
    for (std::size_t columns = 2; columns < 9; ++columns)
        for (const std::string& line :
             wrapped("      deeply indented words, and a_very_long_one 面面",
                     columns)) {
            INFO(columns << ": " << line);
            CHECK(width(line) <= columns);
        }
}

TEST_CASE("keys come one by one, those of the arrows as one each") {
    CHECK(keys_in("nq") == std::vector<int>{'n', 'q'});
    CHECK(keys_in("\033[A\033[B\033OA") ==
          std::vector<int>{key_up, key_down, key_up});
    CHECK(keys_in("\033[5~\033[6~") ==
          std::vector<int>{key_page_up, key_page_down});
    CHECK(keys_in("\033") == std::vector<int>{key_escape});
    CHECK(keys_in("\r\x7f\b") ==
          std::vector<int>{key_enter, key_backspace, key_backspace});
    // Unknown sequences, whole or cut, are no keys.
    CHECK(keys_in("\033[1;5Cx") == std::vector<int>{'x'});
    CHECK(keys_in("\033[15~").empty());
    CHECK(keys_in("\033[1").empty());
}

TEST_CASE("a screen is full, scrolls, and stays in range") {
    Page page;
    page.head = {"head"};
    for (int k = 0; k < 30; ++k) page.body.push_back(std::to_string(k));
    page.foot = "foot";
    std::size_t top = 0;
    const std::string first = plain(screen_of(page, {20, 10}, top));
    CHECK(first.find("head\n0\n1\n") == 0);
    CHECK(first.find("-- 23 more lines: space") != std::string::npos);
    top = 1000;
    const std::string last = plain(screen_of(page, {20, 10}, top));
    CHECK(top == 23);
    CHECK(last.find("29\n-- the end; back: b\nfoot\n") != std::string::npos);
    for (std::size_t lines = 1; lines < 12; ++lines) {
        top = 5;
        CHECK(screen_of(page, {20, lines}, top).size() == lines);
    }
}

TEST_CASE("an endless walk in a small terminal") {
    const ScreenSize size{80, 24};
    check_golden("endless_80x24.txt", plain(screen_of_endless(size)));
    check_golden("endless_80x24_below.txt", plain(screen_of_endless(size, 18)));
}

TEST_CASE("an endless walk in a large terminal, the statement beside it") {
    check_golden("endless_200x50.txt", plain(screen_of_endless({200, 50})));
}

TEST_CASE("a narrow terminal gets narrow lines") {
    screen_of_endless({40, 30});
}

TEST_CASE("an untouched exercise begins with its statement") {
    ExerciseView view = view_of_endless();
    view.is_untouched = true;
    view.hints = 0;
    const std::string text = plain(exercise_page(view, {80, 24}).body);
    CHECK(text.find("Count the sides of a face") <
          text.find("time limit exceeded"));
}

TEST_CASE("the selected exercise is in sight, however long the list is") {
    ListView view;
    for (const Exercise& exercise : all_exercises())
        view.found.push_back({exercise, "title"});
    for (const std::size_t selected :
         {std::size_t{0}, std::size_t{17}, view.found.size() - 1}) {
        view.selected = selected;
        std::size_t top = 0;
        const std::string text =
            plain(screen_of(list_page(view, {80, 24}), {80, 24}, top));
        CHECK(text.find("> " + view.found[selected].exercise.topic) !=
              std::string::npos);
    }
}

TEST_CASE("meshes that can be told apart in characters are drawn") {
    std::string all;
    Walk walk;
    walk.steps = {4};
    for (const Fixture& fixture : zoo::with_table())
        if (const std::string text = mesh_text(
                {fixture.name, fixture.he.rows(), fixture.mesh.positions}, walk,
                48, 18);
            !text.empty())
            all += fixture.name + "\n" + text + "\n";
    CHECK(all.find("slide") == 0);
    check_golden("meshes.txt", all);
    CHECK(mesh_text({"no positions", zoo::slide().he.rows(), {}}, walk, 48, 18)
              .empty());
    const Fixture slide = zoo::slide();
    CHECK(mesh_text({"no room", slide.he.rows(), slide.mesh.positions}, walk, 9,
                    4)
              .empty());
}

// A submission with the mistake of a stored wrong submission is recognised, its
// student reads the hint and nothing else of it, and the class report counts
// it.
#include <fstream>

#include "course/runner/temporary_folder.h"
#include "grader/pipeline/mistakes.h"
#include "grader/pipeline/wrong_submissions.h"
#include "grader/report/class_page.h"
#include "grader/report/feedback.h"
#include "grader/report/gradescope.h"
#include "grader/report/student_page.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace fs = std::filesystem;

namespace {

constexpr const char* exercise = "01_traversal/face_sides";
const std::string hint = "You went on by next and never by opp.";

KnownMistake known(const ExerciseResult& result, std::string mistake,
                   std::string for_students) {
    return {exercise, "name", std::move(mistake), std::move(for_students),
            fingerprint(result)};
}

/// The sample class, where the first exercise of Bruno is recognised.
ClassResults class_with_mistake(FeedbackLevel level) {
    ClassResults all = sample_class();
    all.assignment.hidden_feedback = {level, level};
    all.mistakes = {known(*all.students[1].exercises[0],
                          "SECRET: stops at the border.", hint)};
    return all;
}

/// The text of the student's page below the heading of that exercise.
std::string feedback(const fs::path& out, const std::string& student) {
    return file_contents(out / "students" / student / "feedback.html");
}

void hand_in(const fs::path& folder, const std::string& student,
             const std::string& topic, const std::string& name,
             const std::string& wrong) {
    fs::create_directories(folder / student);
    fs::copy_file(course::source_root() / "grader/wrong" / topic / name /
                      (wrong + ".cpp"),
                  folder / student / (name + ".cpp"));
}

}  // namespace

TEST_CASE("a fingerprint has the cases and the verdict of each") {
    const Verdict ok = Verdict::accepted, wrong = Verdict::wrong_answer,
                  late = Verdict::time_limit_exceeded;
    const auto of = [](Verdict a, Verdict b, Verdict c) {
        return fingerprint(result(std::max({a, b, c}), cases(a, b, c)));
    };
    CHECK(of(ok, wrong, ok) == of(ok, wrong, ok));
    CHECK(of(ok, wrong, ok) != of(wrong, ok, ok));
    CHECK(of(ok, wrong, ok) != of(ok, late, ok));
    auto renamed = result(wrong, cases(ok, wrong, ok));
    renamed.cases[1].info.name = "another case";
    CHECK(fingerprint(renamed) != of(ok, wrong, ok));
    // Nothing can be told by these.
    CHECK(of(ok, ok, ok).empty());
    CHECK(of(wrong, wrong, late).empty());
    CHECK(fingerprint(result(Verdict::compile_error, cases_that_did_not_run()))
              .empty());
    CHECK(fingerprint(*nothing()[0]).empty());
}

TEST_CASE("a mistake is recognised where it fits one, or all have its hint") {
    const ExerciseResult failed = *wrong_and_endless()[0];
    const auto fits = [&](const std::vector<KnownMistake>& all) {
        return recognised(all, exercise, failed);
    };
    CHECK_FALSE(fits({}).has_value());
    REQUIRE(fits({known(failed, "a", hint)}).has_value());
    CHECK(fits({known(failed, "a", hint)})->hint == hint);
    CHECK(fits({known(failed, "a", "")})->mistake == "a");
    CHECK(fits({known(failed, "a", hint), known(failed, "b", hint)}));
    CHECK_FALSE(fits({known(failed, "a", hint), known(failed, "b", "other")}));
    CHECK_FALSE(fits({known(failed, "a", hint), known(failed, "b", "")}));
    CHECK_FALSE(fits({known(failed, "a", ""), known(failed, "b", "")}));
    CHECK_FALSE(fits({known(*crashes()[0], "a", hint)}));
    CHECK_FALSE(recognised({known(failed, "a", hint)}, "other/exercise", failed)
                    .has_value());
}

TEST_CASE("the comment of a wrong submission has mistake and hint") {
    const MistakeText both = mistake_text(
        "// Stops one side\n// too early.\n// Hint: You stop\n// early.\n"
        "#include \"a.h\"\n// Hint: not this\n");
    CHECK(both.mistake == "Stops one side too early.");
    CHECK(both.hint == "You stop early.");
    CHECK(mistake_text("# A table.\n0,1\n").mistake == "A table.");
    CHECK(mistake_text("# A table.\n0,1\n").hint.empty());
    CHECK(mistake_text("int x;\n").mistake.empty());
    CHECK(mistake_text("").mistake.empty());
}

TEST_CASE("every stored wrong submission says what is wrong with it") {
    for (const course::Exercise& one : course::all_exercises())
        for (const WrongSubmission& wrong : wrong_submissions(one).all) {
            const MistakeText text =
                mistake_text(course::read_file(wrong.file));
            INFO(wrong.file.string());
            CHECK_FALSE(text.mistake.empty());
            // What compilers and students are not meant to see stays out.
            CHECK(text.hint.find("he[") == std::string::npos);
        }
}

TEST_CASE("students read the hint as far as hidden cases may be told") {
    for (const auto level :
         {FeedbackLevel::names_and_hints, FeedbackLevel::full}) {
        const ClassResults all = class_with_mistake(level);
        CHECK_THAT(student_page(all, all.students[1]).text, Containing(hint));
        CHECK_THAT(gradescope_json(all, all.students[1]), Containing(hint));
        CHECK_THAT(student_page(all, all.students[1]).text,
                   !Containing("stops at the border"));
        CHECK_THAT(student_page(all, all.students[2]).text, !Containing(hint));
    }
    const ClassResults strict = class_with_mistake(FeedbackLevel::names);
    CHECK_THAT(student_page(strict, strict.students[1]).text,
               !Containing(hint));
    CHECK_THAT(gradescope_json(strict, strict.students[1]), !Containing(hint));
    CHECK_THAT(class_page(summary_of(strict)).text,
               Containing("SECRET: stops at the border."));
}

TEST_CASE(
    "what a run knows of mistakes is that of the newest run that counts") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    record(book, sample_class());
    CHECK(book.mistakes().empty());
    const int run = book.begin_run(sample_run());
    const KnownMistake one = known(*wrong_and_endless()[0], "a", hint);
    book.add_mistakes(run, {one});
    REQUIRE(book.mistakes().size() == 1);
    CHECK(book.mistakes()[0].fingerprint == one.fingerprint);
    CHECK(book.mistakes()[0].hint == hint);
    Run proposal = sample_run();
    proposal.proposed = true;
    const int proposed = book.begin_run(proposal);
    CHECK(book.mistakes().size() == 1);
    book.accept(proposed);
    CHECK(book.mistakes().empty());
}

TEST_CASE("only verdicts of partly failed results are looked up") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    record(book, sample_class());
    const auto found = book.partly_failed(1);
    CHECK(found.contains({exercise, Verdict::wrong_answer}));
    CHECK(found.contains({exercise, Verdict::run_time_error}));
    CHECK_FALSE(found.contains({exercise, Verdict::accepted}));
    CHECK_FALSE(
        found.contains({"02_border/boundary_walk", Verdict::compile_error}));
}

TEST_CASE("real mistakes of two exercises are recognised by a run") {
    if (!has_sandbox()) return;
    const course::TemporaryFolder folder;
    const fs::path all = folder / "class", out = folder / "out";
    hand_in(all, "anna", "02_border", "boundary_walk",
            "wrong_answer/face_side_not_accepted");
    hand_in(all, "bruno", "01_traversal", "face_sides",
            "run_time_error/face_index_as_half_edge");
    hand_in(all, "carla", "01_traversal", "face_sides",
            "run_time_error/face_index_as_half_edge");
    fs::create_directories(all / "dario");
    fs::copy_file(
        course::source_root() / "solutions/01_traversal/face_sides.cpp",
        all / "dario/face_sides.cpp");
    std::ofstream(folder / "a.toml")
        << "name = \"Two\"\n[exercises]\nface_sides = 1\nboundary_walk = 1\n";
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words = {
            "run",        all.string(),   "--out",
            out.string(), "--assignment", (folder / "a.toml").string()};
        words.insert(words.end(), more.begin(), more.end());
        const Said said = grader_says(words);
        INFO(said.text);
        CHECK(said.code == 0);
    };
    const std::string looks_like = "This looks like a mistake that we know";
    run({"--no-mistakes"});
    CHECK_THAT(feedback(out, "anna"), !Containing(looks_like));
    run({});
    CHECK_THAT(feedback(out, "anna"), Containing(hint.substr(0, 36)));
    CHECK_THAT(feedback(out, "bruno"),
               Containing("You use the number of a face as that of a "
                          "half-edge."));
    CHECK_THAT(feedback(out, "dario"), !Containing(looks_like));
    const std::string report = file_contents(out / "report.html");
    CHECK_THAT(report, Containing("Never crosses over: nothing to walk"));
    CHECK_THAT(report, Containing("<bdi>bruno</bdi>, <bdi>carla</bdi>"));
}

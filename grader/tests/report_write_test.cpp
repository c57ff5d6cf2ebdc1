// The files of a run: all there, self-contained, and the same every time.
#include "grader/report/write_reports.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "course/report/text.h"
#include "course/runner/temporary_folder.h"
#include "grader/report/terminal.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace fs = std::filesystem;

namespace {

void write(const ClassResults& results, const fs::path& out) {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    record(book, results);
    write_reports(book, results.assignment, out);
}

std::map<std::string, std::string> written(const ClassResults& results) {
    const course::TemporaryFolder folder;
    const fs::path out = folder / "out";
    write(results, out);
    std::map<std::string, std::string> files;
    for (const auto& one : fs::recursive_directory_iterator(out))
        if (one.is_regular_file())
            files[one.path().lexically_relative(out).string()] =
                file_contents(one.path());
    return files;
}

/// The most memory that this process has had at once.
long peak_kib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != text.npos;
}

std::string without_time(std::string page) {
    const std::size_t from = page.find("<time>");
    const std::size_t to = page.find("</time>");
    REQUIRE(to != page.npos);
    return page.erase(from, to - from);
}

std::vector<std::string> lines(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

}  // namespace

TEST_CASE("every student has three files, and the class has two") {
    const ClassResults sample = sample_class();
    const auto files = written(sample);
    CHECK(files.size() == 2 + 3 * sample.students.size());
    CHECK(files.count("report.html") == 1);
    CHECK(files.count("grades.csv") == 1);
    for (const StudentResults& student : sample.students)
        for (const char* name : {"feedback.html", "results.json", "junit.xml"})
            CHECK(files.count("students/" + student.student.id + "/" + name) ==
                  1);
}

TEST_CASE("equal results give equal files, but for the time") {
    ClassResults later = sample_class();
    later.run.started_at = "2025-12-31T23:59:59Z";
    const auto first = written(sample_class());
    CHECK(first == written(sample_class()));
    for (const auto& [name, text] : written(later)) {
        CAPTURE(name);
        if (name.ends_with(".html"))
            CHECK((without_time(text) == without_time(first.at(name))));
        else
            CHECK((text == first.at(name)));
    }
}

TEST_CASE("pages hold no script and fetch nothing") {
    for (const auto& [name, text] : written(sample_class())) {
        if (!name.ends_with(".html")) continue;
        CAPTURE(name);
        for (const char* what :
             {"<script", "javascript:", "http:", "https:", "//",
              " src=", "@import", "url(", "onload", "<link", "<iframe"})
            CHECK_FALSE(contains(text, what));
        CHECK(contains(text, "default-src 'none'"));
    }
}

TEST_CASE("no file holds a byte that its reader could act on") {
    for (const auto& [name, text] : written(sample_class())) {
        CAPTURE(name);
        CHECK(course::visible(text) ==
              text);  // no control, no bidi, valid UTF-8
        CHECK((name.ends_with(".json") || !contains(text, "]]>")));
        CHECK(text.size() < 100'000);  // a megabyte was printed
    }
}

TEST_CASE("links of the class's page lead to the students' pages") {
    const auto files = written(sample_class());
    for (const StudentResults& student : sample_class().students) {
        const std::string page =
            "students/" + student.student.id + "/feedback.html";
        CHECK(contains(files.at("report.html"), "href=\"" + page + "\""));
        CHECK(files.count(page) == 1);
    }
}

TEST_CASE("results.json is JSON with the points of grades.csv") {
    const ClassResults sample = sample_class();
    const auto files = written(sample);
    for (const StudentResults& student : sample.students) {
        const auto json = nlohmann::json::parse(
            files.at("students/" + student.student.id + "/results.json"));
        const Total sum = total(sample, scores_of(student));
        CHECK(json.contains("score") == sum.total.has_value());
        double points = 0;
        for (const auto& test : json.at("tests"))
            points += test.value("score", 0.0);
        if (sum.total) {
            CHECK(json.at("score").get<double>() == *sum.total);
            CHECK(std::abs(points - *sum.total) < 1e-9);
        }
    }
}

TEST_CASE("JUnit: names are unique within a suite") {
    ClassResults results = sample_class();
    auto& cases = results.students[0].exercises[0]->cases;
    for (CaseResult& one : cases) one.info.name = "the same";
    const auto files = written(results);
    const std::string& xml = files.at("students/anna.rossi/junit.xml");
    for (const char* name : {"name=\"the same\"", "name=\"the same (2)\"",
                             "name=\"the same (3)\""})
        CHECK(contains(xml, name));
}

TEST_CASE("the terminal's table fits, however many exercises there are") {
    ClassResults results = sample_class();
    const auto exercises = results.exercises;
    for (int copy = 1; copy < 20; ++copy) {
        for (GradedExercise one : exercises) {
            one.exercise = std::to_string(copy) + "_" + one.exercise;
            results.exercises.push_back(one);
            results.assignment.exercises.push_back({one.exercise, 1});
        }
        for (StudentResults& student : results.students)
            for (std::size_t k = 0; k < 3; ++k)
                student.exercises.push_back(student.exercises[k]);
        for (const std::string& line :
             lines(class_table(summary_of(results), Colour::off)))
            CHECK(course::width(line) <= 100);
    }
}

TEST_CASE("colours only repeat what the letters say") {
    const ClassSummary sample = summary_of(sample_class());
    std::string coloured = class_table(sample, Colour::on);
    for (std::size_t at; (at = coloured.find('\x1b')) != coloured.npos;)
        coloured.erase(at, coloured.find('m', at) + 1 - at);
    // Blanks at the end of a line may differ, where a colour ended it.
    CHECK(coloured == class_table(sample, Colour::off));
    CHECK((colour_of(-1) == Colour::off));
}

TEST_CASE("a student's file that would not change is left alone") {
    const course::TemporaryFolder folder;
    write(sample_class(), folder / "out");
    const fs::path student = folder / "out/students/anna.rossi";
    const fs::path page = student / "feedback.html";
    const fs::path json = student / "results.json";
    const std::string text = file_contents(page);
    // A name that we give to the same file stays with the old one when the
    // report replaces it.
    fs::create_hard_link(page, folder / "page");
    fs::create_hard_link(json, folder / "json");
    ClassResults later = sample_class();
    later.run.started_at = "2025-12-31T23:59:59Z";
    write(later, folder / "out");
    CHECK(fs::equivalent(json, folder / "json"));
    CHECK_FALSE(fs::equivalent(page, folder / "page"));
    CHECK((file_contents(page) != text));
    CHECK((file_contents(folder / "page") == text));
}

TEST_CASE("whatever stands in the place of a student's file is replaced") {
    const course::TemporaryFolder folder;
    const auto files = written(sample_class());
    const std::string name = "students/anna.rossi/junit.xml";
    const fs::path file = folder / "out" / name;
    const std::string& text = files.at(name);
    fs::create_directories(file.parent_path());
    SECTION("other bytes, as many") {
        std::ofstream(file) << std::string(text.size(), 'x');
    }
    SECTION("the right bytes, up to the last") {
        std::ofstream(file) << text.substr(0, text.size() - 1) << 'x';
    }
    SECTION("too few bytes") {
        std::ofstream(file) << text.substr(1);
    }
    SECTION("a link to a file with these bytes") {
        std::ofstream(folder / "other") << text;
        fs::create_symlink(folder / "other", file);
    }
    write(sample_class(), folder / "out");
    REQUIRE(fs::is_regular_file(fs::symlink_status(file)));
    CHECK((file_contents(file) == text));
}

TEST_CASE("a class takes the memory of one student") {
    constexpr int students = 64;
    constexpr long most_kib = 24L * 1024;
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    Run run = sample_run();
    run.students.clear();
    for (int k = 0; k < students; ++k)
        run.students.push_back({fmt::format("s{}", k), "a name", {}});
    const int number = book.begin_run(run);
    ExerciseResult large = *wrong_and_endless()[0];
    large.cases[0].printed = std::string(1 << 20, 'x');
    for (const Student& student : run.students)
        book.record(number,
                    {student.id, run.suites[0].exercise, "key", large, "now"});
    const long before = peak_kib();
    const ClassSummary all =
        write_reports(book, sample_assignment(), folder / "out");
    CHECK(all.students.size() == students);
    CHECK(peak_kib() - before < most_kib);  // all of them: 64 MiB
}

TEST_CASE("a folder that cannot be made is an error that names it") {
    const course::TemporaryFolder folder;
    std::ofstream(folder / "out") << "a file";
    CHECK_THROWS_AS(write(sample_class(), folder / "out"),
                    fs::filesystem_error);
    fs::create_directories(folder / "in" / "report.html");
    CHECK_THROWS_AS(write(sample_class(), folder / "in"), std::runtime_error);
}

// The files of a run: all there, self-contained, and the same every time.
#include "grader/report/write_reports.h"

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

namespace {

std::map<std::string, std::string> written(const ClassResults& results) {
    const course::TemporaryFolder folder;
    write_reports(results, folder.path());
    std::map<std::string, std::string> files;
    for (const auto& one :
         std::filesystem::recursive_directory_iterator(folder.path()))
        if (one.is_regular_file())
            files[one.path().lexically_relative(folder.path()).string()] =
                file_contents(one.path());
    return files;
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
        const Total sum = total(sample, student);
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
        for (const std::string& line : lines(class_table(results, Colour::off)))
            CHECK(course::width(line) <= 100);
    }
}

TEST_CASE("colours only repeat what the letters say") {
    std::string coloured = class_table(sample_class(), Colour::on);
    for (std::size_t at; (at = coloured.find('\x1b')) != coloured.npos;)
        coloured.erase(at, coloured.find('m', at) + 1 - at);
    // Blanks at the end of a line may differ, where a colour ended it.
    CHECK(coloured == class_table(sample_class(), Colour::off));
    CHECK((colour_of(-1) == Colour::off));
}

TEST_CASE("a folder that cannot be made is an error that names it") {
    const course::TemporaryFolder folder;
    std::ofstream(folder / "out") << "a file";
    CHECK_THROWS_AS(write_reports(sample_class(), folder / "out"),
                    std::filesystem::filesystem_error);
    std::filesystem::create_directories(folder / "in" / "report.html");
    CHECK_THROWS_AS(write_reports(sample_class(), folder / "in"),
                    std::runtime_error);
}

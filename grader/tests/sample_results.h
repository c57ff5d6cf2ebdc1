// A small class, made up: five students, three exercises, every verdict, and
// names and outputs of the kind that breaks reports.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grader/pipeline/safe_id.h"
#include "grader/report/class_summary.h"

namespace grader::tests {

using course::CaseResult;
using course::ExerciseResult;
using course::Failure;
using course::MeshPicture;
using course::Verdict;
using course::Visibility;

/// The slide mesh: flat, with a border.
inline MeshPicture slide_picture() {
    return {"slide",
            {{2, -1, 2, 1},
             {0, 0, 3, 0},
             {0, -1, 6, 5},
             {2, 0, 5, 4},
             {1, 1, 11, 3},
             {1, 0, 1, 2},
             {1, -1, 7, 12},
             {4, -1, 10, 15},
             {5, 2, 14, 11},
             {3, 2, 8, 10},
             {5, -1, 13, 9},
             {2, 1, 15, 8},
             {4, 1, 4, 6},
             {3, -1, 0, 14},
             {2, 2, 9, 13},
             {5, 1, 12, 7}},
            {{0, 0, 0},
             {1, 1, 0},
             {1, -1, 0},
             {1.5, -2, 0},
             {2, 1, 0},
             {2, -1, 0}}};
}

/// A tetrahedron: closed, in space.
inline MeshPicture tetra_picture() {
    return {"tetra",
            {{1, 0, 1, 5},
             {2, 0, 2, 6},
             {3, 0, 0, 10},
             {1, 1, 4, 9},
             {0, 1, 5, 7},
             {2, 1, 3, 0},
             {3, 2, 7, 1},
             {2, 2, 8, 4},
             {0, 2, 6, 11},
             {0, 3, 10, 3},
             {1, 3, 11, 2},
             {3, 3, 9, 8}},
            {{-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}}};
}

inline std::vector<Visit> endless_walk() {
    std::vector<Visit> walk;
    for (int k = 0; k < 32; ++k) {
        walk.push_back({4, 9});
        walk.push_back({3, 10});
    }
    return walk;
}

inline CaseResult shown_case(std::string name, double points, Verdict verdict) {
    CaseResult result;
    result.info = {std::move(name), points, Visibility::shown};
    result.verdict = verdict;
    if (verdict != Verdict::accepted)
        result.hint = "What do you count, and when have you counted it all?";
    return result;
}

inline CaseResult hidden_case(std::string name, double points,
                              Verdict verdict) {
    CaseResult result = shown_case(std::move(name), points, verdict);
    result.info.visibility = Visibility::hidden;
    if (verdict == Verdict::accepted) return result;
    result.hint = "Which of your steps relies on the numbering?";
    result.printed = "SECRET print";
    Failure failure;
    failure.call = "SECRET call";
    failure.expected = "SECRET expected";
    failure.got = "SECRET got";
    failure.note = "SECRET note";
    failure.mesh = tetra_picture();
    failure.mesh.name = "SECRET mesh";
    failure.walk = {{7, 12}};
    failure.reads = 1;
    result.failures = {failure};
    return result;
}

inline Failure wrong_count() {
    Failure failure;
    failure.call = "face_sides(he, 1)";
    failure.expected = "3";
    failure.got = "2";
    failure.mesh = slide_picture();
    failure.walk = {{1, 8}, {1, 9}, {3, 9}, {5, 9}};
    failure.reads = 4;
    return failure;
}

inline Failure endless() {
    Failure failure;
    failure.call = "vertex_star(he, 4)";
    failure.expected = "{ 2, 0, 4 }";
    failure.got =
        "more than 101024 reads: the walk goes on at he[4] and he[3] and "
        "never meets its start";
    failure.mesh = slide_picture();
    failure.walk = endless_walk();
    failure.reads = 101024;
    return failure;
}

inline Failure off_the_table() {
    Failure failure;
    failure.call = "face_sides(he, 7)";
    failure.expected = "0";
    failure.got =
        "he[-1] does not exist: the table has 12 half-edges, 0..11. -1 is "
        "the value of he[7].fi, read at line 31";
    failure.note = "a note of the suite, with <b>markup</b> & \"quotes\"";
    failure.mesh = tetra_picture();
    failure.walk = {{7, 31}, {8, 33}, {6, 33}};
    failure.reads = 3;
    return failure;
}

/// Bytes that are markup somewhere, or not text at all.
inline std::string hostile_text() {
    return "<script>alert(1)</script> ]]> =cmd|' /C calc'!A0 "
           "\x1b[31mred\x1b[0m \xE2\x80\xAE"
           "evil\xE2\x80\xAC "
           "\xff\xfe bad bytes, a null \x01, \"quotes\" & ends";
}

inline ExerciseResult result(Verdict verdict, std::vector<CaseResult> cases,
                             std::string message = "") {
    return {verdict, std::move(message), std::move(cases)};
}

/// Three cases of 2, 5 and 3 points with these verdicts; the last is hidden.
inline std::vector<CaseResult> cases(Verdict a, Verdict b, Verdict c) {
    return {shown_case("the faces of the slide mesh", 2, a),
            shown_case("a half-edge on the border has no face", 5, b),
            hidden_case("the numbering does not matter", 3, c)};
}

inline std::vector<CaseResult> cases_that_did_not_run() {
    std::vector<CaseResult> all =
        cases(Verdict::accepted, Verdict::accepted, Verdict::accepted);
    for (CaseResult& one : all) one.verdict = Verdict::compile_error;
    return all;
}

using Results = std::vector<std::optional<ExerciseResult>>;

inline Results all_accepted() {
    const Verdict ok = Verdict::accepted;
    return {result(ok, cases(ok, ok, ok)),
            result(ok, cases(ok, ok, ok),
                   "vertex_star.cpp:4:9: warning: unused variable 'vi'"),
            result(ok, cases(ok, ok, ok))};
}

inline Results wrong_and_endless() {
    const Verdict ok = Verdict::accepted, wrong = Verdict::wrong_answer,
                  late = Verdict::time_limit_exceeded;
    auto first = cases(wrong, ok, wrong);
    first[0].failures = {wrong_count(), off_the_table()};
    auto second = cases(late, ok, late);
    second[0].failures = {endless()};
    second[0].printed = hostile_text();
    return {result(wrong, first), result(late, second),
            result(Verdict::compile_error, cases_that_did_not_run(),
                   "boundary_walk.cpp:7:5: error: 'struct HalfEdge' has no "
                   "member named 'v'\n    7 |     he[i].v;\n" +
                       hostile_text())};
}

inline Results crashes() {
    const Verdict ok = Verdict::accepted, crash = Verdict::run_time_error,
                  memory = Verdict::memory_limit_exceeded,
                  forbidden = Verdict::forbidden_operation;
    auto first = cases(ok, crash, ok);
    first[1].failures = {off_the_table()};
    first[1].printed = std::string(1'000'000, 'x') + "\nlast line";
    return {result(crash, first), result(memory, cases(memory, ok, ok)),
            result(forbidden, cases(ok, forbidden, forbidden))};
}

inline Results nothing() {
    const ExerciseResult missing = result(Verdict::not_submitted, {});
    return {missing, missing, missing};
}

inline Results fault() {
    const Verdict wrong = Verdict::wrong_answer, ok = Verdict::accepted;
    return {result(Verdict::grader_fault, {},
                   "SECRET fault: the sandbox could not be started"),
            result(wrong, cases(ok, ok, wrong)),
            result(Verdict::not_submitted, {})};
}

inline std::vector<std::string> sample_names() {
    return {"anna.rossi", "Bruno <script>alert('b')</script>",
            "=cmd|' /C calc'!A0", "carla", "dario\xE2\x80\xAEgnp.\xC3\xA0\xff"};
}

inline std::vector<std::vector<std::string>> sample_notes() {
    return {{},
            {"week1/face_sides (1).cpp: ignored, as file names must be exact; "
             "did you mean face_sides.cpp?"},
            {"x\x1b]0;title\x07.cpp: is a symbolic link: refused"},
            {},
            {}};
}

inline Run sample_run() {
    Run run;
    run.started_at = "2024-03-01T09:30:00Z";
    run.version = "1.0";
    run.sandbox = "bubblewrap, seccomp, cgroup";
    run.seed = 18446744073709551615u;
    run.jobs = 2;
    run.suites = {
        {"01_traversal/face_sides", "face_sides.cpp", "a1b2c3", 10},
        {"01_traversal/vertex_star", "vertex_star.cpp", "d4e5f6", 10},
        {"02_border/boundary_walk", "boundary_walk.cpp", "789abc", 10}};
    run.notes = {"README.txt: ignored; expected a folder for each student"};
    const std::vector<std::string> names = sample_names();
    const std::vector<std::string> ids = safe_ids(names);
    for (std::size_t k = 0; k < names.size(); ++k)
        run.students.push_back({ids[k], names[k], sample_notes()[k]});
    return run;
}

inline Assignment sample_assignment() {
    return {"First <light>",
            {{"01_traversal/face_sides", 1},
             {"01_traversal/vertex_star", 1.5},
             {"02_border/boundary_walk", 1}},
            {FeedbackLevel::names_and_hints, FeedbackLevel::names_and_hints}};
}

inline ClassResults sample_class() {
    ClassResults all;
    all.assignment = sample_assignment();
    all.run = sample_run();
    for (std::size_t k = 0; k < 3; ++k)
        all.exercises.push_back({all.assignment.exercises[k].exercise,
                                 all.assignment.exercises[k].weight,
                                 all.run.suites[k]});
    const std::vector<Results> results = {all_accepted(), wrong_and_endless(),
                                          crashes(), nothing(), fault()};
    for (std::size_t k = 0; k < results.size(); ++k)
        all.students.push_back({all.run.students[k], results[k]});
    return all;
}

inline ClassSummary summary_of(const ClassResults& results) {
    ClassSummary all{results, {}, {}, {}};
    for (const StudentResults& student : results.students) add(all, student);
    return all;
}

/// Writes the class down as a run does.
inline void record(Gradebook& book, const ClassResults& results) {
    const int run = book.begin_run(results.run);
    for (const StudentResults& student : results.students)
        for (std::size_t k = 0; k < student.exercises.size(); ++k)
            if (const auto& result = student.exercises[k])
                book.record(run,
                            {student.student.id, results.exercises[k].exercise,
                             "key", *result, "now"});
}

}  // namespace grader::tests

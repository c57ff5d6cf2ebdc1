#include "grader/report/student_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "course/report/explain.h"
#include "course/report/mesh_drawing.h"
#include "course/report/text.h"
#include "grader/report/feedback.h"
#include "grader/report/page.h"

namespace grader {

namespace {

using course::CaseResult;
using course::ExerciseResult;
using course::Failure;
using course::Verdict;

// ---- one failed check

Html entry(std::string_view label, std::string_view style,
           const std::string& value) {
    if (value.empty()) return {};
    return markup(R"(<dt>{}</dt><dd class="{}">{}</dd>)"
                  "\n",
                  label, style, course::shortened(value, 1200, 16));
}

std::string mesh_entry(const course::MeshPicture& mesh, const Html& drawing) {
    if (mesh.name.empty() || !drawing.text.empty()) return mesh.name;
    return mesh.name + " (not drawn: it has too many half-edges)";
}

std::string caption(const course::MeshPicture& mesh, const course::Walk& walk) {
    std::string text;
    if (!walk.steps.empty())
        text =
            "Thick arrows were read; the dark number is the step at which "
            "the walk came to them. ";
    if (std::any_of(mesh.rows.begin(), mesh.rows.end(),
                    [](const HalfEdge& row) { return row.fi < 0; }))
        text += "Dashed arrows run along the border.";
    return text;
}

void add_figure(Html& page, const course::MeshPicture& mesh,
                const Html& drawing, const course::Walk& walk) {
    if (drawing.text.empty()) return;
    append(page, "<figure>{}<figcaption>{}</figcaption></figure>\n", drawing,
           caption(mesh, walk));
}

void add_failure(Html& page, const Failure& failure) {
    const course::Walk walk = course::walk_of(failure);
    const Html drawing = mesh_drawing(failure.mesh, walk);
    append(page,
           R"(<div class="failure">
<dl>
{}{}{}{}{}{}{}</dl>
)",
           entry("call", "mono", failure.call),
           entry("expected", "mono", failure.expected),
           entry("got", "mono got", failure.got),
           entry("on mesh", "", mesh_entry(failure.mesh, drawing)),
           entry("walk", "mono", walk_text(walk)),
           entry("from lines", "mono", lines_of(failure)),
           entry("note", "", failure.note));
    add_figure(page, failure.mesh, drawing, walk);
    append(page, "</div>\n");
}

// ---- one case

Html printed_block(const std::string& printed) {
    if (printed.empty()) return {};
    return markup(R"(<p class="soft small">It printed:</p><pre>{}</pre>)"
                  "\n",
                  course::shortened(printed, 2000, 30));
}

void add_detail(Html& page, const CaseResult& result) {
    if (result.hint.empty() && result.failures.empty() &&
        result.printed.empty())
        return;
    append(page, "<div class=\"detail\">\n");
    if (!result.hint.empty())
        append(page,
               R"(<p class="hint"><b>Hint:</b> {}</p>)"
               "\n",
               course::shortened(result.hint, 1200, 16));
    for (const Failure& failure : result.failures) add_failure(page, failure);
    append(page, "{}</div>\n", printed_block(result.printed));
}

void add_case(Html& page, const CaseResult& result) {
    const bool passed = result.verdict == Verdict::accepted;
    const bool hidden = result.info.visibility == course::Visibility::hidden;
    append(page,
           R"(<li>{}<div>{}{}{}</div><div class="n">{} of {}</div>)"
           "\n",
           badge(result.verdict), result.info.name,
           passed ? Html()
                  : markup(R"( <span class="soft">– {}</span>)",
                           words(result.verdict)),
           hidden ? markup(R"( <span class="soft small">(hidden)</span>)")
                  : Html(),
           course::points_text(earned(result)),
           course::points_text(result.info.points));
    if (!passed) add_detail(page, result);
    append(page, "</li>\n");
}

// ---- one exercise

bool is_missing(const std::optional<ExerciseResult>& result) {
    return result && result->verdict == Verdict::not_submitted;
}

Html message_block(const ExerciseResult& result) {
    if (result.message.empty()) return {};
    return markup("{}<pre>{}</pre>\n",
                  result.verdict < Verdict::compile_error
                      ? markup("<p>The compiler warns:</p>\n")
                      : Html(),
                  course::shortened(result.message, 8000, 100));
}

void add_cases(Html& page, const ExerciseResult& result) {
    if (result.cases.empty() || !has_run(result)) return;
    append(page, "<ul class=\"cases\">\n");
    for (const CaseResult& one : result.cases) add_case(page, one);
    append(page, "</ul>\n");
}

Html mistake_block(const std::string& sentence) {
    if (sentence.empty()) return {};
    return markup(R"(<p class="hint">{}</p>)"
                  "\n",
                  course::shortened(sentence, 1200, 16));
}

Html points_of(const GradedAssignment& graded, const StudentResults& student,
               std::size_t k) {
    const auto score = score_of(student, k);
    const auto value = points(score);
    return markup(
        "{} of {}{}", value ? course::points_text(*value) : "–",
        course::points_text(max_points(graded, k)),
        score && score->by_hand
            ? markup(R"( <span class="soft small">set by hand</span>)")
            : Html());
}

void add_exercise(Html& page, const GradedAssignment& graded,
                  const StudentResults& student, std::size_t k) {
    const GradedExercise& exercise = graded.exercises[k];
    const auto& result = student.exercises[k];
    append(page,
           R"(<section class="exercise" id="{}">
<header>{}<h3>{}</h3><span class="points">{}</span></header>
)",
           short_name(exercise.exercise),
           result ? badge(result->verdict) : badge_not_judged(),
           short_name(exercise.exercise), points_of(graded, student, k));
    if (!result) return append(page, "<p>Not judged yet.</p>\n</section>\n");
    const ExerciseResult shown = for_student(*result, hidden_feedback(graded));
    append(page, "<p>{}</p>\n{}{}", explanation(shown.verdict),
           message_block(shown),
           mistake_block(mistake_for_student(graded, student, k)));
    add_cases(page, shown);
    append(page, "</section>\n");
}

// ---- the head of the page

/// What became of it; of a file that is missing, its name.
Html verdict_of(const GradedExercise& exercise,
                const std::optional<ExerciseResult>& result) {
    if (!result) return markup("{} not judged yet", badge_not_judged());
    Html verdict =
        markup("{} {}", badge(result->verdict), words(result->verdict));
    if (!is_missing(result)) return verdict;
    return markup(R"({}<span class="soft no-file">: no file {}</span>)",
                  verdict, exercise.suite.file);
}

/// The exercise's name; it leads to the section below, where there is one.
Html name_of(const GradedExercise& exercise,
             const std::optional<ExerciseResult>& result) {
    const std::string_view name = short_name(exercise.exercise);
    if (is_missing(result)) return markup("{}", name);
    return markup(R"(<a href="#{}">{}</a>)", name, name);
}

Html overview_row(const GradedAssignment& graded, const StudentResults& student,
                  std::size_t k) {
    const GradedExercise& exercise = graded.exercises[k];
    const auto& result = student.exercises[k];
    const double max = max_points(graded, k);
    return markup(
        R"(<tr><td>{}</td><td>{}</td><td class="of-bar">{}</td>)"
        R"(<td class="n">{}{}</td></tr>)"
        "\n",
        name_of(exercise, result), verdict_of(exercise, result),
        bar(max > 0 ? points(score_of(student, k)).value_or(0) / max : 0),
        points_of(graded, student, k),
        is_weighted(graded)
            ? markup(" × {}", course::points_text(exercise.weight))
            : Html());
}

Html overview(const GradedAssignment& graded, const StudentResults& student) {
    Html rows;
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        rows += overview_row(graded, student, k);
    return markup(R"(<table class="overview">
<thead><tr><th>exercise</th><th>verdict</th><th class="of-bar"></th>)"
                  R"(<th class="n">points</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  rows);
}

/// When it came, and what that costs; nothing where neither is known.
Html handed_in(const GradedAssignment& graded, const StudentResults& student,
               double cost) {
    const std::string when = submitted_text(graded, student.student);
    const std::string late = late_text(scores_of(student));
    if (when.empty() && late.empty()) return {};
    return markup(
        R"(<div><dt>handed in</dt><dd class="words">{}{}{}</dd></div>)"
        "\n",
        when, when.empty() || late.empty() ? "" : ": ",
        late.empty() || cost <= 0 ? late
                                  : fmt::format("{} ({} points less)", late,
                                                course::points_text(cost)));
}

Html headline(const GradedAssignment& graded, const StudentResults& student) {
    const Scores scores = scores_of(student);
    const Total sum = total(graded, scores);
    const Html grade = sum.total
                           ? markup("{} <small>of {} points, {} %</small>",
                                    course::points_text(*sum.total),
                                    course::points_text(sum.max),
                                    course::percent_text(*sum.total, sum.max))
                           : markup("<small>no grade yet</small>");
    return markup(
        R"(<dl class="numbers">
<div><dt>total{}</dt><dd>{}</dd></div>
<div><dt>status</dt><dd class="words">{}</dd></div>
{}</dl>
)",
        is_weighted(graded) ? " (weighted)" : "", grade, words(status(scores)),
        handed_in(graded, student, sum.late_cost));
}

Html files_section(const StudentResults& student) {
    if (student.student.notes.empty()) return {};
    Html list;
    for (const std::string& note : student.student.notes)
        list += markup("<li>{}</li>\n", course::shortened(note, 2000, 10));
    return markup(R"(<div class="alert"><b>Files that were not taken</b>)"
                  "\n<ul>\n{}</ul></div>\n",
                  list);
}

}  // namespace

Html student_page(const GradedAssignment& graded,
                  const StudentResults& student) {
    const std::string& assignment = graded.assignment.name;
    const std::string& name = shown_name(student.student);
    Html page = begin_page(assignment + ": " + name);
    append(page,
           R"(<header><p class="over">{}, graded <time>{}</time></p>
<h1><bdi>{}</bdi></h1></header>
{}{}{})",
           assignment, course::time_text(graded.run.started_at), name,
           headline(graded, student), files_section(student),
           overview(graded, student));
    for (std::size_t k = 0; k < graded.exercises.size(); ++k)
        if (!is_missing(student.exercises[k]))
            add_exercise(page, graded, student, k);
    end_page(page);
    return page;
}

}  // namespace grader

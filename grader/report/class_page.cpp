#include "grader/report/class_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "course/report/text.h"
#include "grader/report/class_charts.h"
#include "grader/report/page.h"

namespace grader {

namespace {

using course::Verdict;

constexpr std::size_t most_columns = 22;  // of one class table
constexpr std::size_t most_cases = 15;

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

// ---- numbers over the class

/// Shares of the points, of all students that have a grade.
std::vector<double> shares(const ClassSummary& results) {
    std::vector<double> all;
    for (const Scores& student : results.students) {
        const Total sum = total(results, student);
        if (sum.total && sum.max > 0) all.push_back(*sum.total / sum.max);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::string mean_text(const std::vector<double>& all) {
    if (all.empty()) return "–";
    double sum = 0;
    for (const double share : all) sum += share;
    return course::percent_text(sum, static_cast<double>(all.size())) + " %";
}

std::string median_text(const std::vector<double>& sorted) {
    if (sorted.empty()) return "–";
    const std::size_t half = sorted.size() / 2;
    const double median = sorted.size() % 2 == 1
                              ? sorted[half]
                              : (sorted[half - 1] + sorted[half]) / 2;
    return course::percent_text(median, 1) + " %";
}

int students_with(const ClassSummary& results, Status wanted) {
    return static_cast<int>(std::count_if(
        results.students.begin(), results.students.end(),
        [&](const Scores& one) { return status(one) == wanted; }));
}

/// What became of one exercise over the class.
struct ExerciseCount {
    int judged = 0;
    int accepted = 0;
    int partly = 0;  ///< not accepted, with some points
    double points = 0;
};

ExerciseCount count(const ClassSummary& results, std::size_t k) {
    ExerciseCount sum;
    for (const Scores& student : results.students) {
        const auto& score = student[k];
        if (!was_judged(score)) continue;
        ++sum.judged;
        sum.points += score->points;
        if (score->verdict == Verdict::accepted)
            ++sum.accepted;
        else if (score->points > 0)
            ++sum.partly;
    }
    return sum;
}

double mean_share(const ExerciseCount& sum, double max) {
    return sum.judged > 0 && max > 0 ? sum.points / (sum.judged * max) : 0;
}

// ---- the head of the page

Html number(std::string_view what, const Html& value) {
    return markup("<div><dt>{}</dt><dd>{}</dd></div>\n", what, value);
}

Html numbers(const ClassSummary& results) {
    const std::vector<double> all = shares(results);
    const int students = static_cast<int>(results.students.size());
    const int empty = students_with(results, Status::nothing_submitted);
    return markup(
        R"(<dl class="numbers">)"
        "\n{}{}{}{}{}</dl>\n",
        number("students", markup("{}", students)),
        number("handed in something",
               markup("{} <small>of {}</small>", students - empty, students)),
        number("handed in everything",
               markup("{} <small>of {}</small>",
                      students_with(results, Status::complete), students)),
        number("mean of the class", markup("{}", mean_text(all))),
        number("median", markup("{}", median_text(all))));
}

Html one_fault(const ClassSummary& results, const Fault& fault) {
    return markup("<li><b><bdi>{}</bdi></b>, {}: {}</li>\n",
                  shown_name(results.run.students[fault.student]),
                  short_name(results.exercises[fault.exercise].exercise),
                  fault.message);
}

Html faults(const ClassSummary& results) {
    const std::size_t count = results.faults.size();
    if (count == 0) return {};
    Html list;
    for (const Fault& fault : results.faults) list += one_fault(results, fault);
    return markup(
        R"(<div class="alert"><b>{} ended in a fault of the grader.</b> )"
        "No grade was given for the students concerned; the next run tries "
        "these exercises again.\n<ul>\n{}</ul></div>\n",
        count == 1 ? "One exercise" : fmt::format("{} exercises", count), list);
}

// ---- the class table

/// The exercises of one table, from first to last.
struct Columns {
    std::size_t first, last;
};

/// As few tables as can be printed, cut between chapters where possible.
std::vector<Columns> tables(const ClassSummary& results) {
    const auto& all = results.exercises;
    std::vector<Columns> tables;
    std::size_t first = 0;
    while (first < all.size()) {
        std::size_t last = std::min(first + most_columns, all.size());
        std::size_t cut = last;
        while (cut > first && cut < all.size() &&
               chapter(all[cut].exercise) == chapter(all[cut - 1].exercise))
            --cut;
        if (cut > first) last = cut;
        tables.push_back({first, last});
        first = last;
    }
    return tables;
}

bool begins_chapter(const ClassSummary& results, Columns columns,
                    std::size_t k) {
    return k == columns.first || chapter(results.exercises[k].exercise) !=
                                     chapter(results.exercises[k - 1].exercise);
}

Html chapter_row(const ClassSummary& results, Columns columns) {
    Html row;
    for (std::size_t k = columns.first; k < columns.last;) {
        std::size_t end = k + 1;
        while (end < columns.last && !begins_chapter(results, columns, end))
            ++end;
        row += markup(R"(<th class="group first" colspan="{}">{}</th>)",
                      end - k, chapter(results.exercises[k].exercise));
        k = end;
    }
    return markup(
        R"(<tr><th class="group"></th>{}<th class="group first"></th>)"
        R"(<th class="group"></th></tr>)"
        "\n",
        row);
}

Html head_row(const ClassSummary& results, Columns columns) {
    Html row;
    for (std::size_t k = columns.first; k < columns.last; ++k)
        row += markup(R"(<th class="up {}"><span>{}</span></th>)",
                      begins_chapter(results, columns, k) ? "first" : "",
                      short_name(results.exercises[k].exercise));
    return markup(R"(<tr><th>student</th>{}<th class="n first">total</th>)"
                  R"(<th class="n">%</th></tr>)"
                  "\n",
                  row);
}

Html cell(const std::optional<Score>& score) {
    if (!score) return badge_not_judged();
    if (!shows_points(score)) return badge(score->verdict);
    return markup("{}<small>{}</small>", badge(score->verdict),
                  points_mark(*score));
}

Html total_cells(const ClassSummary& results, const Scores& student) {
    const Total sum = total(results, student);
    const std::string late = late_text(student);
    const Html below =
        late.empty() ? Html() : markup("<br><small>{}</small>", late);
    if (!sum.total)
        return markup(R"(<td class="n first" colspan="2">{}{}</td>)",
                      words(status(student)), below);
    return markup(
        R"(<td class="n first"><b>{}</b>{}</td><td class="n">{}</td>)",
        course::points_text(*sum.total), below,
        course::percent_text(*sum.total, sum.max));
}

void add_student(Html& page, const ClassSummary& results, std::size_t number,
                 const std::string& name, Columns columns) {
    const Student& student = results.run.students[number];
    const Scores& scores = results.students[number];
    append(page,
           R"(<tr><td class="who"><a href="students/{}/feedback.html">)"
           R"(<bdi>{}</bdi></a></td>)",
           student.id, name);
    for (std::size_t k = columns.first; k < columns.last; ++k)
        append(page, R"(<td class="score {}">{}</td>)",
               begins_chapter(results, columns, k) ? "first" : "",
               cell(scores[k]));
    append(page, "{}</tr>\n", total_cells(results, scores));
}

Html mean_row(const ClassSummary& results, Columns columns) {
    Html row = markup(R"(<tr class="mean"><td>out of</td>)");
    for (std::size_t k = columns.first; k < columns.last; ++k)
        row += markup(R"(<td class="score {}">{}</td>)",
                      begins_chapter(results, columns, k) ? "first" : "",
                      course::points_text(max_points(results, k)));
    return markup(R"({}<td class="n first">{}</td><td class="n">100</td></tr>)"
                  "\n",
                  row, course::points_text(max_total(results)));
}

void add_table(Html& page, const ClassSummary& results, Columns columns) {
    append(page, R"(<table class="class">
<thead>
{}{}</thead>
<tbody>
)",
           chapter_row(results, columns), head_row(results, columns));
    for (std::size_t k = 0; k < results.students.size(); ++k)
        for (const Member& one : people_of(results.run.students[k]))
            add_student(page, results, k, one.name, columns);
    append(page, R"({}</tbody>
</table>
)",
           mean_row(results, columns));
}

void add_students(Html& page, const ClassSummary& results) {
    append(page,
           "<h2>Students</h2>\n"
           R"(<p class="soft">A name leads to the student's own page. )"
           "Under each verdict stand the points of the exercise{}{}</p>\n",
           is_weighted(results)
               ? "; totals multiply them by the weights listed at the end."
               : ".",
           results.by_hand.empty() ? "" : " A star: set by hand, see below.");
    if (results.students.empty())
        return append(page, "<p>No student's folder was found.</p>\n");
    for (const Columns columns : tables(results))
        add_table(page, results, columns);
    page += legend();
}

// ---- what was set by hand

Html by_hand_row(const ClassSummary& results, const SetPoints& set) {
    return markup(
        R"(<tr><td><bdi>{}</bdi></td><td>{}</td><td class="n">{} of {}</td>)"
        R"(<td class="n">{}</td><td>{}</td><td>{}, {}</td></tr>)"
        "\n",
        shown_name(results.run.students[set.student]),
        short_name(results.exercises[set.exercise].exercise),
        course::points_text(set.grade.points.value_or(0)),
        course::points_text(max_points(results, set.exercise)),
        course::points_text(set.found),
        course::shortened(set.grade.reason, 2000, 10), set.grade.user,
        course::time_text(set.grade.set_at));
}

Html by_hand_section(const ClassSummary& results) {
    if (results.by_hand.empty()) return {};
    Html rows;
    for (const SetPoints& set : results.by_hand)
        rows += by_hand_row(results, set);
    return markup(R"(<h2>Points set by hand</h2>
<table class="notes">
<thead><tr><th>student</th><th>exercise</th><th class="n">points</th>)"
                  R"(<th class="n">the grader found</th><th>reason</th>)"
                  R"(<th>who, and when</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  rows);
}

// ---- the charts

Html charts(const ClassSummary& results) {
    const std::vector<double> all = shares(results);
    if (all.empty()) return {};
    return markup("<div class=\"charts\">\n{}{}</div>\n",
                  distribution_chart(all), timeline_chart(results.attempts));
}

Html exercise_row(const ClassSummary& results, std::size_t k) {
    const ExerciseCount sum = count(results, k);
    const int students = static_cast<int>(results.students.size());
    const int failed = sum.judged - sum.accepted - sum.partly;
    return markup(
        R"(<tr><td>{}</td><td class="wide-bar">{}</td><td class="n">{}</td>)"
        R"(<td class="n">{}</td><td class="n">{}</td></tr>)"
        "\n",
        short_name(results.exercises[k].exercise),
        outcome_bar(sum.accepted, sum.partly, failed, students), sum.judged,
        sum.accepted,
        sum.judged == 0 ? "–"
                        : percent(mean_share(sum, max_points(results, k))));
}

Html exercise_rows(const ClassSummary& results) {
    const Columns all = {0, results.exercises.size()};
    Html rows;
    for (std::size_t k = 0; k < all.last; ++k) {
        const std::string_view name = chapter(results.exercises[k].exercise);
        if (begins_chapter(results, all, k) && !name.empty())
            append(rows,
                   R"(<tr><th class="chapter" colspan="5">{}</th></tr>)"
                   "\n",
                   name);
        rows += exercise_row(results, k);
    }
    return rows;
}

Html chart_section(const ClassSummary& results) {
    return markup(
        R"(<h2>Exercises</h2>
<p class="soft">Of all students: <span class="key fill"></span> accepted, )"
        R"(<span class="key part"></span> some points, )"
        R"(<span class="key lost"></span> no points, )"
        R"(<span class="key"></span> not handed in. The mean share of the )"
        R"(points is of those who handed it in.</p>
<table class="exercises">
<thead><tr><th>exercise</th><th></th><th class="n">handed in</th>)"
        R"(<th class="n">accepted</th><th class="n">mean</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
        exercise_rows(results));
}

// ---- who is stuck

std::vector<Stuck> longest_stuck(const ClassSummary& results) {
    std::vector<Stuck> all = results.stuck;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.in_vain > b.in_vain;
    });
    return all;
}

Html stuck_row(const ClassSummary& results, const Stuck& one) {
    return markup(
        R"(<tr><td><bdi>{}</bdi></td><td>{}</td><td class="n">{}</td>)"
        R"(<td class="n">{}</td><td class="n">{} of {}</td>)"
        R"(<td class="when">{}</td></tr>)"
        "\n",
        shown_name(results.run.students[one.student]),
        short_name(results.exercises[one.exercise].exercise), one.attempts,
        one.in_vain, course::points_text(one.best),
        course::points_text(max_points(results, one.exercise)),
        course::time_text(one.since));
}

Html stuck_section(const ClassSummary& results) {
    if (results.stuck.empty()) return {};
    Html rows;
    for (const Stuck& one : longest_stuck(results))
        rows += stuck_row(results, one);
    return markup(R"(<h2>Who is stuck where</h2>
<p class="soft">Not accepted, and the last two attempts or more brought no )"
                  R"(more points.</p>
<table>
<thead><tr><th>student</th><th>exercise</th><th class="n">attempts</th>)"
                  R"(<th class="n">in vain</th><th class="n">best</th>)"
                  R"(<th>since</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  rows);
}

// ---- the cases that fail most

Html case_row(const CaseCount& one) {
    return markup(
        "<tr><td>{}</td><td>{}</td><td>{}</td>"
        R"(<td class="of-bar">{}</td><td class="n">{} of {}</td></tr>)"
        "\n",
        short_name(one.exercise), one.name,
        one.visibility == course::Visibility::shown ? "public" : "hidden",
        bar(static_cast<double>(one.failed) / one.judged), one.failed,
        one.judged);
}

Html cases_section(const ClassSummary& results) {
    const std::vector<CaseCount> all = most_failed(results);
    Html rows;
    for (std::size_t k = 0; k < std::min(all.size(), most_cases); ++k)
        rows += case_row(all[k]);
    if (all.empty())
        return markup(
            "<h2>Cases that fail most</h2>\n<p>No case failed.</p>\n");
    return markup(R"(<h2>Cases that fail most</h2>
<p class="soft">Out of the submissions that could be run.{}</p>
<table>
<thead><tr><th>exercise</th><th>case</th><th>suite</th><th class="of-bar"></th>)"
                  R"(<th class="n">failed</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  all.size() > most_cases
                      ? fmt::format(" {} more cases failed less often.",
                                    all.size() - most_cases)
                      : "",
                  rows);
}

/// Behind a click, and not on paper: there are hundreds.
Html all_cases_section(const ClassSummary& results) {
    if (results.cases.empty()) return {};
    Html rows;
    for (const auto& [place, one] : results.cases)
        rows += markup(
            "<tr><td>{}</td><td>{}</td>"
            R"(<td class="of-bar">{}</td><td class="n">{}</td></tr>)"
            "\n",
            short_name(one.exercise), one.name,
            bar(static_cast<double>(one.judged - one.failed) / one.judged),
            fmt::format("{} of {}", one.judged - one.failed, one.judged));
    return markup(R"(<details><summary>Every case: how many pass it</summary>
<table>
<thead><tr><th>exercise</th><th>case</th><th class="of-bar"></th><th class="n">passed</th>)"
                  R"(</tr></thead>
<tbody>
{}</tbody>
</table>
</details>
)",
                  rows);
}

// ---- mistakes that were recognised

using Recognised = std::pair<std::pair<std::size_t, std::string>, MistakeCount>;

/// The most frequent first.
std::vector<Recognised> most_made(const ClassSummary& results) {
    std::vector<Recognised> all(results.recognised.begin(),
                                results.recognised.end());
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.second.students.size() > b.second.students.size();
    });
    return all;
}

Html names_of(const ClassSummary& results,
              const std::vector<std::size_t>& students) {
    Html names;
    for (std::size_t k = 0; k < students.size(); ++k)
        names += markup("{}<bdi>{}</bdi>", k == 0 ? "" : ", ",
                        shown_name(results.run.students[students[k]]));
    return names;
}

Html mistakes_section(const ClassSummary& results) {
    if (results.recognised.empty()) return {};
    Html rows;
    for (const auto& [place, one] : most_made(results))
        rows += markup(
            R"(<tr><td>{}</td><td>{}</td><td class="n">{}</td><td>{}</td></tr>)"
            "\n",
            short_name(results.exercises[place.first].exercise), one.mistake,
            one.students.size(), names_of(results, one.students));
    return markup(R"(<h2>Mistakes that were recognised</h2>
<p class="soft">These submissions fail the same cases, in the same way, as a )"
                  R"(stored wrong submission.</p>
<table class="mistakes">
<thead><tr><th>exercise</th><th>mistake</th><th class="n">made by</th>)"
                  R"(<th>whom</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  rows);
}

// ---- files and facts

void add_notes(Html& page, const Html& whose,
               const std::vector<std::string>& notes) {
    for (std::size_t k = 0; k < notes.size(); ++k)
        append(page, "<tr><td>{}</td><td>{}</td></tr>\n",
               k == 0 ? whose : Html(), course::shortened(notes[k], 2000, 10));
}

bool has_notes(const Run& run) {
    return !run.notes.empty() ||
           std::any_of(run.students.begin(), run.students.end(),
                       [](const Student& one) { return !one.notes.empty(); });
}

void add_files(Html& page, const Run& run) {
    if (!has_notes(run)) return;
    append(page, R"(<h2>Files that were not taken</h2>
<table class="notes">
<thead><tr><th>whose</th><th>file, and why</th></tr></thead>
<tbody>
)");
    add_notes(page, {"the folder of the class"}, run.notes);
    for (const Student& one : run.students)
        add_notes(page, markup("<bdi>{}</bdi>", shown_name(one)), one.notes);
    append(page, "</tbody>\n</table>\n");
}

Html suite_rows(const ClassSummary& results) {
    Html rows;
    for (const GradedExercise& one : results.exercises)
        rows += markup(
            R"(<tr><td>{}</td><td class="mono">{}</td><td class="n">{}</td>)"
            R"(<td class="n">{}</td><td class="mono">{}</td></tr>)"
            "\n",
            short_name(one.exercise), one.suite.file,
            course::points_text(one.suite.max), weight_text(one),
            one.suite.version);
    return rows;
}

/// What submissions could use, in a row for all exercises or for some.
Html limit_rows(const Assignment& assignment) {
    Html rows;
    for (const SharedLimits& one : limits_of(assignment))
        rows += markup("<tr><th>{}</th><td>{}</td></tr>\n", one.title,
                       text_of(one.limits));
    return rows;
}

Html run_section(const ClassSummary& results) {
    const Run& run = results.run;
    return markup(R"(<h2>The run</h2>
<table>
<tbody>
<tr><th>sandbox</th><td>{}</td></tr>
<tr><th>seed</th><td>{}</td></tr>
<tr><th>grader</th><td>{}</td></tr>
{}</tbody>
</table>
<table>
<thead><tr><th>exercise</th><th>file</th><th class="n">points</th>)"
                  R"(<th class="n">weight</th><th>version of the suites</th>)"
                  R"(</tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  run.sandbox, run.seed, run.version,
                  limit_rows(results.assignment), suite_rows(results));
}

}  // namespace

std::vector<CaseCount> most_failed(const ClassSummary& results) {
    std::vector<CaseCount> failed;
    for (const auto& [place, sum] : results.cases)
        if (sum.failed > 0) failed.push_back(sum);
    std::stable_sort(failed.begin(), failed.end(),
                     [](const CaseCount& a, const CaseCount& b) {
                         return a.failed > b.failed;
                     });
    return failed;
}

Html class_page(const ClassSummary& results) {
    const std::string& name = results.assignment.name;
    Html page = begin_page(name);
    append(page,
           R"(<header><p class="over">Results of the class, run of )"
           R"(<time>{}</time></p>
<h1>{}</h1></header>
{}{}{})",
           course::time_text(results.run.started_at), name, faults(results),
           numbers(results), charts(results));
    add_students(page, results);
    append(page, "{}{}{}{}{}{}", chart_section(results), stuck_section(results),
           cases_section(results), all_cases_section(results),
           mistakes_section(results), by_hand_section(results));
    add_files(page, results.run);
    page += run_section(results);
    end_page(page);
    return page;
}

}  // namespace grader

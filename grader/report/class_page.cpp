#include "grader/report/class_page.h"

#include <algorithm>
#include <map>
#include <utility>

#include "course/report/explain.h"
#include "course/report/text.h"
#include "grader/report/page.h"

namespace grader {

namespace {

using course::Verdict;
using Result = std::optional<course::ExerciseResult>;

constexpr std::size_t most_columns = 22;  // of one class table
constexpr std::size_t most_cases = 15;

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

// ---- numbers over the class

/// Shares of the points, of all students that have a grade.
std::vector<double> shares(const ClassResults& results) {
    std::vector<double> all;
    for (const StudentResults& student : results.students) {
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

int students_with(const ClassResults& results, Status wanted) {
    return static_cast<int>(std::count_if(
        results.students.begin(), results.students.end(),
        [&](const StudentResults& one) { return status(one) == wanted; }));
}

/// What became of one exercise over the class.
struct ExerciseCount {
    int judged = 0;
    int accepted = 0;
    double points = 0;
};

ExerciseCount count(const ClassResults& results, std::size_t k) {
    ExerciseCount sum;
    for (const StudentResults& student : results.students) {
        const Result& result = student.exercises[k];
        if (!was_judged(result)) continue;
        ++sum.judged;
        sum.points += result->points();
        if (result->verdict == Verdict::accepted) ++sum.accepted;
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

Html numbers(const ClassResults& results) {
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

Html one_fault(const StudentResults& student, const std::string& exercise,
               const std::string& message) {
    return markup("<li><b><bdi>{}</bdi></b>, {}: {}</li>\n",
                  student.student.name, short_name(exercise),
                  course::shortened(message, 600, 6));
}

Html faults(const ClassResults& results) {
    Html list;
    int count = 0;
    for (const StudentResults& student : results.students)
        for (std::size_t k = 0; k < results.exercises.size(); ++k) {
            const Result& result = student.exercises[k];
            if (!result || result->verdict != Verdict::grader_fault) continue;
            ++count;
            list += one_fault(student, results.exercises[k].exercise,
                              result->message);
        }
    if (count == 0) return {};
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
std::vector<Columns> tables(const ClassResults& results) {
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

bool begins_chapter(const ClassResults& results, Columns columns,
                    std::size_t k) {
    return k == columns.first || chapter(results.exercises[k].exercise) !=
                                     chapter(results.exercises[k - 1].exercise);
}

Html chapter_row(const ClassResults& results, Columns columns) {
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

Html head_row(const ClassResults& results, Columns columns) {
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

Html score(const Result& result) {
    if (!result) return badge_not_judged();
    if (!was_judged(result)) return badge(result->verdict);
    return markup("{}<small>{}</small>", badge(result->verdict),
                  course::points_text(result->points()));
}

Html total_cells(const ClassResults& results, const StudentResults& student) {
    const Total sum = total(results, student);
    if (!sum.total)
        return markup(R"(<td class="n first" colspan="2">{}</td>)",
                      words(status(student)));
    return markup(R"(<td class="n first"><b>{}</b></td><td class="n">{}</td>)",
                  course::points_text(*sum.total),
                  course::percent_text(*sum.total, sum.max));
}

Html student_row(const ClassResults& results, const StudentResults& student,
                 Columns columns) {
    Html row =
        markup(R"(<tr><td class="who"><a href="students/{}/feedback.html">)"
               R"(<bdi>{}</bdi></a></td>)",
               student.student.id, student.student.name);
    for (std::size_t k = columns.first; k < columns.last; ++k)
        row += markup(R"(<td class="score {}">{}</td>)",
                      begins_chapter(results, columns, k) ? "first" : "",
                      score(student.exercises[k]));
    row += total_cells(results, student);
    return markup("{}</tr>\n", row);
}

Html mean_row(const ClassResults& results, Columns columns) {
    Html row = markup(R"(<tr class="mean"><td>out of</td>)");
    for (std::size_t k = columns.first; k < columns.last; ++k)
        row += markup(R"(<td class="score {}">{}</td>)",
                      begins_chapter(results, columns, k) ? "first" : "",
                      course::points_text(max_points(results, k)));
    return markup(R"({}<td class="n first">{}</td><td class="n">100</td></tr>)"
                  "\n",
                  row,
                  course::points_text(total(results, results.students[0]).max));
}

Html class_table(const ClassResults& results, Columns columns) {
    Html rows;
    for (const StudentResults& student : results.students)
        rows += student_row(results, student, columns);
    return markup(R"(<table class="class">
<thead>
{}{}</thead>
<tbody>
{}{}</tbody>
</table>
)",
                  chapter_row(results, columns), head_row(results, columns),
                  rows, mean_row(results, columns));
}

Html class_section(const ClassResults& results) {
    Html section = markup(
        "<h2>Students</h2>\n{}",
        markup(R"(<p class="soft">A name leads to the student's own page. )"
               "Under each verdict stand the points of the exercise{}</p>\n",
               is_weighted(results)
                   ? "; totals multiply them by the weights listed at the end."
                   : "."));
    if (results.students.empty())
        return markup("{}<p>No student's folder was found.</p>\n", section);
    for (const Columns columns : tables(results))
        section += class_table(results, columns);
    section += legend();
    return section;
}

// ---- the bar chart

constexpr int row_height = 26;
constexpr int bar_left = 210;
constexpr int bar_width = 480;

Html chart_row(const ClassResults& results, std::size_t k, int y) {
    const ExerciseCount sum = count(results, k);
    const double share = mean_share(sum, max_points(results, k));
    const std::string text =
        sum.judged == 0
            ? "nobody handed it in"
            : fmt::format("{}, {} of {} handed in, {} accepted", percent(share),
                          sum.judged, results.students.size(), sum.accepted);
    return markup(
        R"(<text x="0" y="{}">{}</text><rect class="track" x="{}" y="{}" )"
        R"(width="{}" height="15"/><rect class="fill" x="{}" y="{}" )"
        R"(width="{:.1f}" height="15"/><text class="value" x="{}" y="{}">)"
        "{}</text>\n",
        y + 12, short_name(results.exercises[k].exercise), bar_left, y,
        bar_width, bar_left, y, share * bar_width, bar_left + bar_width + 10,
        y + 12, text);
}

Html axis(int height) {
    Html ticks;
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const int x = bar_left + quarter * bar_width / 4;
        ticks += markup(R"(<line class="tick" x1="{}" x2="{}" y1="0" y2="{}"/>)"
                        R"(<text class="axis" x="{}" y="{}">{} %</text>)"
                        "\n",
                        x, x, height + 4, x, height + 18, 25 * quarter);
    }
    return ticks;
}

Html chart(const ClassResults& results) {
    Html rows;
    int y = 0;
    for (std::size_t k = 0; k < results.exercises.size(); ++k) {
        const Columns all = {0, results.exercises.size()};
        const std::string_view name = chapter(results.exercises[k].exercise);
        if (begins_chapter(results, all, k) && !name.empty()) {
            rows += markup(R"(<text class="chapter" x="0" y="{}">{}</text>)"
                           "\n",
                           y + 16, name);
            y += row_height;
        }
        rows += chart_row(results, k, y + 2);
        y += row_height;
    }
    return markup(
        R"(<svg class="chart" viewBox="0 0 960 {}" width="100%" role="img" )"
        R"(aria-label="Mean share of the points per exercise">)"
        "\n{}{}</svg>\n",
        y + 24, axis(y), rows);
}

Html chart_section(const ClassResults& results) {
    return markup(
        "<h2>Points per exercise</h2>\n"
        R"(<p class="soft">The mean share of an exercise's points, over those )"
        "who handed it in.</p>\n{}",
        chart(results));
}

// ---- the cases that fail most

Html case_row(const CaseCount& one) {
    return markup(
        "<tr><td>{}</td><td>{}</td><td>{}</td>"
        R"(<td style="width:150px">{}</td><td class="n">{} of {}</td></tr>)"
        "\n",
        short_name(one.exercise), one.name,
        one.visibility == course::Visibility::shown ? "public" : "hidden",
        bar(static_cast<double>(one.failed) / one.judged), one.failed,
        one.judged);
}

Html cases_section(const ClassResults& results) {
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
<thead><tr><th>exercise</th><th>case</th><th>suite</th><th></th>)"
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

// ---- files and facts

Html note_rows(const Html& whose, const std::vector<std::string>& notes) {
    Html rows;
    for (std::size_t k = 0; k < notes.size(); ++k)
        rows +=
            markup("<tr><td>{}</td><td>{}</td></tr>\n", k == 0 ? whose : Html(),
                   course::shortened(notes[k], 2000, 10));
    return rows;
}

Html files_section(const ClassResults& results) {
    Html rows = note_rows({"the folder of the class"}, results.run.notes);
    for (const StudentResults& one : results.students)
        rows += note_rows(markup("<bdi>{}</bdi>", one.student.name),
                          one.student.notes);
    if (rows.text.empty()) return {};
    return markup(R"(<h2>Files that were not taken</h2>
<table class="notes">
<thead><tr><th>whose</th><th>file, and why</th></tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  rows);
}

Html suite_rows(const ClassResults& results) {
    Html rows;
    for (const GradedExercise& one : results.exercises)
        rows += markup(
            R"(<tr><td>{}</td><td class="mono">{}</td><td class="n">{}</td>)"
            R"(<td class="n">{}</td><td class="mono">{}</td></tr>)"
            "\n",
            short_name(one.exercise), one.suite.file,
            course::points_text(one.suite.max), course::points_text(one.weight),
            one.suite.version);
    return rows;
}

Html run_section(const ClassResults& results) {
    const Run& run = results.run;
    return markup(R"(<h2>The run</h2>
<table>
<tbody>
<tr><th>sandbox</th><td>{}</td></tr>
<tr><th>seed</th><td>{}</td></tr>
<tr><th>jobs</th><td>{}</td></tr>
<tr><th>grader</th><td>{}</td></tr>
</tbody>
</table>
<table>
<thead><tr><th>exercise</th><th>file</th><th class="n">points</th>)"
                  R"(<th class="n">weight</th><th>version of the suites</th>)"
                  R"(</tr></thead>
<tbody>
{}</tbody>
</table>
)",
                  run.sandbox, run.seed, run.jobs, run.version,
                  suite_rows(results));
}

}  // namespace

std::vector<CaseCount> most_failed(const ClassResults& results) {
    std::map<std::pair<std::size_t, std::string>, CaseCount> cases;
    for (const StudentResults& student : results.students)
        for (std::size_t k = 0; k < results.exercises.size(); ++k) {
            const Result& result = student.exercises[k];
            if (!result || !has_run(*result)) continue;
            for (const course::CaseResult& one : result->cases) {
                CaseCount& sum = cases[{k, one.info.name}];
                sum.exercise = results.exercises[k].exercise;
                sum.name = one.info.name;
                sum.visibility = one.info.visibility;
                ++sum.judged;
                if (one.verdict != Verdict::accepted) ++sum.failed;
            }
        }
    std::vector<CaseCount> failed;
    for (const auto& [place, sum] : cases)
        if (sum.failed > 0) failed.push_back(sum);
    std::stable_sort(failed.begin(), failed.end(),
                     [](const CaseCount& a, const CaseCount& b) {
                         return a.failed > b.failed;
                     });
    return failed;
}

Html class_page(const ClassResults& results) {
    const std::string& name = results.assignment.name;
    return page(
        name, markup(R"(<header><p class="over">Results of the class, run of )"
                     R"(<time>{}</time></p>
<h1>{}</h1></header>
{}{}{}{}{}{}{})",
                     course::time_text(results.run.started_at), name,
                     faults(results), numbers(results), class_section(results),
                     chart_section(results), cases_section(results),
                     files_section(results), run_section(results)));
}

}  // namespace grader

// grader export --out OUT
#include <fmt/format.h>

#include "course/mesh/file_defects.h"
#include "grader/cli/class_session.h"
#include "grader/cli/past_results.h"
#include "grader/report/canvas_gradebook.h"
#include "grader/report/class_summary.h"
#include "grader/report/moodle_worksheet.h"
#include "grader/report/results_json.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    fs::path out, assignment, moodle, canvas, to, json;
    std::string column;
    MoodleOptions columns;
};

ClassSummary summary_of(const Gradebook& gradebook,
                        const Assignment& assignment) {
    ClassSummary all{graded_assignment(gradebook, assignment), {}, {}, {}};
    for (const Student& student : all.run.students)
        add(all, student_results(gradebook, all, student));
    return all;
}

/// A name beside the file that nothing has: "grades.csv.bak", ".bak2", ...
fs::path backup_of(const fs::path& file) {
    fs::path backup = file.string() + ".bak";
    for (int k = 2; fs::exists(backup); ++k)
        backup = fmt::format("{}.bak{}", file.string(), k);
    return backup;
}

void write(const fs::path& table, const fs::path& to, const std::string& text) {
    if (to.empty()) {
        const fs::path backup = backup_of(table);
        fs::copy_file(table, backup);
        fmt::print("{} as it was is in {}.\n", table.string(), backup.string());
    }
    course::replace_text(to.empty() ? table : to, text);
}

/// Says what was done; whether all was.
bool print_export(const fs::path& table, const FilledTable& filled) {
    for (const std::string& note : filled.notes)
        fmt::print("{}: {}\n", table.string(), note);
    for (const std::string& left : filled.left) fmt::print("  {}\n", left);
    fmt::print("{} with a grade, {} to look at.\n",
               course::counted(static_cast<std::size_t>(filled.filled), "row"),
               filled.left.size());
    return filled.left.empty();
}

template <class Fill>
bool fill(const fs::path& table, const fs::path& to, const Fill& fill_in) {
    if (!fs::is_regular_file(table))
        throw CannotBegin(fmt::format("{} is no file", table.string()));
    try {
        const std::string text = course::read_file(table);
        const FilledTable filled = fill_in(text);
        if (filled.text != text || !to.empty()) write(table, to, filled.text);
        return print_export(table, filled);
    } catch (const CsvError& error) {
        throw CannotBegin(fmt::format("{}: {}", table.string(), error.what()));
    }
}

int export_command(const ExportOptions& options) {
    if (options.moodle.empty() && options.canvas.empty() &&
        options.json.empty())
        throw CannotBegin("--moodle, --canvas or --json: export to what?");
    if (!options.to.empty() && options.moodle.empty() == options.canvas.empty())
        throw CannotBegin("--to is for one table: --moodle or --canvas");
    const Gradebook gradebook = gradebook_in(options.out);
    const auto chosen = assignment_in(options.assignment);
    const Assignment assignment =
        chosen ? *chosen : unweighted_assignment(gradebook);
    if (!options.json.empty())
        course::replace_text(options.json, results_json(gradebook, assignment));
    const ClassSummary results = summary_of(gradebook, assignment);
    bool is_whole = true;
    if (!options.moodle.empty())
        is_whole &= fill(options.moodle, options.to, [&](const auto& text) {
            return filled_worksheet(text, grades_for(results, Platform::moodle),
                                    options.columns);
        });
    if (!options.canvas.empty())
        is_whole &= fill(options.canvas, options.to, [&](const auto& text) {
            return filled_gradebook(text, grades_for(results, Platform::canvas),
                                    options.column.empty()
                                        ? results.assignment.name
                                        : options.column);
        });
    return is_whole ? 0 : 1;
}

/// How the columns of Moodle's table are called, and whether all are filled.
void add_columns(CLI::App& command, MoodleOptions& columns,
                 CLI::Option* moodle) {
    command
        .add_option("--grade-column", columns.grade_column,
                    "Moodle: header of the grades")
        ->needs(moodle);
    command
        .add_option("--feedback-column", columns.feedback_column,
                    "Moodle: header of the feedback")
        ->needs(moodle);
    command
        .add_flag("!--no-feedback", columns.with_feedback,
                  "Moodle: leave the feedback as it is")
        ->needs(moodle);
}

void add_tables(CLI::App& command, ExportOptions& options) {
    CLI::Option* moodle = command.add_option(
        "--moodle", options.moodle,
        "Moodle's grading worksheet: its grades and feedback are filled in");
    CLI::Option* canvas =
        command.add_option("--canvas", options.canvas,
                           "Canvas's gradebook: one column is filled in");
    command.add_option("--to", options.to,
                       "the filled table (default: in its place, with a "
                       "backup beside it)");
    command
        .add_option("--column", options.column,
                    "Canvas: name or number of the column (default: the "
                    "assignment's name)")
        ->needs(canvas);
    add_columns(command, options.columns, moodle);
}

}  // namespace

void add_export(CLI::App& program, int& code) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand(
        "export", "Write the grades into the tables of other systems");
    command->add_option("--out", options->out, "the folder of a run")
        ->required();
    command->add_option("--assignment", options->assignment,
                        "as for run: weights, bonus, rounding (default: each "
                        "exercise with weight 1)");
    add_tables(*command, *options);
    command->add_option("--json", options->json,
                        "all results for other programs, in a new file "
                        "(grader/report/results_json.h says what is in it)");
    command->footer(
        "Exit code: 0 every student has a row with a grade, and every row a "
        "student; 1 what\nis said has to be looked at, all else is done; 2 "
        "wrong usage, or no such table.");
    command->callback([options, &code] { code = export_command(*options); });
}

}  // namespace grader

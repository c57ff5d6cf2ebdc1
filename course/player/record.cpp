#include "course/player/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <sstream>

#include "course/player/run_recorder.h"
#include "course/player/walk_steps.h"
#include "course/runner/compile.h"
#include "course/runner/judge_submission.h"
#include "course/runner/make_ready.h"
#include "course/runner/process.h"
#include "course/runner/statement.h"
#include "course/runner/temporary_folder.h"

namespace course {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_steps = 400;            // of a walk
constexpr std::size_t most_steps_together = 2400;  // of a recording
constexpr std::size_t least_steps = 40;            // of a walk that is cut;
                                                   // less where steps are large
constexpr std::size_t most_bytes = 100'000;        // in the page, without a
                                                   // large mesh; the rest of it
                                                   // has nearly as many

/// One file, compiled, and what it is called.
struct Submission {
    std::string label;
    fs::path file;
    std::string text;
    fs::path shared;
};

// ---- compile

Finished run_step(std::vector<std::string> arguments) {
    Command command;
    command.arguments = std::move(arguments);
    command.environment = plain_environment();
    return run(std::move(command), compiler_patience, most_compiler_output);
}

void require_done(const Finished& step) {
    const Compiled compiled = compiled_from(step, compiler_patience);
    if (compiled.verdict != Verdict::accepted)
        throw DoesNotCompile(compiled.messages);
}

void compile(const Exercise& exercise, const Submission& submission,
             const std::string& compiler) {
    const std::string object = submission.shared.string() + ".o";
    std::vector<std::string> objects = {object};
    require_done(run_step(traced_compile_arguments(submission.file, object,
                                                   Tracing::shown, compiler)));
    for (const fs::path& before : own_sources_before(exercise)) {
        objects.push_back(fmt::format("{}.{}.o", submission.shared.string(),
                                      before.stem().string()));
        require_done(run_step(traced_compile_arguments(
            before, objects.back(), Tracing::silent, compiler)));
    }
    objects.push_back(walk_entry_object(exercise));
    require_done(run_step(link_arguments(objects, submission.shared)));
}

// ---- the recording

std::vector<Row> rows_of(const HalfEdgeTable& he) {
    std::vector<Row> rows;
    for (const HalfEdge& h : he.rows())
        rows.push_back({h.vi, h.fi, h.next, h.opp});
    return rows;
}

bool is_preamble(const std::string& line) {
    const auto first = line.find_first_not_of(" \t\r");
    return first == std::string::npos || line[first] == '#' ||
           line.compare(first, 2, "//") == 0 ||
           line.compare(first, 2, "/*") == 0 ||
           line.compare(first, 1, "*") == 0;
}

/// The source as it is shown: from its first line of code.
RecordedSource shown_source(const Submission& submission) {
    RecordedSource source;
    source.label = submission.label;
    source.file = submission.file.filename();
    std::istringstream text(submission.text);
    for (std::string line; std::getline(text, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        source.lines.push_back(line);
    }
    const auto first =
        std::find_if_not(source.lines.begin(), source.lines.end(), is_preamble);
    source.first = static_cast<int>(first - source.lines.begin()) + 1;
    source.lines.erase(source.lines.begin(), first);
    return source;
}

std::vector<Submission> submissions_of(const Exercise& exercise,
                                       const RecordOptions& options,
                                       const TemporaryFolder& folder) {
    std::vector<Submission> all;
    const auto add = [&](const std::string& label, const fs::path& file) {
        all.push_back({label, fs::absolute(file), read_file(file),
                       folder / fmt::format("submission{}.so", all.size())});
    };
    if (has_solutions()) add("reference", exercise.solution());
    if (!options.file.empty()) add("your file", options.file);
    return all;
}

class Session {
public:
    Session(const Exercise& exercise, const RecordOptions& options)
        : exercise_(exercise),
          options_(options),
          submissions_(submissions_of(exercise, options, folder_)) {}

    Recording record();

private:
    void compile_all() const;
    void choose_mesh();
    bool returns_somewhere() const;
    [[noreturn]] void cannot_begin(const std::string& complaint) const;
    Recorded run(const Submission& submission, Watched watched) const;
    Recorded run_with_locals(const Submission& submission,
                             Recording& recording) const;
    void add_walks(std::size_t source, Recording& recording) const;

    const Exercise& exercise_;
    const RecordOptions& options_;
    TemporaryFolder folder_;
    std::vector<Submission> submissions_;
    Fixture fixture_;
};

void Session::compile_all() const {
    std::vector<std::future<void>> running;
    for (const Submission& submission : submissions_)
        running.push_back(std::async(std::launch::async, [&] {
            compile(exercise_, submission, options_.compiler);
        }));
    for (auto& one : running) one.get();
}

/// The recorder could not load the file, or not choose the arguments.
void Session::cannot_begin(const std::string& complaint) const {
    if (complaint.find("undefined symbol") != std::string::npos)
        throw DoesNotCompile(load_error_text(exercise_, complaint));
    throw CannotShow(fmt::format("{}: {}", exercise_.name, complaint));
}

Recorded Session::run(const Submission& submission, Watched watched) const {
    RecordOrder order;
    order.mesh = fixture_.mesh;
    order.rows = fixture_.he.rows();
    order.starts = options_.starts;
    order.most = most_steps + 1;  // the first one is none
    Recorded recorded =
        run_recorder({folder_.path(), submission.shared, submission.file},
                     std::move(order), watched);
    if (recorded.starts.empty() && watched == Watched::table)
        cannot_begin(recorded.complaint);
    return recorded;
}

/// Whether a walk of the first source comes to an end on the mesh.
bool Session::returns_somewhere() const {
    const Recorded recorded = run(submissions_.front(), Watched::table);
    return std::any_of(
        recorded.calls.begin(), recorded.calls.end(),
        [&](const RecordedBytes& call) {
            return call.error.empty() &&
                   !decode_call(call.bytes, {}, "", "", {}, 0).result.empty();
        });
}

/// Some functions can do nothing on the slide's mesh: they want a closed one,
/// or triangles.
void Session::choose_mesh() {
    if (options_.mesh) {
        fixture_ = *options_.mesh;
        return;
    }
    for (Fixture& fixture : zoo::with_table()) {
        fixture_ = std::move(fixture);
        if (returns_somewhere()) return;
    }
    fixture_ = zoo::slide();
}

Recorded Session::run_with_locals(const Submission& submission,
                                  Recording& recording) const {
    if (!options_.locals) return run(submission, Watched::table);
    try {
        Recorded recorded = run(submission, Watched::table_and_locals);
        if (!recorded.lines.empty()) return recorded;
    } catch (const SystemError&) {
        // Without gdb the rest is the same.
    }
    recording.notes = {
        "local variables are not recorded: that needs gdb with Python, and "
        "the right to watch a program"};
    return run(submission, Watched::table);
}

void Session::add_walks(std::size_t source, Recording& recording) const {
    const Submission& submission = submissions_[source];
    const Recorded recorded = run_with_locals(submission, recording);
    recording.start_kind = recorded.start_kind;
    for (std::size_t k = 0; k < recorded.calls.size(); ++k) {
        const RecordedBytes& call = recorded.calls[k];
        RecordedWalk walk;
        if (call.error.empty())
            walk = decode_call(
                call.bytes, recording.table, submission.text, exercise_.name,
                k < recorded.lines.size() ? recorded.lines[k]
                                          : std::vector<LineReached>(),
                most_steps);
        walk.error += call.error;
        walk.source = source;
        if (recorded.starts[k] >= 0) walk.start = recorded.starts[k];
        recording.walks.push_back(std::move(walk));
    }
}

Recording Session::record() {
    compile_all();
    choose_mesh();
    Recording recording;
    recording.exercise = exercise_.name;
    recording.topic = exercise_.topic;
    recording.title = statement_of(exercise_).title;
    recording.mesh_name = fixture_.name;
    recording.mesh = fixture_.mesh;
    recording.table = rows_of(fixture_.he);
    for (std::size_t k = 0; k < submissions_.size(); ++k) {
        recording.sources.push_back(shown_source(submissions_[k]));
        add_walks(k, recording);
    }
    return recording;
}

/// What the reference, source 0, does with the same start is what is expected
/// of the other one.
void add_expectations(Recording& recording) {
    if (recording.sources.size() < 2) return;
    const std::size_t half = recording.walks.size() / 2;
    for (std::size_t k = 0; k < half; ++k) {
        RecordedWalk& walk = recording.walks[half + k];
        walk.expected = recording.walks[k].result;
        walk.expected_error = recording.walks[k].error;
        if (walk.call.empty()) walk.call = recording.walks[k].call;
    }
}

}  // namespace

bool can_be_shown(const Exercise& exercise) {
    std::istringstream contract(read_file(exercise.contract()));
    for (std::string line; std::getline(contract, line);) {
        const std::string code = line.substr(0, line.find_first_of("/#"));
        if (code.find("HalfEdgeTable") != std::string::npos) return true;
    }
    return false;
}

std::string what_can_be_shown() {
    std::string text, topic;
    for (const Exercise& exercise : all_exercises()) {
        if (!can_be_shown(exercise)) continue;
        if (exercise.topic != topic)
            text += fmt::format("\n  {}: ", topic = exercise.topic);
        else
            text += ", ";
        text += exercise.name;
    }
    return text;
}

void require_can_be_shown(const Exercise& exercise) {
    if (!can_be_shown(exercise))
        throw CannotShow(fmt::format(
            "{} works without a half-edge table; what can be shown is{}",
            exercise.name, what_can_be_shown()));
}

void make_ready_to_record(const std::vector<Exercise>& exercises) {
    std::vector<std::string> targets = {"demo_ready"};
    for (const Exercise& exercise : exercises)
        targets.push_back(exercise.name + "_walk_file");
    make_targets(targets);
}

Recording record(const Exercise& exercise, const RecordOptions& options) {
    require_can_be_shown(exercise);
    Recording recording = Session(exercise, options).record();
    add_expectations(recording);
    // A page of all starts is to be sent by mail, and opened on a telephone.
    std::size_t most = most_steps_together, least = least_steps;
    do {
        shorten(recording, most, least);
        most = most / 4 * 3;
        least = least / 4 * 3;
    } while (least > 1 && page_json(recording).size() > most_bytes);
    return recording;
}

}  // namespace course

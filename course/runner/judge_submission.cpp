#include "course/runner/judge_submission.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <fstream>
#include <optional>

#include "course/runner/compile.h"
#include "course/runner/limits.h"
#include "course/runner/temporary_folder.h"

namespace course {

namespace {

namespace fs = std::filesystem;

Finished run_step(std::vector<std::string> arguments) {
    Command command;
    command.arguments = std::move(arguments);
    command.environment = plain_environment();
    return run(std::move(command), compiler_patience, most_compiler_output);
}

/// Judge and sandbox are started first: both take as long to be ready as half
/// of the compiler, and wait for it.
ExerciseResult judge_function(Workplace& workplace, JudgeRun run,
                              const fs::path& source,
                              const TemporaryFolder& folder) {
    const fs::path shared = folder / "submission.so";
    DescriptorPair control = socket_pair();
    const Descriptor complaints = anonymous_file();
    Process launcher = workplace.launch(shared, run.exercise.limits,
                                        control.second, complaints);
    control.second.reset();
    run.control = std::move(control.first);
    run.processor = workplace.processor();
    RunningJudge judge(run);
    run.control.reset();
    const Compiled compiled = workplace.compile(run.exercise, source, shared);
    if (compiled.verdict != Verdict::accepted) {
        ExerciseResult result = judge.instead(compiled.verdict);
        result.message = compiled.messages;
        return result;
    }
    ExerciseResult result = judge.result();
    launcher.end_within(std::chrono::seconds(2));
    if (result.verdict == Verdict::grader_fault)
        result.message += "\n" + last_bytes(complaints.get());
    if (result.message.empty()) result.message = compiled.messages;
    return result;
}

/// A file that no student wrote by hand is not even opened.
std::optional<ExerciseResult> too_large(const JudgeRun& run,
                                        std::uintmax_t size) {
    const auto most =
        static_cast<std::uintmax_t>(run.exercise.limits.source_kib) << 10;
    if (size <= most) return std::nullopt;
    ExerciseResult result =
        every_case(run.exercise, run.kind, Verdict::compile_error);
    result.message =
        fmt::format("the file has {} bytes; at most {} are taken", size, most);
    return result;
}

ExerciseResult judge(Workplace& workplace, JudgeRun run, const fs::path& file,
                     const TemporaryFolder& folder) {
    if (!run.exercise.is_data)
        return judge_function(workplace, std::move(run), file, folder);
    run.submitted = fs::absolute(file);
    return RunningJudge(run).result();
}

/// Runs `work`; what goes wrong in it is our fault.
template <class Work>
ExerciseResult or_fault(Work work) {
    try {
        return work();
    } catch (const std::exception& error) {
        ExerciseResult fault;
        fault.message = error.what();
        return fault;
    }
}

JudgeRun run_of(const Exercise& exercise, JudgeKind kind,
                const std::vector<std::uint64_t>& seeds) {
    JudgeRun run;
    run.exercise = exercise;
    run.kind = kind;
    run.seeds = seeds;
    return run;
}

void write_file(const fs::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    out.close();
    if (!out) throw SystemError("cannot write " + file.string());
}

/// The compiler's driver says only that one of its programs was killed.
bool is_at_its_limits(const std::string& output) {
    for (const char* words :
         {"signal terminated program", "out of memory allocating",
          "virtual memory exhausted", "unable to execute command"})
        if (output.find(words) != std::string::npos) return true;
    return false;
}

}  // namespace

Compiled compiled_from(const Finished& finished,
                       std::chrono::milliseconds patience) {
    if (finished.timed_out)
        return {Verdict::compile_error,
                fmt::format("the compiler was stopped after {} s\n{}",
                            patience.count() / 1000, finished.output)};
    if (finished.status == 0)
        return {Verdict::accepted, for_students(finished.output)};
    const std::string why =
        is_at_its_limits(finished.output)
            ? "the compiler was stopped at its limits of time, memory or file "
              "size: what in the file makes it work without end?\n"
            : "";
    return {Verdict::compile_error, why + for_students(finished.output)};
}

namespace {

/// One file, with the least prelude that will do.
Finished compile_file(const fs::path& source, const std::string& object) {
    const auto compile_with = [&](Prelude prelude) {
        return run_step(
            compile_arguments(source, object, student_include(), prelude));
    };
    const Prelude prelude = prelude_for(read_file(source));
    Finished compiled = compile_with(prelude);
    if (prelude != Prelude::full && WIFEXITED(compiled.status) &&
        WEXITSTATUS(compiled.status) == 1)
        compiled = compile_with(Prelude::full);
    return compiled;
}

bool is_done(const Finished& step) {
    return step.status == 0 && !step.timed_out;
}

}  // namespace

Compiled LocalWorkplace::compile(const Exercise& exercise,
                                 const fs::path& source,
                                 const fs::path& shared) {
    std::vector<std::string> objects = {shared.string() + ".o"};
    Finished step = compile_file(source, objects[0]);
    const std::string messages = step.output;
    for (const fs::path& before : own_sources_before(exercise)) {
        if (!is_done(step)) break;
        objects.push_back(
            fmt::format("{}.{}.o", shared.string(), before.stem().string()));
        step = compile_file(before, objects.back());
    }
    objects.push_back(entry_object(exercise));
    if (is_done(step)) {
        step = run_step(link_arguments(objects, shared));
        step.output = messages + step.output;
    }
    return compiled_from(step, compiler_patience);
}

Process LocalWorkplace::launch(const fs::path& shared, const Limits&,
                               const Descriptor& control,
                               const Descriptor& complaints) {
    Command launcher;
    launcher.arguments = {build_root() / "course" / "course_worker", shared};
    launcher.environment = plain_environment();
    launcher.descriptors = {{complaints.get(), 2}, {control.get(), 3}};
    return Process(launcher);
}

ExerciseResult judge_submission(Workplace& workplace, const Exercise& exercise,
                                const std::filesystem::path& file,
                                JudgeKind kind,
                                const std::vector<std::uint64_t>& seeds) {
    return or_fault([&] {
        JudgeRun run = run_of(exercise, kind, seeds);
        std::error_code no_file;
        const std::uintmax_t size = fs::file_size(file, no_file);
        if (auto refused = too_large(run, no_file ? 0 : size)) return *refused;
        return judge(workplace, std::move(run), file, TemporaryFolder());
    });
}

ExerciseResult judge_source(Workplace& workplace, const Exercise& exercise,
                            const std::string& source, JudgeKind kind,
                            const std::vector<std::uint64_t>& seeds) {
    return or_fault([&] {
        JudgeRun run = run_of(exercise, kind, seeds);
        if (auto refused = too_large(run, source.size())) return *refused;
        const TemporaryFolder folder;
        const fs::path file = folder / exercise.file_name();
        write_file(file, source);
        return judge(workplace, std::move(run), file, folder);
    });
}

}  // namespace course

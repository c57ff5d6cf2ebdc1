#include "course/runner/judge_submission.h"

#include <fmt/format.h>

#include "course/runner/compile.h"
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

ExerciseResult judge_function(Workplace& workplace, JudgeRun run,
                              const fs::path& source) {
    const TemporaryFolder folder;
    const fs::path shared = folder / "submission.so";
    const Compiled compiled = workplace.compile(run.exercise, source, shared);
    ExerciseResult result;
    if (compiled.verdict == Verdict::accepted) {
        DescriptorPair control = socket_pair();
        const Descriptor complaints = anonymous_file();
        Process launcher = workplace.launch(shared, control.second, complaints);
        control.second.reset();
        run.control = std::move(control.first);
        result = run_judge(run);
        run.control.reset();
        launcher.end_within(std::chrono::seconds(2));
        if (result.verdict == Verdict::grader_fault)
            result.message += "\n" + last_bytes(complaints.get());
    } else {
        result = every_case(run.exercise, run.kind, compiled.verdict);
    }
    if (result.message.empty()) result.message = compiled.messages;
    return result;
}

}  // namespace

Compiled compiled_from(const Finished& finished,
                       std::chrono::milliseconds patience) {
    if (finished.timed_out)
        return {Verdict::compile_error,
                fmt::format("the compiler was stopped after {} s\n{}",
                            patience.count() / 1000, finished.output)};
    return {finished.status == 0 ? Verdict::accepted : Verdict::compile_error,
            for_students(finished.output)};
}

Compiled LocalWorkplace::compile(const Exercise& exercise,
                                 const fs::path& source,
                                 const fs::path& shared) {
    const std::string object = shared.string() + ".o";
    Finished compiled =
        run_step(compile_arguments(source, object, student_include()));
    if (compiled.status == 0 && !compiled.timed_out) {
        const std::string messages = compiled.output;
        compiled =
            run_step(link_arguments(object, entry_object(exercise), shared));
        compiled.output = messages + compiled.output;
    }
    return compiled_from(compiled, compiler_patience);
}

Process LocalWorkplace::launch(const fs::path& shared,
                               const Descriptor& control,
                               const Descriptor& complaints) {
    Command launcher;
    launcher.arguments = {build_root() / "course" / "course_worker", shared};
    launcher.environment = plain_environment();
    launcher.descriptors = {{complaints.get(), 2}, {control.get(), 3}};
    return Process(launcher);
}

ExerciseResult judge_submission(Workplace& workplace, const Exercise& exercise,
                                const fs::path& file, JudgeKind kind,
                                std::uint64_t seed) {
    try {
        JudgeRun run;
        run.exercise = exercise;
        run.kind = kind;
        run.seed = seed;
        if (!exercise.is_data)
            return judge_function(workplace, std::move(run), file);
        run.submitted = fs::absolute(file);
        return run_judge(run);
    } catch (const std::exception& error) {
        ExerciseResult fault;
        fault.message = error.what();
        return fault;
    }
}

}  // namespace course

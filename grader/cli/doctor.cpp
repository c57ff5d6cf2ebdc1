// grader doctor: what this machine protects from, tried out.
#include <fmt/format.h>
#include <unistd.h>

#include "course/report/text.h"
#include "course/runner/make_ready.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/attacks.h"

namespace grader {

namespace {

/// What an instructor worries about, and attacks of the corpus that try it.
struct Promise {
    const char* words;
    std::vector<const char*> attacks;
};

const std::vector<Promise>& promises() {
    static const std::vector<Promise> all = {
        {"files of this machine stay unread, by the compiler too",
         {"41_other_open_calls", "01_include_passwd", "02_incbin_suite"}},
        {"nor can it be found out which files there are",
         {"41_files_of_the_machine"}},
        {"no file is written, changed or removed",
         {"40_opens_for_writing", "40_replaces_itself", "39_many_files"}},
        {"nothing goes over the network",
         {"42_socket_inet", "42_loopback", "42_socket_unix"}},
        {"no process is started, none is ended or looked into",
         {"36_fork_bomb", "36_system", "35_kills_all", "35_ptrace"}},
        {"endless loops end at the limit of time", {"33_spin", "33_sleep"}},
        {"memory, output and recursion end at their limits",
         {"37_vector", "39_print_for_ever", "38_recursion"}},
        {"the compiler ends at its limits",
         {"05_template_tree", "06_giant_array"}},
        {"an answer cannot be forged, and ending early is none",
         {"24_forged_reply", "21_exit", "23_prints_json", "14_own_main"}},
    };
    return all;
}

/// The exercise that they all hand in.
constexpr const char* attacked = "face_sides";

/// Judges one attack; what went wrong, or nothing.
std::string trouble_with(const Attack& attack, const Bench& bench) {
    const course::TemporaryFolder folder;
    const auto exercise = course::exercise_named(attack.exercise);
    const auto result = course::judge_submission(*bench.workplace(0), exercise,
                                                 hand_in(attack, folder.path()),
                                                 course::JudgeKind::grade, {1});
    if (attack.is_as_expected(result)) return "";
    return fmt::format("{}: {}, {} of {} points; expected: {}", attack.name(),
                       words(result.verdict), result.points(), result.max(),
                       attack.expectation());
}

/// True when all attacks of the promise end as they must.
bool try_out(const Promise& promise, const Bench& bench) {
    std::vector<std::string> troubles;
    for (const char* name : promise.attacks)
        if (std::string text =
                trouble_with(attack_named(attacked, name), bench);
            !text.empty())
            troubles.push_back(std::move(text));
    fmt::print("  {:<8}{}\n", troubles.empty() ? "held" : "BROKEN",
               promise.words);
    for (const std::string& text : troubles)
        fmt::print("          {}\n", course::visible(text));
    return troubles.empty();
}

void print_machine(const Bench& bench) {
    fmt::print(
        "Submissions are kept apart from this machine by\n  {}\n  {}\n\n",
        bench.isolation_text(),
        ::geteuid() == 0
            ? fmt::format("users of their own, {} and on, one for each lane",
                          bench.stage().first_user())
            : "your own user; as root, each lane would have one of its own");
    for (const Isolation mode : {Isolation::bubblewrap, Isolation::landlock}) {
        const auto reason = why_not(bench.stage(), mode);
        fmt::print("  {:<12}{}\n", name(mode),
                   reason ? "not here: " + course::visible(*reason) : "works");
    }
    if (bench.stage().groups().folders().empty())
        fmt::print(
            "  no control groups: limits hold for each process, not for all "
            "of a step together\n");
}

int doctor_command(const JudgingOptions& options) {
    if (options.isolation == Isolation::none)
        throw CannotBegin("doctor runs attacks: not without isolation");
    course::make_ready({course::exercise_named(attacked)},
                       {course::JudgeKind::grade});
    const Bench bench(options);
    print_machine(bench);
    fmt::print("\nTried just now, with attacks of the corpus:\n");
    int broken = 0;
    for (const Promise& promise : promises())
        if (!try_out(promise, bench)) ++broken;
    if (broken == 0)
        fmt::print("\nThis machine may judge the submissions of strangers.\n");
    else
        fmt::print(
            "\n{} of {} promises do not hold here: use another machine, or be "
            "sure that you can do without them.\n",
            broken, promises().size());
    return broken == 0 ? 0 : 1;
}

}  // namespace

void add_doctor(CLI::App& program, int& code) {
    auto options = std::make_shared<JudgingOptions>();
    CLI::App* command = program.add_subcommand(
        "doctor", "Say what this machine protects from, and try it");
    options->add_to(*command);
    command->footer(
        "Exit code: 0 all of it holds, 1 something does not, 2 no isolation "
        "here or wrong usage.");
    command->callback([options, &code] { code = doctor_command(*options); });
}

}  // namespace grader

// Every attack of the corpus through the sandbox: it gets the verdict and the
// points that its first line says, ends in time, and leaves nothing behind; and
// the results of others are the same before, beside and after it.
// By default a sample; ATTACKS=all for all, ATTACKS=<part of a path> for some.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <thread>

#include "course/report/text.h"
#include "course/runner/catch2.h"
#include "course/runner/codec.h"
#include "course/runner/compile.h"
#include "course/runner/judge_submission.h"
#include "course/runner/limits.h"
#include "course/runner/pool.h"
#include "course/runner/temporary_folder.h"
#include "grader/pipeline/attacks.h"
#include "grader/report/feedback.h"
#include "grader/report/gradescope.h"
#include "grader/report/junit.h"
#include "grader/report/student_page.h"
#include "grader/report/terminal.h"
#include "grader/sandbox/sandbox.h"

using course::Clock;
using course::ExerciseResult;
using course::Verdict;
using grader::Attack;

namespace fs = std::filesystem;

namespace {

constexpr int lanes = 2;

// What attacks that write files write, in their names and in their text.
const std::string marker = std::string("attack-was") + "-here";

// What attacks say in front of an input that no student may read.
const std::string stolen = "stolen:";

const grader::Stage& the_stage() {
    static const grader::Stage stage;
    return stage;
}

/// ISOLATION=landlock tries the fallback.
grader::Isolation the_isolation() {
    const char* asked = std::getenv("ISOLATION");
    return asked != nullptr && std::string_view(asked) == "landlock"
               ? grader::Isolation::landlock
               : grader::Isolation::bubblewrap;
}

bool has_sandbox() {
    static const auto reason = grader::why_not(the_stage(), the_isolation());
    if (!reason) return true;
    WARN("skipped, not to be had on this machine: " << *reason);
    return false;
}

bool is_root() {
    return ::geteuid() == 0;
}

bool is_lane(uid_t user) {
    const auto first = static_cast<uid_t>(the_stage().first_user());
    return is_root() && user >= first && user < first + lanes;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// ---- what is left on the machine

/// Running processes of a lane's user. Those that have ended and wait to be
/// collected by the machine's first process do not count.
int processes_of(int user) {
    int count = 0;
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator("/proc", gone)) {
        std::ifstream status(entry.path() / "status");
        std::string word, state;
        int uid = -1;
        while (status >> word) {
            if (word == "State:") status >> state;
            if (word == "Uid:") status >> uid;
        }
        if (uid == user && state != "Z") ++count;
    }
    return count;
}

/// The end of a namespace is not waited for; it comes at once.
bool lane_is_empty(int lane) {
    if (!is_root()) return true;
    const int user = the_stage().first_user() + lane;
    const auto until = Clock::now() + std::chrono::seconds(5);
    while (processes_of(user) > 0 && Clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return processes_of(user) == 0;
}

bool is_of_an_attack(const fs::path& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) return false;
    return is_lane(status.st_uid) || contains(path.filename(), marker);
}

/// Files of a lane's user, or named by an attack, where all may write.
std::vector<std::string> left_files() {
    std::vector<std::string> left;
    const std::set<fs::path> folders = {fs::temp_directory_path(),
                                        "/tmp",
                                        "/var/tmp",
                                        "/dev/shm",
                                        "/dev/mqueue",
                                        "/run/lock"};
    for (const fs::path& folder : folders) {
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none))
            if (is_of_an_attack(entry.path())) left.push_back(entry.path());
    }
    return left;
}

/// System V objects of a lane's user.
std::vector<std::string> left_objects() {
    std::vector<std::string> left;
    for (const char* kind : {"shm", "msg", "sem"}) {
        std::ifstream table(fmt::format("/proc/sysvipc/{}", kind));
        std::string line, word;
        std::size_t column = 0, at = 0;
        std::getline(table, line);
        std::istringstream names(line);
        for (; names >> word; ++at)
            if (word == "uid") column = at;
        while (std::getline(table, line)) {
            std::istringstream words(line);
            for (at = 0; words >> word && at < column;) ++at;
            if (is_lane(static_cast<uid_t>(std::stoul(word))))
                left.push_back(fmt::format("{}: {}", kind, line));
        }
    }
    return left;
}

/// Whether a file was written after `start` with the mark of an attack in it.
/// Others may work in the same tree: what they write, or take away, is no find.
bool is_marked_since(const fs::directory_entry& entry,
                     fs::file_time_type start) {
    std::error_code gone;
    if (!entry.is_regular_file(gone) || entry.last_write_time(gone) < start)
        return false;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return contains(text, marker);
}

/// Files of the project that an attack made or changed since `start`.
std::vector<std::string> changed_files(fs::file_time_type start) {
    std::vector<std::string> changed;
    std::error_code gone;
    auto entry = fs::recursive_directory_iterator(course::source_root(), gone);
    for (; entry != fs::recursive_directory_iterator(); entry.increment(gone)) {
        const std::string name = entry->path().filename();
        if (name.rfind(".build", 0) == 0 || name == ".git" || name == "attacks")
            entry.disable_recursion_pending();
        else if (is_of_an_attack(entry->path()) ||
                 is_marked_since(*entry, start))
            changed.push_back(entry->path());
    }
    return changed;
}

/// What an attack must not change of the grader and its machine.
std::string machine() {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    std::string text = host.data();
    for (const auto resource :
         {RLIMIT_CPU, RLIMIT_FSIZE, RLIMIT_DATA, RLIMIT_STACK, RLIMIT_CORE,
          RLIMIT_NOFILE, RLIMIT_AS, RLIMIT_NPROC}) {
        rlimit limit{};
        ::getrlimit(resource, &limit);
        text += fmt::format(" {}/{}", limit.rlim_cur, limit.rlim_max);
    }
    return text;
}

// ---- one attack

using Seeds = std::vector<std::uint64_t>;

ExerciseResult judged(const std::string& exercise, const fs::path& file,
                      int lane, const Seeds& seeds) {
    const auto workplace =
        grader::workplace(the_isolation(), the_stage(), lane);
    return course::judge_submission(*workplace,
                                    course::exercise_named(exercise), file,
                                    course::JudgeKind::grade, seeds);
}

/// Twice as in grading, where it matters; once takes half the time.
Seeds seeds_for(const Attack& attack) {
    constexpr int state = 31, detection = 32, luck = 51;
    const bool twice =
        attack.item == state || attack.item == detection || attack.item == luck;
    return twice ? Seeds{1, 2} : Seeds{1};
}

/// All texts that came of the submission.
std::string texts_of(const ExerciseResult& result) {
    std::string text = result.message + "\n";
    for (const course::CaseResult& one : result.cases) {
        text += fmt::format("[{}] {}\n", name(one.verdict), one.info.name);
        for (const course::Failure& failure : one.failures)
            text += fmt::format("  {}: {}\n  {}\n", failure.call, failure.got,
                                failure.note);
        text += one.printed + "\n";
    }
    return text;
}

/// What the student reads of the file, and of cases that are hidden.
std::string hidden_texts_of(const ExerciseResult& result) {
    ExerciseResult shown =
        grader::for_student(result, grader::FeedbackLevel::names_and_hints);
    std::erase_if(shown.cases, [](const course::CaseResult& one) {
        return one.info.visibility == course::Visibility::shown;
    });
    return texts_of(shown);
}

/// Everything that is written of the result of one student.
struct Reports {
    std::string page, junit, gradescope, terminal;
};

Reports reports_of(const Attack& attack, const ExerciseResult& result) {
    const std::string exercise =
        course::exercise_named(attack.exercise).full_name();
    grader::ClassResults all;
    all.assignment = {"attacks", {{exercise, 1}}};
    all.exercises = {{exercise, 1, {exercise, "a.cpp", "1", result.max()}}};
    all.students = {{{"student", "student", {}}, {result}}};
    const grader::StudentResults& student = all.students[0];
    return {grader::student_page(all, student).text,
            grader::junit_xml(all, student),
            grader::gradescope_json(all, student),
            grader::student_text(all, student, grader::Colour::off)};
}

struct Outcome {
    std::string summary;
    std::vector<std::string> complaints;
};

/// What people read of the result.
void check_texts(const Attack& attack, const ExerciseResult& result,
                 Outcome& outcome) {
    const auto complain_if = [&](bool is_bad, const std::string& what) {
        if (is_bad) outcome.complaints.push_back(what);
    };
    complain_if(contains(hidden_texts_of(result), stolen),
                "the student reads a hidden input");
    complain_if(result.message.size() > 2 * course::most_compiler_output,
                "a message of megabytes");
    const std::string texts = texts_of(result);
    for (const char* secret : {"root:x:0", "hidden::made_by_hand"})
        complain_if(contains(texts, secret), "a file of the machine is read");
    const Reports reports = reports_of(attack, result);
    for (const std::string& page : {reports.page, reports.junit})
        complain_if(contains(page, "<script>alert"), "a page has a script");
    for (const std::string& report :
         {reports.page, reports.junit, reports.gradescope, reports.terminal})
        complain_if(report != course::visible(report),
                    "a report has bytes that nobody sees");
}

void check_grade(const Attack& attack, const ExerciseResult& result,
                 Outcome& outcome) {
    if (!attack.is_as_expected(result))
        outcome.complaints.push_back(
            fmt::format("{}, {} points; expected {}", name(result.verdict),
                        result.points(), attack.expectation()));
}

void check_machine(int lane, Outcome& outcome) {
    if (!lane_is_empty(lane))
        outcome.complaints.push_back("processes are left");
    for (const auto& left : {left_files(), left_objects()})
        for (const std::string& one : left)
            outcome.complaints.push_back("left behind: " + one);
}

Outcome outcome_of(const Attack& attack, int lane) {
    // Far above what the limits add up to: a guard against hanging.
    constexpr std::chrono::milliseconds longest =
        2 * (std::chrono::milliseconds(course::Limits{}.run_ms) +
             course::compiler_patience);
    const course::TemporaryFolder folder;
    const fs::path file = grader::hand_in(attack, folder.path());
    Outcome outcome;
    const auto start = Clock::now();
    const ExerciseResult result =
        judged(attack.exercise, file, lane, seeds_for(attack));
    const std::chrono::duration<double> seconds = Clock::now() - start;
    check_grade(attack, result, outcome);
    check_texts(attack, result, outcome);
    check_machine(lane, outcome);
    if (seconds > longest) outcome.complaints.push_back("it took too long");
    outcome.summary =
        fmt::format("{:6.2f} s  {:<22} {:>3}  {}", seconds.count(),
                    name(result.verdict), result.points(), attack.name());
    if (!outcome.complaints.empty())
        outcome.summary += "\n" + texts_of(result).substr(0, 3000);
    return outcome;
}

// ---- the batch

const char* asked_for() {
    return std::getenv("ATTACKS");
}

/// A sample that is spread over the corpus, unless the environment says more.
std::vector<Attack> chosen() {
    constexpr std::size_t sample = 32;
    const std::vector<Attack> all = grader::attack_corpus();
    const std::string wanted = asked_for() != nullptr ? asked_for() : "";
    std::vector<Attack> some;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool in_sample =
            k * sample / all.size() != (k + 1) * sample / all.size();
        if (wanted.empty() ? in_sample
                           : wanted == "all" || contains(all[k].file, wanted))
            some.push_back(all[k]);
    }
    return some;
}

/// Results of submissions that have nothing to do with the attacks, as bytes.
std::string bystanders(int lane) {
    const fs::path root = course::source_root();
    const fs::path right = root / "solutions/01_traversal/face_sides.cpp";
    const fs::path wrong = root / "grader/wrong/01_traversal/face_sides/" /
                           "wrong_answer/every_face_a_triangle.cpp";
    std::string bytes;
    for (const fs::path& file : {right, wrong})
        bytes += course::encode(judged("face_sides", file, lane, {1}));
    return bytes;
}

/// Runs the attacks on two lanes; now and then bystanders beside them.
std::vector<Outcome> run(const std::vector<Attack>& attacks,
                         const std::string& undisturbed) {
    constexpr std::size_t bystanders_after = 8;
    std::vector<Outcome> outcomes(attacks.size());
    std::mutex guard;
    const auto one = [&](int lane, int item) {
        const auto k = static_cast<std::size_t>(item);
        Outcome outcome = outcome_of(attacks[k], lane);
        if (k % bystanders_after == 0 && bystanders(lane) != undisturbed)
            outcome.complaints.push_back("others beside it were disturbed");
        const std::scoped_lock lock(guard);
        if (asked_for() != nullptr) fmt::print("{}\n", outcome.summary);
        std::fflush(stdout);
        outcomes[k] = std::move(outcome);
    };
    course::for_each_item(lanes, static_cast<int>(attacks.size()), one);
    return outcomes;
}

// Items of the list of threats that a source file can carry.
const std::set<int> carried = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                               13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
                               25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36,
                               37, 38, 39, 40, 41, 42, 43, 44, 50, 51, 53};

}  // namespace

TEST_CASE("each attack says what must become of it, and none is missing") {
    std::set<int> items;
    for (const Attack& attack : grader::attack_corpus()) {
        INFO(attack.name());
        CHECK_NOTHROW(course::exercise_named(attack.exercise));
        CHECK_FALSE(attack.what.empty());
        items.insert(attack.item);
    }
    for (const int item : carried) {
        INFO("threat " << item);
        CHECK(items.count(item) == 1);
    }
}

TEST_CASE("attacks gain nothing, leave nothing and disturb nobody") {
    if (!has_sandbox()) return;
    const std::vector<Attack> attacks = chosen();
    REQUIRE_FALSE(attacks.empty());
    const auto start = fs::file_time_type::clock::now();
    const std::string before = machine();
    const std::string undisturbed = bystanders(0);
    const std::vector<Outcome> outcomes = run(attacks, undisturbed);
    for (std::size_t k = 0; k < attacks.size(); ++k) {
        INFO(attacks[k].name() << ": " << attacks[k].what);
        INFO(outcomes[k].summary);
        for (const std::string& complaint : outcomes[k].complaints)
            FAIL_CHECK(complaint);
    }
    CHECK(bystanders(1) == undisturbed);
    CHECK(machine() == before);
    CHECK(changed_files(start) == std::vector<std::string>{});
}

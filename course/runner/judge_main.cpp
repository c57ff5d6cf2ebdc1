// The judge: a Catch2 program with the suites of one exercise. The functions
// under test are either linked in (reference) or live in a worker (--control).
// With --results it reports to the program that started it; without, it prints
// as any Catch2 program does.
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_NO_POSIX_SIGNALS
#include "course/runner/catch2.h"
#if COURSE_CATCH2 == 3
#include <catch2/internal/catch_test_case_registry_impl.hpp>
#endif

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "course/runner/case_record.h"
#include "course/runner/client.h"
#include "course/runner/judge_stream.h"
#include "course/runner/platform.h"
#include "course/runner/submitted_table.h"
#include "course/runner/suite.h"

#if COURSE_LINUX
#include <sys/prctl.h>
#include <sys/resource.h>
#endif

namespace {

// Set when a check is ended by WorkerFailed. Not told by the text: that of a
// student's exception is the student's choice.
bool ended_by_worker = false;

}  // namespace

CATCH_TRANSLATE_EXCEPTION(const course::WorkerFailed&) {
    ended_by_worker = true;
    return "the submission's process failed";
}

namespace course {

namespace {

// The cases of this run of all cases, in their order.
std::vector<CaseResult> the_results;

CaseInfo info_of(const Catch::TestCaseInfo& test) {
    CaseInfo info;
#if COURSE_CATCH2 == 2
    info.name = test.name;
    for (const std::string& tag : test.tags) {
#else
    info.name = test.name;
    for (const Catch::Tag& item : test.tags) {
        const std::string tag(item.original);
#endif
        const std::string key = "points:";
        if (tag.rfind(key, 0) == 0)
            info.points = std::atof(tag.c_str() + key.size());
    }
    // The build makes paths relative to the root of the project.
    const std::string file = test.lineInfo.file;
    if (file.rfind("exercises/", 0) == 0) info.visibility = Visibility::shown;
    return info;
}

std::vector<CaseInfo> all_cases(Catch::Session& session) {
    std::vector<CaseInfo> infos;
    for (const auto& test : Catch::getAllTestCasesSorted(session.config()))
#if COURSE_CATCH2 == 2
        infos.push_back(info_of(test));
#else
        infos.push_back(info_of(test.getTestCaseInfo()));
#endif
    return infos;
}

MeshPicture picture_of(const Fixture& fixture) {
    constexpr int most_rows = 80;
    MeshPicture picture{fixture.name, {}, {}};
    if (fixture.he.size() > most_rows) return picture;
    picture.rows = fixture.he.rows();
    picture.positions = fixture.mesh.positions;
    return picture;
}

/// The failure of the running case, as far as its last call tells it.
Failure failure_of_last_call() {
    Failure failure;
    if (!case_record().meshes.empty())
        failure.mesh = picture_of(*case_record().meshes.back());
    if (Client::current() == nullptr) return failure;
    Client::current()->walk_again();
    const LastCall& last = Client::current()->last_call();
    if (last.call) failure.call = last.call();
    if (last.got) failure.got = last.got();
    failure.walk = last.walk;
    failure.reads = last.reads;
    return failure;
}

/// What was expected: "0 == 4" without the "0" that came. When the check does
/// not begin with the answer, as in CHECK(f(x).empty()), the check itself.
std::string expected_of(const Catch::AssertionResult& result,
                        const std::string& got) {
    const std::string expanded(result.getExpandedExpression());
    // CHECK(f(x)) and CHECK_FALSE(f(x)) of a bool.
    if (got == "false" && expanded == got) return "true";
    if (got == "true" && expanded == "!true") return "false";
    if (got.empty() || expanded.rfind(got, 0) != 0)
        return std::string(result.getExpression());
    std::string rest = expanded.substr(got.size());
    for (const char* sign : {" == ", "\n==\n", " is, ", "\nis, ", " ", "\n"})
        if (rest.rfind(sign, 0) == 0) return rest.substr(std::strlen(sign));
    return rest;
}

/// A check that calls no function of the student: "3 == 4" is what came, and
/// what was expected.
void split_comparison(const Catch::AssertionResult& result, Failure& failure) {
    failure.call = std::string(result.getExpression());
    const std::string expanded(result.getExpandedExpression());
    for (const char* sign : {" == ", "\n==\n"})
        if (const auto at = expanded.find(sign);
            failure.got.empty() && at != std::string::npos)
            failure.got = expanded.substr(0, at);
}

bool is_exception(Catch::ResultWas::OfType type) {
    return type == Catch::ResultWas::ThrewException;
}

void note_assertion(const Catch::AssertionStats& stats) {
    const Catch::AssertionResult& result = stats.assertionResult;
    if (std::exchange(ended_by_worker, false)) return;  // recorded already
    if (result.isOk()) return;
    Failure failure = failure_of_last_call();
    for (const Catch::MessageInfo& message : stats.infoMessages)
        failure.note += message.message + "\n";
    if (is_exception(result.getResultType())) {
        failure.got = "an exception: " + std::string(result.getMessage());
        return case_record().add(Verdict::run_time_error, std::move(failure));
    }
    if (failure.call.empty()) split_comparison(result, failure);
    failure.expected = expected_of(result, failure.got);
    if (result.getResultType() == Catch::ResultWas::ExplicitFailure)
        failure.expected = std::string(result.getMessage());
    if (failure.got.empty())
        failure.got = std::string(result.getExpandedExpression());
    case_record().add(Verdict::wrong_answer, std::move(failure));
}

void begin_run_of_case() {
    case_record().meshes.clear();
    if (Client::current() != nullptr) Client::current()->begin_case();
}

void end_run_of_case() {
    if (Client::current() != nullptr) Client::current()->end_case();
}

void report_case(const Catch::TestCaseInfo& test,
                 const Catch::Counts& assertions) {
    CaseRecord& record = case_record();
    CaseResult result;
    result.info = info_of(test);
    result.verdict = record.verdict;
    // Fails closed: what Catch2 counts as failed was never passed.
    if (assertions.failed > 0 && result.verdict == Verdict::accepted)
        result.verdict = Verdict::grader_fault;
    result.failures = std::move(record.failures);
    result.hint = record.hint;
    if (Client::current() != nullptr)
        result.printed = Client::current()->printed();
    the_results.push_back(std::move(result));
    record = {};
}

#if COURSE_CATCH2 == 2
using ListenerBase = Catch::TestEventListenerBase;
#define COURSE_ASSERTION_ENDED bool
#define COURSE_ASSERTION_RESULT return true
#else
using ListenerBase = Catch::EventListenerBase;
#define COURSE_ASSERTION_ENDED void
#define COURSE_ASSERTION_RESULT return
#endif

/// One fresh worker for each run of a test case: Catch2 enters a test case
/// once for each of its leaf sections.
class Listener : public ListenerBase {
public:
    using ListenerBase::ListenerBase;

    void testCaseStarting(const Catch::TestCaseInfo& test) override {
        ListenerBase::testCaseStarting(test);
        case_record() = {};
    }
    void sectionStarting(const Catch::SectionInfo& info) override {
        ListenerBase::sectionStarting(info);
        if (depth_++ == 0) begin_run_of_case();
    }
    COURSE_ASSERTION_ENDED assertionEnded(
        const Catch::AssertionStats& stats) override {
        note_assertion(stats);
        COURSE_ASSERTION_RESULT;
    }
    void sectionEnded(const Catch::SectionStats& stats) override {
        if (--depth_ == 0) end_run_of_case();
        ListenerBase::sectionEnded(stats);
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
#if COURSE_CATCH2 == 2
        report_case(stats.testInfo, stats.totals.assertions);
#else
        report_case(*stats.testInfo, stats.totals.assertions);
#endif
        ListenerBase::testCaseEnded(stats);
    }

private:
    int depth_ = 0;
};

struct Options {
    int control = -1;
    int results = -1;
    int go = -1;
    std::vector<std::uint64_t> seeds = {1};
    std::string submitted;
    std::vector<std::string> catch_arguments;
};

int run_catch(Catch::Session& session, const Options& options) {
    std::vector<const char*> arguments = {"judge"};
    for (const std::string& argument : options.catch_arguments)
        arguments.push_back(argument.c_str());
    if (options.results >= 0)
        // Nobody reads what Catch2 prints; xml is the reporter that does not
        // wrap long lines.
        for (const char* argument :
             {"--out", "/dev/null", "--reporter", "xml", "--order", "decl"})
            arguments.push_back(argument);
    return session.applyCommandLine(static_cast<int>(arguments.size()),
                                    arguments.data());
}

/// Of the same case in two runs the worse result, with a word that it passed
/// in one of them.
void take_worse(CaseResult& before, CaseResult& now) {
    if (now.verdict <= before.verdict) return;
    // Who ran out of time was not unlucky, but slow.
    if (before.verdict == Verdict::accepted &&
        now.verdict != Verdict::time_limit_exceeded)
        now.hint =
            "Your function passed this case once and failed it when it was run "
            "again, in a fresh process and with other numbers: does its result "
            "depend on a variable without a value, on chance, or on how "
            "half-edges are numbered? " +
            now.hint;
    before = std::move(now);
}

bool has_tag(const Catch::TestCaseInfo& test, const std::string& wanted) {
#if COURSE_CATCH2 == 2
    return std::find(test.tags.begin(), test.tags.end(), wanted) !=
           test.tags.end();
#else
    return std::any_of(test.tags.begin(), test.tags.end(),
                       [&](const Catch::Tag& tag) {
                           return std::string(tag.original) == wanted;
                       });
#endif
}

/// What some case needs and takes long to make; nothing of it depends on the
/// submission.
void make_ready(Catch::Session& session) {
    for (const auto& test : Catch::getAllTestCasesSorted(session.config()))
#if COURSE_CATCH2 == 2
        if (has_tag(test, "large")) a_million_half_edges();
#else
        if (has_tag(test.getTestCaseInfo(), "large")) a_million_half_edges();
#endif
}

/// The result of that name.
CaseResult& result_named(std::vector<CaseResult>& all,
                         const std::string& name) {
    for (CaseResult& result : all)
        if (result.info.name == name) return result;
    throw SystemError("the second run had other cases than the first");
}

/// All cases, once for each seed as long as there is something to lose. Those
/// on a large mesh once (nobody answers thousands of calls by chance), and
/// those tagged so because they measure the cost.
std::vector<CaseResult> results_of_all(
    Catch::Session& session, const std::vector<std::uint64_t>& seeds) {
    std::vector<CaseResult> all;
    const auto is_passed = [](const CaseResult& result) {
        return result.verdict == Verdict::accepted;
    };
    for (const std::uint64_t seed : seeds) {
        set_seed(seed);
        if (Client::current() != nullptr) Client::current()->begin_run();
        the_results.clear();
        session.run();
        if (all.empty()) all = the_results;
        for (CaseResult& now : the_results)
            take_worse(result_named(all, now.info.name), now);
        if (std::none_of(all.begin(), all.end(), is_passed)) break;
        session.configData().testsOrTags = {"~[large]~[once]"};
        session.useConfigData(session.configData());
    }
    return all;
}

/// Waits for the word to run the cases, which is the limits that hold for them;
/// nothing when there will be none.
std::optional<Limits> wait_for_word(int go) {
    if (go < 0) return Limits{};
    std::string word = encode(Limits{});
    if (!read_all(go, word.data(), word.size())) return std::nullopt;
    return decode<Limits>(word);
}

void run_cases(Catch::Session& session, const Options& options,
               const Limits& limits, JudgeStream& stream) {
    std::optional<Client> client;
    if (options.control >= 0) {
        client.emplace(Descriptor(options.control), limits);
        client->on_failure = [](Verdict verdict, const std::string& why) {
            Failure failure = failure_of_last_call();
            failure.got = why;
            case_record().add(verdict, std::move(failure));
        };
        Client::set_current(&*client);
    }
    for (const CaseResult& result : results_of_all(session, options.seeds))
        stream.report(result);
    Client::set_current(nullptr);
}

int judge(const Options& options) {
    Catch::Session session;
    if (const int code = run_catch(session, options); code != 0) return code;
    set_submitted_file(options.submitted);
    set_seed(options.seeds.at(0));
    if (options.results < 0) return session.run();
    JudgeStream stream{Descriptor(options.results)};
    stream.plan(all_cases(session));
    make_ready(session);
    if (const auto limits = wait_for_word(options.go))
        run_cases(session, options, *limits, stream);
    stream.end();
    return 0;
}

/// The judge is ours, but what it reads is not: it may neither take the memory
/// of the machine nor outlive the program that started it.
void limit_this_process() {
#if COURSE_LINUX
    constexpr rlim_t most = rlim_t{4} << 30;
    const rlimit memory{most, most};
    ::setrlimit(RLIMIT_AS, &memory);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

}  // namespace

CATCH_REGISTER_LISTENER(Listener)

}  // namespace course

int main(int argc, char** argv) {
    course::limit_this_process();
    course::Options options;
    CLI::App app("The judge of one exercise (started by lab and grader)");
    app.add_option("--control", options.control,
                   "descriptor of the conversation with the launcher");
    app.add_option("--results", options.results,
                   "descriptor that the results are written to");
    app.add_option("--go", options.go,
                   "descriptor that the limits are awaited on before the cases "
                   "are run; none of them is when it is closed instead");
    app.add_option("--seed", options.seeds,
                   "seed of generated meshes; every case is run once for each");
    app.add_option("--submitted", options.submitted,
                   "the submitted file of a data exercise");
    app.add_option("--catch", options.catch_arguments, "arguments for Catch2");
    CLI11_PARSE(app, argc, argv);
    try {
        return course::judge(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}

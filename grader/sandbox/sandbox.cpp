#include "grader/sandbox/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>
#include <tuple>
#include <utility>

#include "course/runner/compile.h"
#include "course/runner/limits.h"
#include "grader/sandbox/filters.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::Descriptor;

using Arguments = std::vector<std::string>;

void append(Arguments& to, const Arguments& more) {
    to.insert(to.end(), more.begin(), more.end());
}

void write_file(const fs::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) course::throw_errno("cannot write " + file.string());
}

Descriptor open_file(const fs::path& file, int flags) {
    Descriptor fd(::open(file.c_str(), flags | O_CLOEXEC, 0644));
    if (!fd) course::throw_errno("cannot open " + file.string());
    return fd;
}

bool is_root() {
    return ::geteuid() == 0;
}

/// For the user of the lane, who is not the grader's.
void let_others_read(const fs::path& folder,
                     const std::vector<fs::path>& files) {
    fs::permissions(folder, fs::perms(0711));
    for (const fs::path& file : files) fs::permissions(file, fs::perms(0644));
}

/// Paths in the output of the loader's own listing of a program's libraries.
Arguments libraries_of(const fs::path& program) {
    course::Command command;
    command.arguments = {"ldd", program};
    command.environment = course::plain_environment();
    const course::Finished listed =
        course::run(command, std::chrono::seconds(10), 65536);
    Arguments found;
    std::istringstream words(listed.output);
    for (std::string word; words >> word;)
        if (word.front() == '/') found.push_back(word);
    if (listed.status != 0 || found.empty())
        throw course::SystemError("ldd does not say what the worker needs");
    return found;
}

/// The libraries at the paths where the loader looks for them.
void copy_libraries(const Arguments& libraries, const fs::path& root) {
    for (const std::string& library : libraries) {
        const fs::path copy = root / library.substr(1);
        fs::create_directories(copy.parent_path());
        fs::copy_file(library, copy, fs::copy_options::skip_existing);
    }
}

/// Blocks of user numbers where Debian and Ubuntu have no accounts. A grader
/// holds the lock of the block that it uses: processes are counted by user, and
/// two graders must not count each other's.
constexpr int first_block = 50'000;
constexpr int blocks = 64;
constexpr int block_size = 64;

std::pair<Descriptor, int> lock_users() {
    fs::create_directories("/run/lock");
    for (int block = 0; block < blocks; ++block) {
        const std::string name =
            fmt::format("/run/lock/half-edge-grader-{}", block);
        Descriptor file(::open(
            name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
        // Anybody may have made that file, and only its lock counts.
        if (file && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0)
            return {std::move(file), first_block + block * block_size};
    }
    throw course::SystemError(fmt::format(
        "none of {} blocks of user numbers could be locked: are so many "
        "graders running, or may /run/lock not be written?",
        blocks));
}

// ---- what both isolations share

constexpr StepLimits compiling = {10, 2048, 2112, 32, 32};
// Each worker sets limits of its own; beside it stand launcher and bubblewrap.
StepLimits running(const course::Limits& limits) {
    return {0, 0, limits.memory_mib + 128, 32, 16};
}

uid_t user_of(const Stage& stage, int slot) {
    return static_cast<uid_t>(stage.first_user() + slot);
}

/// Root keeps its power in a namespace: each lane gets a user of its own, whose
/// count of processes is its own, too. Of an ordinary user it would count the
/// whole desktop.
Arguments entering(const Stage& stage, int slot, const StepLimits& limits,
                   const std::optional<ControlGroup>& group) {
    Arguments list = {stage.enter(), fmt::format("--parent={}", ::getpid()),
                      fmt::format("--cpu={}", limits.cpu_seconds),
                      fmt::format("--memory={}", limits.process_mib),
                      fmt::format("--file-size={}", limits.file_mib)};
    if (group)
        for (const fs::path& file : group->members())
            list.push_back("--join=" + file.string());
    if (is_root()) {
        list.push_back(fmt::format("--processes={}", limits.processes));
        list.push_back(fmt::format("--user={}", user_of(stage, slot)));
    }
    return list;
}

std::string shell_words(const Arguments& arguments) {
    // All of them are ours; none holds a quote.
    std::string line;
    for (const std::string& argument : arguments)
        line += fmt::format("'{}' ", argument);
    return line;
}

course::Prelude prelude_of(const fs::path& source) {
    return course::prelude_for(course::read_file(source));
}

/// Compile, link, and hand the result out by descriptor 3. What the compiler
/// says with a smaller prelude does not count when it fails.
std::string compile_script(const course::Exercise& exercise,
                           const std::string& work, const std::string& student,
                           course::Prelude prelude) {
    const auto compile = [&](course::Prelude with) {
        return shell_words(course::compile_arguments(
            exercise.file_name(), work + "/s.o", student + "/include", with));
    };
    const auto link = course::link_arguments(
        {work + "/s.o", fmt::format("{}/entries/{}.o", student, exercise.name)},
        work + "/s.so");
    std::string script = compile(course::Prelude::full);
    if (prelude != course::Prelude::full)
        script = fmt::format(
            "{} >{}/said 2>&1; s=$?; if [ $s = 1 ]; then {}; else [ ! -s "
            "{}/said ] || cat {}/said; [ $s = 0 ]; fi",
            compile(prelude), work, script, work, work);
    return script + " && " + shell_words(link) + "&& cat " + work + "/s.so >&3";
}

/// Compiler, linker and system headers: the same on both sides.
std::vector<std::string> toolchain() {
    std::vector<std::string> folders;
    for (const char* folder :
         {"/usr/bin", "/usr/lib", "/usr/include", "/usr/lib64", "/usr/libexec"})
        if (fs::exists(folder)) folders.push_back(folder);
    return folders;
}

// ---- bubblewrap

/// Namespaces of its own for everything, nobody inside, no way up. The command
/// is the first process inside: bubblewrap would put one of its own there, does
/// not wait for its end, and in a container nobody may collect it. All stay in
/// the session and group of their Process, by which they can be ended even
/// before bubblewrap has seen to it that they end with the grader.
Arguments bubblewrap() {
    return {"--",
            "bwrap",
            "--unshare-user",
            "--unshare-pid",
            "--unshare-net",
            "--unshare-ipc",
            "--unshare-uts",
            "--unshare-cgroup-try",
            "--as-pid-1",
            "--disable-userns",
            "--uid",
            "65534",
            "--gid",
            "65534",
            "--hostname",
            "sandbox",
            "--die-with-parent",
            "--cap-drop",
            "ALL",
            "--clearenv",
            "--setenv",
            "LC_ALL",
            "C.UTF-8"};
}

Arguments read_only(const std::string& ours, const std::string& theirs) {
    return {"--ro-bind", ours, theirs};
}

Arguments worker_mounts(const Stage& stage) {
    Arguments list = read_only(stage.worker(), "/worker");
    for (const std::string& library : stage.libraries())
        append(list, read_only(fs::canonical(library), library));
    return list;
}

Arguments compiler_mounts(const Stage& stage) {
    Arguments list;
    for (const std::string& folder : toolchain())
        append(list, read_only(folder, folder));
    for (const char* link : {"bin", "lib", "lib64"})
        append(list, {"--symlink", fmt::format("usr/{}", link),
                      fmt::format("/{}", link)});
    append(list,
           {"--dev-bind", "/dev/null", "/dev/null", "--size",
            std::to_string(64 << 20), "--perms", "0700", "--tmpfs", "/tmp",
            "--setenv", "PATH", "/usr/bin", "--setenv", "TMPDIR", "/tmp"});
    append(list, read_only(stage.student(), "/student"));
    return list;
}

Arguments compile_under_bubblewrap(const Stage& stage,
                                   const course::Exercise& exercise,
                                   const fs::path& source) {
    Arguments list = bubblewrap();
    append(list, compiler_mounts(stage));
    append(list, read_only(source, "/src/" + exercise.file_name()));
    append(list,
           {"--remount-ro", "/", "--chdir", "/src", "--seccomp", "9",
            "--json-status-fd", "8", "--", "/bin/sh", "-c",
            compile_script(exercise, "/tmp", "/student", prelude_of(source))});
    return list;
}

Arguments run_under_bubblewrap(const Stage& stage, const fs::path& shared) {
    Arguments list = bubblewrap();
    append(list, worker_mounts(stage));
    append(list, read_only(shared, "/submission.so"));
    append(list, {"--remount-ro", "/", "--chdir", "/", "--seccomp", "9", "--",
                  "/worker", "/submission.so"});
    return list;
}

/// bubblewrap writes the exit code of the command only if it got that far.
bool got_that_far(const Descriptor& status_file) {
    std::string text(4096, '\0');
    const ssize_t n = ::pread(status_file.get(), text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    return text.find("\"exit-code\"") != std::string::npos;
}

// ---- Landlock, where namespaces are refused

/// Exit code of grader_enter when the command was never started.
constexpr int never_started = 125;

/// For the compiler's output; its user may write there and nowhere else.
fs::path scratch_beside(const fs::path& source) {
    return source.parent_path() / "scratch";
}

void make_scratch(const fs::path& folder, const Stage& stage, int slot) {
    fs::create_directory(folder);
    fs::permissions(folder, fs::perms(0700));
    const uid_t user = user_of(stage, slot);
    if (is_root() && ::chown(folder.c_str(), user, user) != 0)
        course::throw_errno("cannot give away " + folder.string());
}

Arguments compile_under_landlock(const Stage& stage,
                                 const course::Exercise& exercise,
                                 const fs::path& source) {
    const fs::path scratch = scratch_beside(source);
    Arguments list = {"--filter=9",
                      "--chdir=" + source.parent_path().string(),
                      "--read=" + source.string(),
                      "--read=" + stage.student().string(),
                      "--write=" + scratch.string(),
                      "--write=/dev/null"};
    for (const std::string& folder : toolchain())
        list.push_back("--read=" + folder);
    append(list, {"--", "/bin/sh", "-c",
                  compile_script(exercise, scratch, stage.student(),
                                 prelude_of(source))});
    return list;
}

/// Where a lane's submission lies in the root folder of the run step.
fs::path place_of(int slot) {
    return fs::path("/lanes") / std::to_string(slot);
}

/// As root, the worker sees no folder but its own.
Arguments around_worker(const Stage& stage) {
    Arguments list = {"--filter=9"};
    if (!is_root()) {
        append(list, {"--read=" + stage.worker().string()});
        for (const std::string& library : stage.libraries())
            list.push_back("--read=" + library);
        return list;
    }
    list.push_back("--root=" + stage.root().string());
    for (const auto& entry : fs::directory_iterator(stage.root()))
        if (entry.path().filename() != "lanes")
            list.push_back("--read=" + entry.path().string());
    return list;
}

Arguments run_under_landlock(const Stage& stage, int slot,
                             const fs::path& shared) {
    Arguments list = around_worker(stage);
    if (!is_root()) {
        append(list, {"--read=" + shared.string(), "--", stage.worker(),
                      shared.string()});
        return list;
    }
    const fs::path inside = place_of(slot) / "submission.so";
    const fs::path outside = stage.root() / inside.relative_path();
    fs::create_directories(outside.parent_path());
    fs::remove(outside);
    fs::create_hard_link(shared, outside);
    append(list, {"--read=" + outside.string(), "--", "/worker", inside});
    return list;
}

/// Without a namespace of processes their user tells what belongs to a lane.
void kill_all_of(uid_t user) {
    const pid_t pid = ::fork();
    if (pid == 0) {
        if (::setresuid(user, user, user) == 0) ::kill(-1, SIGKILL);
        ::_exit(0);
    }
    while (pid > 0 && ::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    }
}

// ---- either of them: what follows grader_enter and its limits

course::Command compile_step(Isolation isolation, const Stage& stage,
                             const course::Exercise& exercise,
                             const fs::path& source) {
    course::Command command;
    if (isolation == Isolation::bubblewrap) {
        command.environment = course::plain_environment();  // cleared inside
        command.arguments = compile_under_bubblewrap(stage, exercise, source);
    } else {
        command.environment = {"LC_ALL=C.UTF-8", "PATH=/usr/bin:/bin",
                               "TMPDIR=" + scratch_beside(source).string()};
        command.arguments = compile_under_landlock(stage, exercise, source);
    }
    return command;
}

course::Command run_step(Isolation isolation, const Stage& stage, int slot,
                         const fs::path& shared) {
    course::Command command;
    if (isolation == Isolation::bubblewrap) {
        command.environment = course::plain_environment();
        command.arguments = run_under_bubblewrap(stage, shared);
    } else {
        command.environment = {"LC_ALL=C.UTF-8"};
        command.arguments = run_under_landlock(stage, slot, shared);
    }
    return command;
}

bool has_started(Isolation isolation, const course::Finished& finished,
                 const Descriptor& status_file) {
    if (isolation == Isolation::bubblewrap) return got_that_far(status_file);
    return !WIFEXITED(finished.status) ||
           WEXITSTATUS(finished.status) != never_started;
}

// ---- trying it

Arguments probe_arguments(const Stage& stage, Isolation isolation) {
    Arguments list = entering(stage, 0, running({}), std::nullopt);
    if (isolation == Isolation::bubblewrap) {
        append(list, bubblewrap());
        append(list, worker_mounts(stage));
        append(list, {"--remount-ro", "/", "--", "/worker", "--probe"});
    } else {
        append(list, around_worker(stage));
        append(list, {"--", is_root() ? "/worker" : stage.worker().string(),
                      "--probe"});
    }
    return list;
}

}  // namespace

std::string_view name(Isolation isolation) {
    constexpr const char* names[] = {"bubblewrap", "landlock", "none"};
    return names[static_cast<int>(isolation)];
}

std::string_view words(Isolation isolation) {
    constexpr const char* all[] = {
        "bubblewrap: namespaces, system-call filter, limits",
        "landlock: no namespaces; Landlock, system-call filter, limits",
        "none: limits only"};
    return all[static_cast<int>(isolation)];
}

Stage::Stage() {
    course::remove_stale_temporary_folders();
    const fs::path build = course::build_root();
    fs::permissions(folder_.path(), fs::perms(0755));
    fs::create_directories(root() / "lanes");
    fs::copy_file(build / "grader" / "grader_worker", worker());
    fs::copy_file(build / "grader" / "grader_enter", enter());
    fs::create_directory(student());
    for (const char* shown : {"include", "entries"})
        fs::copy(build / "student" / shown, student() / shown,
                 fs::copy_options::recursive);
    write_file(compile_filter(), grader::compile_filter());
    write_file(worker_filter(), grader::worker_filter());
    libraries_ = libraries_of(worker());
    if (!is_root()) return;
    copy_libraries(libraries_, root());
    std::tie(user_lock_, first_user_) = lock_users();
}

std::optional<std::string> why_not(const Stage& stage, Isolation isolation) {
    if (isolation == Isolation::none) return std::nullopt;
    const Descriptor filter = open_file(stage.compile_filter(), O_RDONLY);
    course::Command command;
    command.arguments = probe_arguments(stage, isolation);
    command.environment = course::plain_environment();
    command.descriptors = {{filter.get(), 9}};
    try {
        const course::Finished tried =
            course::run(command, std::chrono::seconds(10), 4096);
        if (tried.status == 0 && tried.output == "ready\n") return std::nullopt;
        return tried.output.substr(0, tried.output.find_last_not_of('\n') + 1);
    } catch (const course::SystemError& error) {
        return error.what();
    }
}

Probe probe(const Stage& stage) {
    Probe found;
    for (const Isolation tried : {Isolation::bubblewrap, Isolation::landlock}) {
        const auto reason = why_not(stage, tried);
        found.isolation = tried;
        if (!reason) return found;
        if (!found.reason.empty()) found.reason += "; ";
        found.reason += fmt::format("{}: {}", name(tried), *reason);
    }
    found.isolation = Isolation::none;
    return found;
}

Sandbox::~Sandbox() {
    group_.reset();
    if (isolation_ == Isolation::landlock && is_root())
        kill_all_of(user_of(stage_, slot_));
}

/// Of those that this process may use, one for each lane.
std::optional<int> Sandbox::processor() const {
    cpu_set_t usable;
    if (::sched_getaffinity(0, sizeof usable, &usable) != 0)
        return std::nullopt;
    int left = slot_ % std::max(CPU_COUNT(&usable), 1);
    for (int k = 0; k < CPU_SETSIZE; ++k)
        if (CPU_ISSET(static_cast<std::size_t>(k), &usable) && left-- == 0)
            return k;
    return std::nullopt;
}

course::Compiled Sandbox::compile(const course::Exercise& exercise,
                                  const fs::path& source,
                                  const fs::path& shared) {
    const fs::path copy = shared.parent_path() / exercise.file_name();
    if (copy != source) fs::copy_file(source, copy);
    const Descriptor out = open_file(shared, O_WRONLY | O_NOFOLLOW);
    let_others_read(shared.parent_path(), {copy});
    if (isolation_ == Isolation::landlock)
        make_scratch(scratch_beside(copy), stage_, slot_);
    const Descriptor filter = open_file(stage_.compile_filter(), O_RDONLY);
    const Descriptor status = course::anonymous_file();
    course::Command command = compile_step(isolation_, stage_, exercise, copy);
    command.descriptors = {
        {out.get(), 3}, {status.get(), 8}, {filter.get(), 9}};
    std::optional<ControlGroup> group;
    enter(command, "compile", compiling, group);
    const course::Finished finished = course::run(
        command, course::compiler_patience, course::most_compiler_output);
    group.reset();
    if (!finished.timed_out && !has_started(isolation_, finished, status))
        return {course::Verdict::grader_fault,
                "the compile sandbox did not start: " + finished.output};
    return course::compiled_from(finished, course::compiler_patience);
}

course::Process Sandbox::launch(const fs::path& shared,
                                const course::Limits& limits,
                                const Descriptor& control,
                                const Descriptor& complaints) {
    // The same file that compile fills: it is shown inside before that.
    open_file(shared, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    let_others_read(shared.parent_path(), {shared});
    const Descriptor filter = open_file(stage_.compile_filter(), O_RDONLY);
    const Descriptor strict = open_file(stage_.worker_filter(), O_RDONLY);
    course::Command command = run_step(isolation_, stage_, slot_, shared);
    command.descriptors = {{complaints.get(), 2},
                           {control.get(), 3},
                           {strict.get(), 4},
                           {filter.get(), 9}};
    command.processor = processor();
    enter(command, "run", running(limits), group_);
    return course::Process(command);
}

void Sandbox::enter(course::Command& command, const char* step,
                    const StepLimits& limits,
                    std::optional<ControlGroup>& group) {
    group.emplace(stage_.groups(), fmt::format("{}-{}", step, slot_),
                  limits.group_mib, limits.processes);
    const Arguments before = entering(stage_, slot_, limits, group);
    command.arguments.insert(command.arguments.begin(), before.begin(),
                             before.end());
}

std::unique_ptr<course::Workplace> workplace(Isolation isolation,
                                             const Stage& stage, int slot) {
    if (isolation == Isolation::none)
        return std::make_unique<course::LocalWorkplace>();
    return std::make_unique<Sandbox>(isolation, stage, slot);
}

}  // namespace grader

#include "grader/sandbox/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <tuple>
#include <utility>

#include "course/runner/compile.h"
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

/// For the user of the lane, who is not the grader's.
void let_others_read(const fs::path& folder,
                     const std::vector<fs::path>& files) {
    fs::permissions(folder, fs::perms(0711));
    for (const fs::path& file : files) fs::permissions(file, fs::perms(0644));
}

/// Paths in the output of the loader's own listing of a program's libraries.
std::vector<std::string> libraries_of(const fs::path& program) {
    course::Command command;
    command.arguments = {"ldd", program};
    command.environment = course::plain_environment();
    const course::Finished listed =
        course::run(command, std::chrono::seconds(10), 65536);
    std::vector<std::string> found;
    std::istringstream words(listed.output);
    for (std::string word; words >> word;)
        if (word.front() == '/') found.push_back(word);
    if (listed.status != 0 || found.empty())
        throw course::SystemError("ldd does not say what the worker needs");
    return found;
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
        if (!file) course::throw_errno("cannot open " + name);
        if (::flock(file.get(), LOCK_EX | LOCK_NB) == 0)
            return {std::move(file), first_block + block * block_size};
    }
    throw course::SystemError(
        fmt::format("{} graders are running on this machine already", blocks));
}

/// Root keeps its power in a namespace: each lane gets a user of its own, whose
/// count of processes is its own, too.
Arguments as_user(const Stage& stage, int slot) {
    if (::geteuid() != 0) return {};
    const std::string user = std::to_string(stage.first_user() + slot);
    return {"setpriv",        "--reuid=" + user, "--regid=" + user,
            "--clear-groups", "--no-new-privs",  "--"};
}

struct StepLimits {
    int cpu_seconds;
    int memory_mib;  ///< of address space; 0: none here
    int file_mib;
    int processes;
};

Arguments limited(const StepLimits& limits) {
    Arguments list = {"prlimit", "--core=0", "--nofile=128",
                      fmt::format("--fsize={}", limits.file_mib << 20)};
    // Counted by user: of an ordinary user it would count the whole desktop.
    if (::geteuid() == 0)
        list.push_back(fmt::format("--nproc={}", limits.processes));
    if (limits.cpu_seconds > 0)
        list.push_back(fmt::format("--cpu={}", limits.cpu_seconds));
    if (limits.memory_mib > 0)
        list.push_back(
            fmt::format("--as={}", std::int64_t{limits.memory_mib} << 20));
    list.push_back("--");
    return list;
}

/// Namespaces of its own for everything, nobody inside, no way up. The command
/// is the first process inside: bubblewrap would put one of its own there, does
/// not wait for its end, and in a container nobody may collect it.
Arguments bubblewrap() {
    return {"bwrap",
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
            "--new-session",
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

/// Root file system of the run step: worker, its libraries, the submission.
Arguments run_mounts(const Stage& stage) {
    Arguments list = read_only(stage.worker(), "/worker");
    for (const std::string& library : stage.libraries())
        append(list, read_only(fs::canonical(library), library));
    return list;
}

/// Root file system of the compile step: compiler, system headers, contracts.
Arguments compile_mounts(const Stage& stage) {
    Arguments list;
    for (const char* folder :
         {"/usr/bin", "/usr/lib", "/usr/include", "/usr/lib64", "/usr/libexec"})
        if (fs::exists(folder)) append(list, read_only(folder, folder));
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

std::string shell_words(const Arguments& arguments) {
    // All of them are ours; none holds a quote.
    std::string line;
    for (const std::string& argument : arguments)
        line += fmt::format("'{}' ", argument);
    return line;
}

/// Compile, link, and hand the result out by descriptor 3.
std::string compile_script(const course::Exercise& exercise) {
    const auto compile = course::compile_arguments(
        exercise.file_name(), "/tmp/s.o", "/student/include");
    const auto link = course::link_arguments(
        "/tmp/s.o", fmt::format("/student/entries/{}.o", exercise.name),
        "/tmp/s.so");
    return shell_words(compile) + "&& " + shell_words(link) +
           "&& cat /tmp/s.so >&3";
}

/// bubblewrap writes the exit code of the command only if it got that far.
bool got_that_far(const Descriptor& status_file) {
    std::string text(4096, '\0');
    const ssize_t n = ::pread(status_file.get(), text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    return text.find("\"exit-code\"") != std::string::npos;
}

}  // namespace

Stage::Stage() {
    const fs::path build = course::build_root();
    fs::permissions(folder_.path(), fs::perms(0755));
    fs::copy_file(build / "grader" / "grader_worker", worker());
    fs::copy(build / "student", student(), fs::copy_options::recursive);
    write_file(compile_filter(), grader::compile_filter());
    write_file(worker_filter(), grader::worker_filter());
    libraries_ = libraries_of(worker());
    if (::geteuid() == 0) std::tie(user_lock_, first_user_) = lock_users();
}

Probe probe(const Stage& stage) {
    course::Command command;
    command.arguments = as_user(stage, 0);
    append(command.arguments, bubblewrap());
    append(command.arguments, run_mounts(stage));
    append(command.arguments,
           {"--remount-ro", "/", "--", "/worker", "--probe"});
    command.environment = course::plain_environment();
    try {
        const course::Finished tried =
            course::run(command, std::chrono::seconds(10), 4096);
        if (tried.status == 0 && tried.output == "ready\n")
            return {Isolation::bubblewrap, ""};
        return {Isolation::none, tried.output};
    } catch (const course::SystemError& error) {
        return {Isolation::none, error.what()};
    }
}

course::Compiled Sandbox::compile(const course::Exercise& exercise,
                                  const fs::path& source,
                                  const fs::path& shared) {
    const Descriptor filter = open_file(stage_.compile_filter(), O_RDONLY);
    const fs::path copy = shared.parent_path() / exercise.file_name();
    fs::copy_file(source, copy);
    const Descriptor out =
        open_file(shared, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    let_others_read(shared.parent_path(), {copy, shared});
    const Descriptor status = course::anonymous_file();
    course::Command command;
    command.environment = course::plain_environment();
    command.arguments = as_user(stage_, slot_);
    append(command.arguments, limited({10, 2048, 32, 32}));
    append(command.arguments, bubblewrap());
    append(command.arguments, compile_mounts(stage_));
    append(command.arguments, read_only(copy, "/src/" + exercise.file_name()));
    append(command.arguments, {"--remount-ro", "/", "--chdir", "/src",
                               "--seccomp", "9", "--json-status-fd", "8", "--",
                               "/bin/sh", "-c", compile_script(exercise)});
    command.descriptors = {
        {out.get(), 3}, {status.get(), 8}, {filter.get(), 9}};
    const course::Finished finished = course::run(
        command, course::compiler_patience, course::most_compiler_output);
    if (!finished.timed_out && !got_that_far(status))
        return {course::Verdict::grader_fault,
                "the compile sandbox did not start: " + finished.output};
    return course::compiled_from(finished, course::compiler_patience);
}

course::Process Sandbox::launch(const fs::path& shared,
                                const Descriptor& control,
                                const Descriptor& complaints) {
    const Descriptor filter = open_file(stage_.compile_filter(), O_RDONLY);
    const Descriptor strict = open_file(stage_.worker_filter(), O_RDONLY);
    course::Command command;
    command.environment = course::plain_environment();
    command.arguments = as_user(stage_, slot_);
    append(command.arguments, limited({0, 0, 32, 16}));
    append(command.arguments, bubblewrap());
    append(command.arguments, run_mounts(stage_));
    append(command.arguments, read_only(shared, "/submission.so"));
    append(command.arguments, {"--remount-ro", "/", "--chdir", "/", "--seccomp",
                               "9", "--", "/worker", "/submission.so"});
    command.descriptors = {{complaints.get(), 2},
                           {control.get(), 3},
                           {strict.get(), 4},
                           {filter.get(), 9}};
    return course::Process(command);
}

std::unique_ptr<course::Workplace> workplace(Isolation isolation,
                                             const Stage& stage, int slot) {
    if (isolation == Isolation::bubblewrap)
        return std::make_unique<Sandbox>(stage, slot);
    return std::make_unique<course::LocalWorkplace>();
}

}  // namespace grader

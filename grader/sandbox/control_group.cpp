#include "grader/sandbox/control_group.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "course/runner/descriptors.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using Kind = GroupFolder::Kind;

const std::string prefix = "half-edge-grader-";

/// The files of a control group take one write, and refuse by its result.
bool write_to(const fs::path& file, const std::string& text) {
    const course::Descriptor fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    return fd && ::write(fd.get(), text.data(), text.size()) ==
                     static_cast<ssize_t>(text.size());
}

// ---- where the hierarchies are mounted, and where we stand in them

struct Mount {
    std::string root, point, type, options;
};

std::vector<Mount> group_mounts() {
    std::vector<Mount> found;
    std::ifstream in("/proc/self/mountinfo");
    for (std::string line; std::getline(in, line);) {
        Mount mount;
        std::string ignored;
        std::istringstream words(line);
        words >> ignored >> ignored >> ignored >> mount.root >> mount.point;
        while (words >> ignored && ignored != "-") continue;
        words >> mount.type >> ignored >> mount.options;
        if (mount.type == "cgroup" || mount.type == "cgroup2")
            found.push_back(mount);
    }
    return found;
}

bool lists(const std::string& words, const std::string& word) {
    return ("," + words + ",").find("," + word + ",") != std::string::npos;
}

/// Our path in the hierarchy with this controller; "" is that of version 2.
std::string own_path(const std::string& controller) {
    std::ifstream in("/proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string listed = line.substr(first + 1, second - first - 1);
        if (controller.empty() ? listed.empty() : lists(listed, controller))
            return line.substr(second + 1);
    }
    return "/";
}

/// Where a group of ours may be made: below our own, so that what holds for us
/// holds for it, or else at the top.
std::vector<fs::path> parents(const Mount& mount,
                              const std::string& controller) {
    std::string path = own_path(controller);
    if (mount.root != "/" && path.rfind(mount.root, 0) == 0)
        path.erase(0, mount.root.size());
    return {fs::path(mount.point + path).lexically_normal(), mount.point};
}

/// A grader that was killed leaves empty groups behind, one in the other.
void remove_stale(const fs::path& parent) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(parent, ignored)) {
        const std::string name = entry.path().filename();
        if (name.rfind(prefix, 0) != 0) continue;
        int pid = 0;
        const char* digits = name.c_str() + prefix.size();
        std::from_chars(digits, name.c_str() + name.size(), pid);
        if (pid <= 0 || ::kill(pid, 0) == 0 || errno != ESRCH) continue;
        std::vector<fs::path> inner;
        for (const auto& one : fs::directory_iterator(entry.path(), ignored))
            if (one.is_directory(ignored)) inner.push_back(one.path());
        for (const fs::path& folder : inner) ::rmdir(folder.c_str());
        ::rmdir(entry.path().c_str());
    }
}

/// A folder of our own in the first parent that takes it; empty when none does.
fs::path make_own(int number, const std::vector<fs::path>& candidates,
                  const std::vector<std::string>& wanted_files) {
    for (const fs::path& parent : candidates) {
        remove_stale(parent);
        const fs::path own =
            parent / fmt::format("{}{}-{}", prefix, ::getpid(), number);
        if (::mkdir(own.c_str(), 0755) != 0 && errno != EEXIST) continue;
        bool usable = true;
        for (const std::string& file : wanted_files)
            usable = usable && ::access((own / file).c_str(), W_OK) == 0;
        if (usable) return own;
        ::rmdir(own.c_str());
    }
    return {};
}

/// Version 2 hands a controller down only from a group that holds no process.
fs::path make_own_v2(int number, const Mount& mount) {
    for (const fs::path& parent : parents(mount, "")) {
        write_to(parent / "cgroup.subtree_control", "+memory +pids");
        const fs::path own =
            make_own(number, {parent}, {"memory.max", "pids.max"});
        if (own.empty()) continue;
        if (write_to(own / "cgroup.subtree_control", "+memory +pids"))
            return own;
        ::rmdir(own.c_str());
    }
    return {};
}

// ---- one group

struct Limit {
    const char* file;
    std::string value;
    bool may_be_missing = false;
};

std::vector<Limit> limits_of(Kind kind, int memory_mib, int processes) {
    const std::string bytes = std::to_string(std::int64_t{memory_mib} << 20);
    const std::string count = std::to_string(processes);
    switch (kind) {
        case Kind::v2:
            return {{"memory.max", bytes},
                    {"memory.swap.max", "0", true},
                    {"pids.max", count}};
        case Kind::v1_memory:
            return {{"memory.limit_in_bytes", bytes},
                    {"memory.memsw.limit_in_bytes", bytes, true}};
        case Kind::v1_processes:
            return {{"pids.max", count}};
    }
    return {};
}

void kill_members(const fs::path& folder) {
    if (write_to(folder / "cgroup.kill", "1")) return;
    std::ifstream in(folder / "cgroup.procs");
    for (int pid = 0; in >> pid;) ::kill(pid, SIGKILL);
}

/// A group can be removed when the last process in it is gone; a kill takes a
/// moment. What cannot be removed is empty and goes with the next grader.
void end_group(const fs::path& folder) {
    constexpr int most = 200;
    for (int k = 0; k < most; ++k) {
        if (::rmdir(folder.c_str()) == 0 || errno == ENOENT) return;
        kill_members(folder);
        std::this_thread::sleep_for(std::chrono::milliseconds(k < 20 ? 1 : 10));
    }
}

}  // namespace

ControlGroups::ControlGroups() {
    static std::atomic<int> made = 0;
    const int number = ++made;  // a process may have several, in its tests
    for (const Mount& mount : group_mounts()) {
        fs::path own;
        if (mount.type == "cgroup2") {
            own = make_own_v2(number, mount);
            if (!own.empty()) folders_ = {{Kind::v2, own}};
            if (!own.empty()) return;
        } else if (lists(mount.options, "memory")) {
            own = make_own(number, parents(mount, "memory"),
                           {"memory.limit_in_bytes"});
            if (!own.empty()) folders_.push_back({Kind::v1_memory, own});
        } else if (lists(mount.options, "pids")) {
            // The top has no limit of its own; a group in it has.
            own = make_own(number, parents(mount, "pids"), {"pids.max"});
            if (!own.empty()) folders_.push_back({Kind::v1_processes, own});
        }
    }
}

ControlGroups::~ControlGroups() {
    for (const GroupFolder& group : folders_) ::rmdir(group.folder.c_str());
}

std::string ControlGroups::text() const {
    std::string what;
    for (const GroupFolder& group : folders_) {
        if (group.kind == Kind::v2) return "cgroup v2: memory, processes";
        what += what.empty() ? "cgroup v1: " : ", ";
        what += group.kind == Kind::v1_memory ? "memory" : "processes";
    }
    return what.empty() ? "no cgroup" : what;
}

ControlGroup::ControlGroup(const ControlGroups& all, const std::string& name,
                           int memory_mib, int processes) {
    for (const GroupFolder& group : all.folders()) {
        const fs::path folder = group.folder / name;
        if (::mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST)
            course::throw_errno("cannot make the group " + folder.string());
        folders_.push_back(folder);
        for (const Limit& limit : limits_of(group.kind, memory_mib, processes))
            if (!write_to(folder / limit.file, limit.value) &&
                !limit.may_be_missing)
                course::throw_errno("cannot set " +
                                    (folder / limit.file).string());
    }
}

ControlGroup::~ControlGroup() {
    for (const fs::path& folder : folders_) end_group(folder);
}

std::vector<fs::path> ControlGroup::members() const {
    std::vector<fs::path> files;
    for (const fs::path& folder : folders_)
        files.push_back(folder / "cgroup.procs");
    return files;
}

}  // namespace grader

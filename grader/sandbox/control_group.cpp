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

/// A blank and the like stand there as \040, in octal digits.
std::string unescaped(const std::string& word) {
    std::string plain;
    for (std::size_t k = 0; k < word.size(); ++k) {
        if (word[k] == '\\' && k + 3 < word.size()) {
            plain +=
                static_cast<char>(std::stoi(word.substr(k + 1, 3), nullptr, 8));
            k += 3;
        } else {
            plain += word[k];
        }
    }
    return plain;
}

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
        if (mount.type != "cgroup" && mount.type != "cgroup2") continue;
        mount.root = unescaped(mount.root);
        mount.point = unescaped(mount.point);
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
/// holds for it, or else as near to it as may be. In a namespace of groups our
/// own may be out of sight (".."); then only the top is left.
std::vector<fs::path> parents(const Mount& mount,
                              const std::string& controller) {
    const fs::path path =
        fs::path(own_path(controller)).lexically_relative(mount.root);
    std::vector<fs::path> found = {mount.point};
    if (path.empty() || *path.begin() == "..") return found;
    for (const fs::path& name : path) {
        if (name.string().rfind(prefix, 0) == 0) break;  // made by us
        if (name != ".") found.insert(found.begin(), found.front() / name);
    }
    return found;
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
        fs::path own =
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

// ---- version 2 hands controllers down only from a group without processes

bool hand_down(const fs::path& group) {
    return write_to(group / "cgroup.subtree_control", "+memory +pids");
}

bool holds_only_us(const fs::path& group) {
    std::ifstream in(group / "cgroup.procs");
    int first = 0, second = 0;
    return in >> first && first == ::getpid() && !(in >> second);
}

fs::path leaf_of(const fs::path& group) {
    return group / fmt::format("{}{}-self", prefix, ::getpid());
}

/// Undoes step_down. While another part of ours needs it, nothing happens.
void step_up(const fs::path& group) {
    const fs::path leaf = leaf_of(group);
    if (holds_only_us(leaf)) {
        write_to(group / "cgroup.subtree_control", "-memory -pids");
        write_to(group / "cgroup.procs", "0");  // refused while they are needed
    }
    ::rmdir(leaf.c_str());
}

/// Makes room by moving this process into a leaf, as systemd expects it of
/// those it delegates a group to.
void step_down(const fs::path& group) {
    const fs::path leaf = leaf_of(group);
    if (::mkdir(leaf.c_str(), 0755) != 0 && errno != EEXIST) return;
    if (!write_to(leaf / "cgroup.procs", "0") || !hand_down(group))
        step_up(group);
}

fs::path make_own_v2(int number, const Mount& mount) {
    for (const fs::path& parent : parents(mount, "")) {
        // To join from a group beside it, a step must be let write here, too.
        if (::access((parent / "cgroup.procs").c_str(), W_OK) != 0) continue;
        if (!hand_down(parent) && errno == EBUSY && holds_only_us(parent))
            step_down(parent);
        fs::path own = make_own(number, {parent}, {"memory.max", "pids.max"});
        if (!own.empty() && hand_down(own)) return own;
        if (!own.empty()) ::rmdir(own.c_str());
        step_up(parent);
    }
    return {};
}

// ---- version 1 has a hierarchy for each controller

struct Controller {
    Kind kind;
    const char* name;
    const char* limit;  // the top has none, a group in it has
};

constexpr Controller version_1[] = {
    {Kind::v1_memory, "memory", "memory.limit_in_bytes"},
    {Kind::v1_processes, "pids", "pids.max"}};

bool has(const std::vector<GroupFolder>& folders, Kind kind) {
    for (const GroupFolder& group : folders)
        if (group.kind == kind) return true;
    return false;
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
    for (int pid = 0; in >> pid;)
        if (pid > 0) ::kill(pid, SIGKILL);  // 0: of a namespace above
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
        if (mount.type == "cgroup2") {
            const fs::path own = make_own_v2(number, mount);
            if (own.empty()) continue;
            folders_ = {{Kind::v2, own}};
            return;
        }
        for (const Controller& one : version_1) {
            if (!lists(mount.options, one.name) || has(folders_, one.kind))
                continue;
            const fs::path own =
                make_own(number, parents(mount, one.name), {one.limit});
            if (!own.empty()) folders_.push_back({one.kind, own});
        }
    }
}

ControlGroups::~ControlGroups() {
    for (const GroupFolder& group : folders_) {
        ::rmdir(group.folder.c_str());
        if (group.kind == Kind::v2) step_up(group.folder.parent_path());
    }
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
                           int memory_mib, int processes)
    : ControlGroup() {  // from here on, a throw ends what has been made
    for (const GroupFolder& group : all.folders()) {
        const fs::path folder = group.folder / name;
        if (::mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST)
            course::throw_errno("cannot make the group " + folder.string());
        folders_.push_back({group.kind, folder});
        for (const Limit& limit : limits_of(group.kind, memory_mib, processes))
            if (!write_to(folder / limit.file, limit.value) &&
                !limit.may_be_missing)
                course::throw_errno("cannot set " +
                                    (folder / limit.file).string());
    }
}

ControlGroup::~ControlGroup() {
    for (const GroupFolder& group : folders_) end_group(group.folder);
}

/// Version 1 lets a thread join, and waits for no other process then; when a
/// process joins it does, for 10 to 20 ms.
std::vector<fs::path> ControlGroup::members() const {
    std::vector<fs::path> files;
    for (const GroupFolder& group : folders_)
        files.push_back(group.folder /
                        (group.kind == Kind::v2 ? "cgroup.procs" : "tasks"));
    return files;
}

}  // namespace grader

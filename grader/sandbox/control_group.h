// Control groups of Linux, version 1 or 2, where this machine lets us make
// them: limits on the memory and the processes of a whole step, beside those
// on each process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// One folder of control groups, and what its files are called.
struct GroupFolder {
    enum class Kind { v2, v1_memory, v1_processes };
    Kind kind;
    std::filesystem::path folder;
};

/// The grader's own part of the hierarchies; gone with its owner. What killed
/// graders left is removed on the way.
class ControlGroups {
public:
    /// Finds what there is; none is no error. Version 2 may move this process
    /// into a group below its own for as long as the object lives.
    ControlGroups();
    ~ControlGroups();
    ControlGroups(const ControlGroups&) = delete;
    ControlGroups& operator=(const ControlGroups&) = delete;

    /// Memory and processes, version 2; or one folder for each, version 1;
    /// empty where neither may be used.
    const std::vector<GroupFolder>& folders() const { return folders_; }

    /// "cgroup v1: memory, processes", or "no cgroup".
    std::string text() const;

private:
    std::vector<GroupFolder> folders_;
};

/// The group of one step. On its end, what still runs in it is killed.
class ControlGroup {
public:
    /// Throws SystemError when a limit cannot be set. `name` is unique among
    /// those that live.
    ControlGroup(const ControlGroups& all, const std::string& name,
                 int memory_mib, int processes);
    ~ControlGroup();
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;

    /// A process of one thread joins by writing "0" to each of these.
    std::vector<std::filesystem::path> members() const;

private:
    ControlGroup() = default;

    std::vector<GroupFolder> folders_;
};

}  // namespace grader

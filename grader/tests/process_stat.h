// What the system says of a process of this machine.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace grader::tests {

/// Fields of /proc/N/stat. (proc(5))
struct ProcessStat {
    std::string name;
    char state = 0;  ///< Z: it has ended, and nobody has asked how
    pid_t parent = 0;
    long long started = 0;  ///< in ticks of the system's clock
};

/// `folder` is /proc/N; nothing when there is no such process, or no more.
inline std::optional<ProcessStat> process_stat(
    const std::filesystem::path& folder) {
    std::string line;
    std::ifstream file(folder / "stat");
    std::getline(file, line);
    // The name stands in brackets, and may hold any.
    const auto begin = line.find('('), end = line.rfind(')');
    if (end == line.npos) return std::nullopt;
    ProcessStat stat;
    stat.name = line.substr(begin + 1, end - begin - 1);
    std::istringstream rest(line.substr(end + 1));
    std::string ignored;
    rest >> stat.state >> stat.parent;
    for (int field = 5; field < 22; ++field) rest >> ignored;
    rest >> stat.started;
    return stat;
}

}  // namespace grader::tests

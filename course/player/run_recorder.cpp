#include "course/player/run_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "course/runner/codec.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"

namespace course {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{40};
constexpr std::size_t most_output = 4096;
constexpr int most_deaths = 4;

std::string read_if_there(const fs::path& file) {
    return fs::exists(file) ? read_file(file) : "";
}

/// The part of the recorder's file that was written whole.
void read_recording(const std::string& bytes, Recorded& recorded) {
    constexpr const char* kinds[] = {"", "half-edge", "vertex"};
    Reader in(bytes);
    try {
        Reader head(in.take(in.count(1)));
        const auto kind = get<std::uint32_t>(head);
        recorded.start_kind = kinds[kind < 3 ? kind : 0];
        recorded.starts = get<std::vector<int>>(head);
        while (in.left() > 0)
            recorded.calls.push_back({std::string(in.take(in.count(1))), ""});
    } catch (const CodecError&) {
        // It ended in the middle of a call.
    }
}

Command recorder_command(const RecorderFiles& files, const fs::path& order,
                         const fs::path& recording) {
    Command command;
    command.arguments = {build_root() / "course" / "course_recorder",
                         files.shared, order, recording};
    command.environment = plain_environment();
    return command;
}

/// gdb takes most of the time of a recording: a line or two for each step, as
/// long as all walks together have no more steps than a page takes.
std::uint64_t most_lines(const RecordOrder& order) {
    const std::uint64_t walks =
        order.starts.empty() ? order.rows.size() : order.starts.size();
    return std::clamp(12 * order.most / (walks + 1), order.most / 4,
                      2 * order.most);
}

Command under_gdb(Command command, const RecorderFiles& files,
                  const fs::path& locals, std::uint64_t most) {
    const fs::path script = source_root() / "course" / "player" / "locals.py";
    const std::vector<std::string> gdb = {"gdb", "-batch", "-nx",
                                          "-x",  script,   "--args"};
    command.arguments.insert(command.arguments.begin(), gdb.begin(), gdb.end());
    for (const std::string& setting : {"COURSE_FILE=" + files.source.string(),
                                       "COURSE_LOCALS=" + locals.string(),
                                       fmt::format("COURSE_MOST={}", most)})
        command.environment.push_back(setting);
    return command;
}

/// One run of the recorder, to its end.
Recorded run_once(const RecorderFiles& files, const RecordOrder& order,
                  Watched watched) {
    const fs::path order_file = files.folder / "order";
    const fs::path recording = files.folder / "recording";
    const fs::path locals = files.folder / "locals";
    fs::remove(recording);
    fs::remove(locals);
    std::ofstream(order_file, std::ios::binary) << encode(order);
    Command command = recorder_command(files, order_file, recording);
    if (watched == Watched::table_and_locals)
        command =
            under_gdb(std::move(command), files, locals, most_lines(order));
    Recorded recorded;
    recorded.complaint = run(std::move(command), patience, most_output).output;
    read_recording(read_if_there(recording), recorded);
    recorded.lines = read_lines_reached(read_if_there(locals));
    return recorded;
}

/// The calls of a later run follow those of the earlier ones.
void append(Recorded& all, Recorded more) {
    all.lines.resize(all.calls.size());
    std::move(more.calls.begin(), more.calls.end(),
              std::back_inserter(all.calls));
    std::move(more.lines.begin(), more.lines.end(),
              std::back_inserter(all.lines));
}

}  // namespace

Recorded run_recorder(const RecorderFiles& files, RecordOrder order,
                      Watched watched) {
    Recorded all = run_once(files, order, watched);
    for (int deaths = 1; all.calls.size() < all.starts.size(); ++deaths) {
        all.calls.push_back(
            {"",
             "the call ended the whole program, and what was recorded of "
             "it is lost"});
        if (deaths == most_deaths)
            all.calls.resize(all.starts.size(),
                             {"",
                              "not called: calls before it have ended the "
                              "whole program"});
        order.done = static_cast<std::uint32_t>(all.calls.size());
        if (order.done < all.starts.size())
            append(all, run_once(files, order, watched));
    }
    return all;
}

}  // namespace course

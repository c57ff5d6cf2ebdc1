#include "course/cli/live.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include "course/report/compiler_messages.h"

namespace course {

namespace {

// The only thing that a signal's handler can reach.
int told_to_stop = -1;

extern "C" void on_stop(int /*signal*/) {
    [[maybe_unused]] const auto written = ::write(told_to_stop, "x", 1);
}

/// While it lives, Ctrl-C and SIGTERM make its descriptor readable; a second
/// one ends the program, as it would without this.
class StopSignals {
public:
    StopSignals() : pipe_(pipe_pair()) {
        told_to_stop = pipe_.second.get();
        struct sigaction action {};
        action.sa_handler = on_stop;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        ::sigaction(SIGINT, &action, &interrupted_);
        ::sigaction(SIGTERM, &action, &terminated_);
    }
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals() {
        ::sigaction(SIGINT, &interrupted_, nullptr);
        ::sigaction(SIGTERM, &terminated_, nullptr);
    }

    int get() const { return pipe_.first.get(); }

private:
    DescriptorPair pipe_;
    struct sigaction interrupted_ {};
    struct sigaction terminated_ {};
};

/// Of its place, "walk.cpp:12:5".
std::string line_of(const CompilerMessage& message) {
    const std::string file_and_line =
        message.place.substr(0, message.place.rfind(':'));
    return file_and_line.substr(file_and_line.rfind(':') + 1);
}

void make_anew(PageServer& server, const MakePage& make) {
    try {
        server.show(make());
    } catch (const std::exception& error) {
        server.complain(large_sentence(error.what()));
    }
}

}  // namespace

bool wait_for_save(FileWatch& file, int stop) {
    // Editors save in several steps, and some files are written in pieces.
    constexpr std::chrono::milliseconds rest{40};
    bool changed = false;
    while (true) {
        const auto patience = changed ? rest : file.patience();
        std::array<pollfd, 2> waits{pollfd{stop, POLLIN, 0},
                                    pollfd{file.descriptor(), POLLIN, 0}};
        ::poll(waits.data(), waits.size(), static_cast<int>(patience.count()));
        if (waits[0].revents != 0) return false;
        const bool changes = file.has_changed();
        if (changed && !changes && waits[1].revents == 0) return true;
        changed = changed || changes;
    }
}

std::string large_sentence(const std::string& messages) {
    const std::vector<CompilerMessage> all = compiler_messages(messages);
    if (all.empty() || !all.front().is_error)
        return messages.substr(0, messages.find('\n'));
    return fmt::format("line {}: {}", line_of(all.front()), all.front().text);
}

void follow(FileWatch& file, PageServer& server, const MakePage& make,
            int stop) {
    do {
        make_anew(server, make);
    } while (wait_for_save(file, stop));
}

int live(const std::filesystem::path& file, int port, const MakePage& make) {
    const StopSignals stop;
    FileWatch watch(file);
    PageServer server(port);
    fmt::print(
        "Open this in a browser on this machine:\n  {}\nIt follows {}: save "
        "the file, and the page shows it. Ctrl-C ends it.\n",
        server.address(), file.string());
    std::fflush(stdout);
    follow(watch, server, make, stop.get());
    fmt::print("\n");
    return 0;
}

}  // namespace course

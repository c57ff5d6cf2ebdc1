#include "course/cli/terminal.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "course/runner/descriptors.h"

namespace course {

namespace {

// The other screen, no cursor; and back. DEC private modes 1049 and 25.
constexpr std::string_view enter_screen = "\033[?1049h\033[?25l";
constexpr std::string_view leave_screen = "\033[?25h\033[?1049l";

constexpr std::array<int, 4> watched = {SIGWINCH, SIGTERM, SIGHUP, SIGINT};

/// Signals write their number into a pipe.
DescriptorPair& signal_pipe() {
    static DescriptorPair pipe = [] {
        DescriptorPair made = pipe_pair();
        for (const int fd : {made.first.get(), made.second.get()})
            ::fcntl(fd, F_SETFL, O_NONBLOCK);
        return made;
    }();
    return pipe;
}

int to_signal_pipe = -1;

extern "C" void course_note_signal(int number) {
    const int error = errno;
    const char byte = static_cast<char>(number);
    [[maybe_unused]] const ssize_t n = ::write(to_signal_pipe, &byte, 1);
    errno = error;
}

void write_out(std::string_view bytes) {
    write_all(1, bytes.data(), bytes.size());
}

/// The key of an escape sequence that begins with "\033["; 0 for others.
int key_of(std::string_view sequence) {
    constexpr std::array<std::pair<std::string_view, int>, 6> known = {
        {{"A", key_up},
         {"B", key_down},
         {"5~", key_page_up},
         {"6~", key_page_down},
         {"H", key_page_up},
         {"F", key_page_down}}};
    for (const auto& [text, key] : known)
        if (sequence == text) return key;
    return 0;
}

}  // namespace

std::vector<int> keys_in(std::string_view bytes) {
    std::vector<int> keys;
    while (!bytes.empty()) {
        if (bytes.starts_with("\033[") || bytes.starts_with("\033O")) {
            std::size_t end = 2;
            while (end < bytes.size() && (bytes[end] < 0x40)) ++end;
            end = std::min(end + 1, bytes.size());
            if (const int key = key_of(bytes.substr(2, end - 2)); key != 0)
                keys.push_back(key);
            bytes.remove_prefix(end);
            continue;
        }
        const char c = bytes[0];
        keys.push_back(c == '\r'   ? static_cast<int>(key_enter)
                       : c == '\b' ? static_cast<int>(key_backspace)
                                   : static_cast<unsigned char>(c));
        bytes.remove_prefix(1);
    }
    return keys;
}

bool Terminal::is_there() {
    const char* kind = std::getenv("TERM");
    return ::isatty(0) == 1 && ::isatty(1) == 1 && kind != nullptr &&
           std::string_view(kind) != "dumb" && *kind != '\0';
}

Terminal::Terminal() {
    if (::tcgetattr(0, &before_) != 0) throw_errno("tcgetattr");
    to_signal_pipe = signal_pipe().second.get();
    for (const int number : watched) std::signal(number, course_note_signal);
    take();
}

Terminal::~Terminal() {
    give_back();
    for (const int number : watched) std::signal(number, SIG_DFL);
}

void Terminal::take() {
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG | IEXTEN);
    raw.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    ::tcsetattr(0, TCSAFLUSH, &raw);
    write_out(enter_screen);
}

void Terminal::give_back() {
    write_out(leave_screen);
    ::tcsetattr(0, TCSAFLUSH, &before_);
}

ScreenSize Terminal::size() const {
    winsize window{};
    if (::ioctl(1, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) return {};
    return {window.ws_col, window.ws_row};
}

int Terminal::signals() const {
    return signal_pipe().first.get();
}

std::vector<int> Terminal::read_keys() {
    char buffer[256];
    const ssize_t n = ::read(0, buffer, sizeof buffer);
    // poll said that there is something: nothing means that it is gone.
    if (n <= 0) return {key_end_of_input};
    return keys_in({buffer, static_cast<std::size_t>(n)});
}

bool Terminal::goes_on() {
    bool ends = false;
    char number = 0;
    while (::read(signals(), &number, 1) == 1)
        ends = ends || number != static_cast<char>(SIGWINCH);
    return !ends;
}

void Terminal::show(const std::vector<std::string>& lines) {
    // Line by line over what is there: nothing flickers.
    std::string bytes = "\033[H";
    for (std::size_t k = 0; k < lines.size(); ++k)
        bytes += (k > 0 ? "\r\n" : "") + lines[k] + "\033[0m\033[K";
    write_out(bytes + "\033[J");
}

int Terminal::run(const std::string& command, const std::string& file) {
    ::setenv("LAB_FILE", file.c_str(), 1);
    give_back();
    const int status = std::system(command.c_str());
    take();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Terminal::stop() {
    give_back();
    std::raise(SIGSTOP);
    take();
}

}  // namespace course

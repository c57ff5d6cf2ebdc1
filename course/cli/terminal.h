// The terminal that somebody sits at: single keys, whole screens. Plain ANSI
// and termios: a terminal library would be one more package on each student's
// machine, for a handful of escape sequences that every terminal knows.
#pragma once

#include <termios.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct ScreenSize {
    std::size_t columns = 80, lines = 24;
};

/// A key: a character, or one of these.
enum Key : int {
    key_enter = '\n',
    key_escape = 0x1B,
    key_backspace = 0x7F,
    key_up = 0x100,
    key_down,
    key_page_up,
    key_page_down,
    key_end_of_input,
};

/// The keys in what a terminal sent, in their order; other sequences are
/// passed over.
std::vector<int> keys_in(std::string_view bytes);

/// While it lives, keys come one by one and unseen, and the screen is ours;
/// what was there before comes back with its end, also when a signal ends the
/// process. At most one at a time.
class Terminal {
public:
    /// Whether input and output are terminals that can be used like this.
    static bool is_there();

    /// Throws SystemError.
    Terminal();
    ~Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    ScreenSize size() const;

    /// To be polled for input: keys, and word of signals.
    int keys() const { return 0; }
    int signals() const;

    /// What was typed; key_end_of_input when the terminal is gone.
    std::vector<int> read_keys();

    /// Forgets the word of signals; false when one asks this process to end.
    bool goes_on();

    /// Shows these lines and nothing else.
    void show(const std::vector<std::string>& lines);

    /// Runs a command of a shell, which has the terminal for itself; its exit
    /// code. The command finds `file`, any path, as $LAB_FILE.
    int run(const std::string& command, const std::string& file);

    /// Stops this process until it is continued, as Ctrl-Z does.
    void stop();

private:
    void take();
    void give_back();

    termios before_{};
};

}  // namespace course

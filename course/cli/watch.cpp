// lab without a command: watches the current exercise. At a terminal with
// single keys; else it prints each result, until its input ends.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <utility>

#include "course/cli/check.h"
#include "course/cli/commands.h"
#include "course/cli/lists.h"
#include "course/cli/progress.h"
#include "course/cli/rechecker.h"
#include "course/cli/terminal.h"
#include "course/cli/watch_page.h"
#include "course/player/record.h"
#include "course/runner/temporary_folder.h"

namespace course {

namespace {

/// The file has to be there to be watched.
void require_file(const Desk& desk, const Exercise& exercise) {
    if (!std::filesystem::exists(desk.file(exercise)))
        throw CannotBegin(fmt::format(
            "{} is missing: ./course/lab reset {} puts the original there",
            desk.file(exercise).string(), exercise.name));
}

int print_results(const Desk& desk) {
    const Exercise exercise = read_progress(desk).current_exercise();
    require_file(desk, exercise);
    print_statement(exercise);
    Rechecker rechecker(desk, exercise);
    for (bool input_ended = false; !input_ended || rechecker.is_running();) {
        std::vector<pollfd> list = rechecker.waits_for();
        if (!input_ended) list.push_back({0, POLLIN, 0});
        const std::vector<int> ready =
            wait_for(std::move(list), rechecker.patience());
        char dropped[256];
        if (std::count(ready.begin(), ready.end(), 0) > 0)
            input_ended = ::read(0, dropped, sizeof dropped) <= 0;
        if (!rechecker.step()) continue;
        fmt::print("{}\n", rechecker.outcome()->text);
        std::fflush(stdout);
    }
    return rechecker.outcome() ? rechecker.outcome()->code : 3;
}

class Watch {
public:
    explicit Watch(const Desk& desk) : desk_(desk) {
        go_to(read_progress(desk).current_exercise());
    }

    /// Until somebody quits; the exit code of the last check.
    int run() {
        draw();
        while (!quits_) {
            if (step()) draw();
        }
        const auto& outcome = rechecker_->outcome();
        return outcome ? outcome->code : 0;
    }

private:
    enum class Mode { exercise, list, all, reset };

    /// Waits for something to happen; true when there is something to show.
    bool step() {
        std::vector<pollfd> list = rechecker_->waits_for();
        list.push_back({terminal_.keys(), POLLIN, 0});
        list.push_back({terminal_.signals(), POLLIN, 0});
        if (all_) list.push_back({all_->descriptor(), POLLIN, 0});
        const auto phase = [&] {
            return std::pair(rechecker_->is_running(),
                             rechecker_->is_building());
        };
        const auto before = phase();
        const auto ready = wait_for(std::move(list), rechecker_->patience());
        const auto is_ready = [&](int fd) {
            return std::count(ready.begin(), ready.end(), fd) > 0;
        };
        bool is_new = is_ready(terminal_.signals());
        if (is_new && !terminal_.goes_on()) quits_ = true;
        if (is_ready(terminal_.keys())) {
            for (const int key : terminal_.read_keys()) press(key);
            is_new = true;
        }
        return advance() || is_new || phase() != before;
    }

    /// Takes what has ended; true when there is something to show.
    bool advance() {
        bool is_new = rechecker_->step();
        if (is_new) {
            // What was wrong is told from the beginning.
            if (mode_ == Mode::exercise) top_ = 0;
            note_.clear();
        }
        if (all_ && !all_ended_ && all_->has_ended()) {
            all_ended_ = true;
            is_new = true;
        }
        return is_new;
    }

    void draw() { terminal_.show(screen_of(page(), terminal_.size(), top_)); }

    Page page() {
        const ScreenSize size = terminal_.size();
        if (mode_ == Mode::list) return list_page(list_, size);
        if (mode_ == Mode::all)
            return text_page(
                all_ended_ ? "All that is begun" : "Checking all ...",
                all_->output(), " esc: back  q quit", size);
        if (mode_ == Mode::reset)
            return text_page(
                "Reset " + exercise().name,
                fmt::format("Put {} back to how it was handed out?\nYour file "
                            "is kept in {}.\n\n    y  yes\n    n  no\n",
                            desk_.file(exercise()).string(),
                            (desk_.memory() / "backup").string()),
                " y yes  n no", size);
        return exercise_page(
            {exercise(), statement_, desk_.file(exercise()).string(),
             read_progress(desk_), desk_.is_untouched(exercise()),
             rechecker_->is_running(), rechecker_->is_building(),
             rechecker_->outcome(), hints_, note_},
            size);
    }

    const Exercise& exercise() const { return rechecker_->exercise(); }

    void go_to(const Exercise& exercise) {
        require_file(desk_, exercise);
        change_progress(desk_, [&](Progress& progress) {
            progress.current = exercise.name;
        });
        statement_ = own_statement(exercise);
        rechecker_ = std::make_unique<Rechecker>(desk_, exercise);
        hints_ = 0;
        show(Mode::exercise);
    }

    void show(Mode mode) {
        mode_ = mode;
        top_ = 0;
        note_.clear();
    }

    void press(int key) {
        constexpr int control_c = 3, control_z = 26;
        if (key == control_c || key == key_end_of_input) quits_ = true;
        if (key == control_z) terminal_.stop();
        if (mode_ == Mode::list) return press_in_list(key);
        if (mode_ == Mode::reset) return answer_reset(key);
        if (key == 'q') quits_ = true;
        if (scroll(key)) return;
        if (mode_ == Mode::all && (key == key_escape || key == 'c'))
            return leave_all();
        if (mode_ == Mode::exercise) press_in_exercise(key);
    }

    bool scroll(int key) {
        const std::size_t page =
            std::max<std::size_t>(terminal_.size().lines, 8) - 6;
        const auto back = [&](std::size_t lines) {
            top_ -= std::min(top_, lines);
        };
        if (key == ' ' || key == key_page_down) return top_ += page, true;
        if (key == 'b' || key == key_page_up) return back(page), true;
        if (key == key_down) return ++top_, true;
        if (key == key_up) return back(1), true;
        return false;
    }

    void press_in_exercise(int key) {
        switch (key) {
            case 'n':
                return try_to([&] {
                    go_to(read_progress(desk_).next_after(exercise()));
                });
            case 'h':
                hints_ = std::min(hints_ + 1, statement_.hints.size());
                return show(Mode::exercise);
            case 'l':
                return open_list();
            case 'r':
                return replay();
            case 'c':
                return begin_all();
            case 'x':
                return show(Mode::reset);
            case 'o':
                return open_editor();
            default:
                return;
        }
    }

    /// What goes wrong is said, and watching goes on.
    template <class Work>
    void try_to(Work work) {
        try {
            work();
        } catch (const std::exception& error) {
            note_ = error.what();
        }
    }

    void open_list() {
        listed_ = all_listed(language());
        list_ = {};
        list_.progress = read_progress(desk_);
        find();
        show(Mode::list);
    }

    void find() {
        list_.found = found_by(list_.filter, listed_);
        const auto current = std::find_if(
            list_.found.begin(), list_.found.end(), [&](const Listed& one) {
                return one.exercise.name == exercise().name;
            });
        const bool is_there = current != list_.found.end();
        list_.selected =
            is_there ? static_cast<std::size_t>(current - list_.found.begin())
                     : 0;
    }

    void press_in_list(int key) {
        if (key == key_escape) return show(Mode::exercise);
        if (key == key_up && list_.selected > 0) --list_.selected;
        if (key == key_down && list_.selected + 1 < list_.found.size())
            ++list_.selected;
        if (key == key_enter && !list_.found.empty())
            return try_to([&] {
                mode_ = Mode::exercise;
                go_to(list_.found[list_.selected].exercise);
            });
        if (key == key_backspace && !list_.filter.empty())
            list_.filter.pop_back();
        else if (key >= ' ' && key < key_backspace)
            list_.filter += static_cast<char>(key);
        else
            return;
        find();
    }

    void begin_all() {
        all_ended_ = false;
        all_.emplace([this] { return check_all(desk_); });
        show(Mode::all);
    }

    void leave_all() {
        all_.reset();
        show(Mode::exercise);
    }

    void answer_reset(int key) {
        if (key != 'y' && key != 'n' && key != key_escape) return;
        show(Mode::exercise);
        if (key != 'y') return;
        try_to([&] {
            const auto kept = reset_exercise(desk_, exercise());
            hints_ = 0;
            if (kept) note_ = "Your file is now " + kept->string();
        });
    }

    /// Another command makes the replay, and has the terminal until it ends.
    void replay() {
        if (!can_be_shown(exercise())) {
            note_ = "No replay: it works without a half-edge table.";
            return;
        }
        std::filesystem::create_directories(desk_.memory());
        const std::string& name = exercise().name;
        const int code = terminal_.run(
            fmt::format("'{}' --work \"$LAB_FILE\" demo {} --open "
                        "--file \"$LAB_FILE\"/exercises/{}/{}.cpp "
                        "--out \"$LAB_FILE\"/.lab/{}.html",
                        (build_root() / "course" / "lab").string(), name,
                        exercise().topic, name, name),
            desk_.root);
        note_ = code == 0
                    ? fmt::format("Its replay is .lab/{}.html", name)
                    : fmt::format("No replay: lab demo {} says why", name);
    }

    void open_editor() {
        const int code = terminal_.run("${VISUAL:-${EDITOR:-vi}} \"$LAB_FILE\"",
                                       desk_.file(exercise()).string());
        if (code != 0)
            note_ = fmt::format(
                "The editor ended with {}. Name yours in EDITOR.", code);
    }

    const Desk& desk_;
    Terminal terminal_;
    std::unique_ptr<Rechecker> rechecker_;
    Statement statement_;
    Mode mode_ = Mode::exercise;
    std::size_t top_ = 0;
    std::size_t hints_ = 0;
    std::string note_;
    std::vector<Listed> listed_;  ///< what the list chooses from
    ListView list_;
    std::optional<BackgroundRun> all_;
    bool all_ended_ = false;
    bool quits_ = false;
};

}  // namespace

int watch(const Desk& desk) {
    remove_stale_temporary_folders();
    if (!Terminal::is_there()) return print_results(desk);
    return Watch(desk).run();
}

}  // namespace course

// Compiled for the traced table: events are of that build.
#include "course/player/walk_steps.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "course/halfedge/trace.h"
#include "course/player/recorded_call.h"
#include "course/runner/codec.h"

namespace course {

namespace {

// ---- what gdb wrote

std::string_view next_field(std::string_view& line, char separator) {
    const auto end = std::min(line.find(separator), line.size());
    const std::string_view field = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return field;
}

template <class Number>
Number number_of(std::string_view text) {
    Number n{};
    std::from_chars(text.data(), text.data() + text.size(), n);
    return n;
}

LineReached line_reached(std::string_view text) {
    LineReached reached;
    reached.events = number_of<std::size_t>(next_field(text, '\t'));
    reached.line = number_of<int>(next_field(text, '\t'));
    reached.address = number_of<std::uint64_t>(next_field(text, '\t'));
    reached.stack = number_of<std::uint64_t>(next_field(text, '\t'));
    reached.function = next_field(text, '\t');
    while (!text.empty()) {
        std::string_view name = next_field(text, '\t');
        const bool left = !name.empty() && name.front() == '-';
        if (left) name.remove_prefix(1);
        (left ? reached.left : reached.variables)
            .emplace_back(name, next_field(text, '\t'));
    }
    return reached;
}

// ---- what the recorder wrote

// Of a mesh of a million faces, and then some.
constexpr int most_rows = 1 << 23;

void require(bool sound) {
    if (!sound) throw CodecError("a recorded event names what cannot be");
}

void require_sound(const TraceEvent& event) {
    require(event.i >= -1 && event.i < most_rows && event.table >= 0 &&
            event.rows.size() < most_rows);
    for (const Change& change : event.changes)
        require(change.i >= 0 && change.i < most_rows && change.field >= 0 &&
                change.field < 4);
}

Row row_of(const HalfEdge& h) {
    return {h.vi, h.fi, h.next, h.opp};
}

std::vector<Row> rows_of(const std::vector<HalfEdge>& table) {
    std::vector<Row> rows;
    for (const HalfEdge& h : table) rows.push_back(row_of(h));
    return rows;
}

HalfEdgeTable table_of(const std::vector<Row>& rows) {
    std::vector<HalfEdge> table;
    for (const Row& r : rows) table.push_back({r[0], r[1], r[2], r[3]});
    return HalfEdgeTable(std::move(table));
}

constexpr Row no_row = {-1, -1, -1, -1};

void apply(const std::vector<Change>& changes, std::vector<Row>& rows) {
    for (const Change& change : changes) {
        const auto at = static_cast<std::size_t>(change.i);
        if (at >= rows.size()) rows.resize(at + 1, no_row);
        rows[at][static_cast<std::size_t>(change.field)] = change.after;
    }
}

// ---- one table to show

/// A function may use several tables: it edits a copy, and reads the original
/// on. Shown is one: the one that was made or written last.
class Shown {
public:
    /// `table` is number 0; that is not shown when it is never used.
    Shown(const std::vector<TraceEvent>& events, std::vector<Row> table) {
        const auto used =
            std::find_if(events.begin(), events.end(), [](const TraceEvent& e) {
                return e.kind != TraceEvent::Kind::begin;
            });
        tables_[0] = std::move(table);
        if (used != events.end()) number_ = used->table;
        for (const TraceEvent& event : events)
            if (event.table == number_ && number_ > 0 &&
                event.kind == TraceEvent::Kind::begin)
                tables_[number_] = rows_of(event.rows);
        rows_ = tables_[number_];
    }

    const std::vector<Row>& rows() const { return rows_; }

    /// A table comes into use: steps from what is shown to what it is.
    std::vector<Step> begin(const TraceEvent& event) {
        std::vector<Row> rows =
            event.table == 0 ? tables_[0] : rows_of(event.rows);
        apply(event.changes, rows);
        tables_[event.table] = rows;
        if (event.table < number_) return {};
        return show(event.table);
    }

    /// Steps that come before one that is shown, then it.
    std::vector<Step> step(const TraceStep& traced, const TraceEvent& event) {
        std::vector<Step> steps;
        if (traced.write && traced.table != number_) steps = show(traced.table);
        steps.push_back(step_of(traced, event));
        Step& step = steps.back();
        if (traced.table != number_) {
            step.in_original = differs(step, tables_[traced.table]);
            return steps;
        }
        write(step, rows_);
        write(step, tables_[number_]);
        return steps;
    }

private:
    static Step step_of(const TraceStep& traced, const TraceEvent& event) {
        Step step{traced.line, traced.from, traced.to, traced.i};
        constexpr std::array<const char*, 4> names = {"vi", "fi", "next",
                                                      "opp"};
        const auto field = std::find(names.begin(), names.end(), traced.field);
        if (field != names.end())
            step.field = static_cast<int>(field - names.begin());
        step.value = traced.value;
        if (traced.added) {
            std::vector<Row> rows(static_cast<std::size_t>(traced.i), no_row);
            rows.push_back(no_row);
            apply(event.changes, rows);
            step.added = rows[static_cast<std::size_t>(traced.i)];
        } else if (traced.write && step.field >= 0) {
            step.before = traced.before;
        }
        return step;
    }

    static void write(const Step& step, std::vector<Row>& rows) {
        const auto at = static_cast<std::size_t>(step.i);
        if (!step.added && !step.before) return;
        if (at >= rows.size()) rows.resize(at + 1, no_row);
        if (step.added)
            rows[at] = *step.added;
        else
            rows[at][static_cast<std::size_t>(step.field)] = step.value;
    }

    /// Whether what is read is not what the shown table has there.
    bool differs(const Step& step, const std::vector<Row>& read) const {
        const auto at = static_cast<std::size_t>(step.i);
        if (at >= rows_.size()) return true;
        if (step.field >= 0)
            return rows_[at][static_cast<std::size_t>(step.field)] !=
                   step.value;
        return at >= read.size() || rows_[at] != read[at];
    }

    /// Steps from the table that is shown to another one.
    std::vector<Step> show(int number) {
        const std::vector<Row>& next = tables_[number];
        std::vector<Step> steps;
        for (std::size_t k = 0; k < next.size(); ++k)
            add_differences(static_cast<int>(k), next[k], steps);
        if (next.size() < rows_.size())
            steps.emplace_back().cut = static_cast<int>(next.size());
        number_ = number;
        rows_ = next;
        return steps;
    }

    void add_differences(int i, const Row& next,
                         std::vector<Step>& steps) const {
        const auto at = static_cast<std::size_t>(i);
        if (at >= rows_.size()) {
            steps.emplace_back().i = i;
            steps.back().added = next;
            return;
        }
        for (std::size_t field = 0; field < 4; ++field)
            if (rows_[at][field] != next[field])
                steps.push_back({0, 0, 0, i, static_cast<int>(field),
                                 next[field], rows_[at][field]});
    }

    std::map<int, std::vector<Row>> tables_;
    int number_ = 0;
    std::vector<Row> rows_;
};

// ---- lines and reads, in the order of time

/// From those of a step to those of another one.
Variables changes(const Variables& before, const Variables& after) {
    const auto has = [](const Variables& all, const std::string& name) {
        return std::any_of(all.begin(), all.end(),
                           [&](const auto& v) { return v.first == name; });
    };
    Variables changed;
    for (const auto& variable : after)
        if (std::find(before.begin(), before.end(), variable) == before.end())
            changed.push_back(variable);
    for (const auto& [name, value] : before)
        if (!has(after, name)) changed.emplace_back(name, "null");
    return changed;
}

/// What is known of a call that has not returned.
struct Call {
    LineReached last = {};
    bool shown = false;  ///< the line, by a step
    int number = 0;      ///< no other call has it
};

/// Puts lines and uses of the table into one order. A stop of gdb tells the
/// variables as they are before its line, so they are what the steps before it
/// lead to; but only those in the same call: of calls around it nothing is
/// known until they go on. The stack tells calls apart, also of one function.
class Merged {
public:
    explicit Merged(std::string function) : function_(std::move(function)) {}

    void reach(const LineReached& stop) {
        return_to(stop.stack);
        if (!calls_.empty() && calls_.back().last.stack == stop.stack) {
            go_on(calls_.back(), stop);
        } else if (stop.line > 0) {
            finish_line();
            calls_.push_back({stop, false, ++number_});
        }
    }

    void add(Step step, std::uint64_t stack) {
        return_to(stack);
        if (!calls_.empty()) {
            if (step.line == 0) step.line = calls_.back().last.line;
            calls_.back().shown = true;
        }
        push(std::move(step));
    }

    std::vector<Step> steps() && {
        return_to(~std::uint64_t{0});
        add_variables();
        return std::move(steps_);
    }

private:
    /// What a step was pushed with.
    struct State {
        std::size_t depth;
        std::string function;
        Variables variables;
    };

    /// Calls that end deeper in the stack than this are over.
    void return_to(std::uint64_t stack) {
        while (!calls_.empty() && calls_.back().last.stack < stack) {
            finish_line();
            calls_.pop_back();
        }
    }

    /// The compiler may have several places in one line, as in a for: going on
    /// in a line is nothing new, going back is, if something has changed.
    void go_on(Call& call, const LineReached& stop) {
        const bool same = stop.line == call.last.line;
        const bool goes_on = same && stop.address > call.last.address;
        const bool changed = stop.variables != call.last.variables;
        // What a line does after a call that it made is a step of its own.
        if (changed && pushed_by_ != call.number) call.shown = false;
        if (!goes_on && (changed || !same)) finish_line();
        if (call.shown && pushed_by_ == call.number) {
            Variables& all = states_.back().variables = stop.variables;
            all.insert(all.end(), stop.left.begin(), stop.left.end());
        }
        const int line = stop.line > 0 ? stop.line : call.last.line;
        call.last = stop;
        call.last.line = line;
        if (!goes_on && stop.line > 0) call.shown = false;
    }

    /// A line that has read nothing is a step of its own.
    void finish_line() {
        if (calls_.empty() || calls_.back().shown) return;
        calls_.back().shown = true;
        Step step;
        step.line = calls_.back().last.line;
        push(std::move(step));
    }

    void push(Step step) {
        steps_.push_back(std::move(step));
        State state{0, function_, {}};
        if (!calls_.empty()) {
            const LineReached& last = calls_.back().last;
            state = {calls_.size() - 1, last.function, last.variables};
            pushed_by_ = calls_.back().number;
        }
        states_.push_back(std::move(state));
    }

    /// Each step gets what is another thing in it than in the one before.
    void add_variables() {
        std::vector<Variables> shown(1);  // of each call around
        std::string function = function_;
        for (std::size_t k = 0; k < steps_.size(); ++k) {
            const State& state = states_[k];
            if (state.depth + 1 != shown.size())
                steps_[k].depth = static_cast<int>(state.depth);
            shown.resize(state.depth + 1);
            steps_[k].locals = changes(shown.back(), state.variables);
            shown.back() = state.variables;
            if (state.function != function)
                steps_[k].function = function = state.function;
        }
    }

    std::string function_;  // of the exercise
    std::vector<Call> calls_;
    int number_ = 0;     // of the last one
    int pushed_by_ = 0;  // the call that the last step belongs to
    std::vector<Step> steps_;
    std::vector<State> states_;
};

std::vector<Step> merge(const std::vector<TraceEvent>& events,
                        const StepsByEvent& traced, Shown shown,
                        const std::vector<LineReached>& lines, Merged merged) {
    auto line = lines.begin();
    for (std::size_t k = 0; k < events.size(); ++k) {
        for (; line != lines.end() && line->events <= k; ++line)
            merged.reach(*line);
        const TraceEvent& event = events[k];
        if (event.kind == TraceEvent::Kind::begin) {
            for (Step& step : shown.begin(event))
                merged.add(std::move(step), event.frame);
            continue;
        }
        for (std::size_t s = traced.first[k]; s < traced.first[k + 1]; ++s)
            for (Step& step : shown.step(traced.steps[s], event))
                merged.add(std::move(step), event.frame);
    }
    for (; line != lines.end(); ++line) merged.reach(*line);
    return std::move(merged).steps();
}

std::size_t reads_of(const std::vector<Step>& steps, std::size_t first) {
    std::size_t n = 0;
    for (std::size_t k = first; k < steps.size(); ++k)
        if (steps[k].i >= 0) ++n;
    return n;
}

}  // namespace

std::vector<std::vector<LineReached>> read_lines_reached(
    std::string_view text) {
    std::vector<std::vector<LineReached>> walks;
    while (!text.empty()) {
        const std::string_view line = next_field(text, '\n');
        if (line == "walk")
            walks.emplace_back();
        else if (!walks.empty())
            walks.back().push_back(line_reached(line));
    }
    return walks;
}

RecordedWalk decode_call(std::string_view bytes, const std::vector<Row>& table,
                         std::string_view source, const std::string& function,
                         const std::vector<LineReached>& lines,
                         std::size_t most) {
    auto call = decode<RecordedCall>(bytes);
    for (const TraceEvent& event : call.events) require_sound(event);
    // What comes after the lines that were kept has variables of before.
    if (!lines.empty() && lines.back().line < 0 &&
        lines.back().events < call.events.size())
        call.events.resize(std::max(lines.back().events, std::size_t{1}));
    const StepsByEvent traced =
        steps_by_event(call.events, table_of(table), source);
    const Shown shown(call.events, table);
    RecordedWalk walk;
    if (shown.rows() != table) walk.table = shown.rows();
    walk.steps = merge(call.events, traced, shown, lines, Merged(function));
    walk.skipped = static_cast<std::size_t>(call.size) - call.events.size();
    if (walk.steps.size() > most) {
        walk.skipped += reads_of(walk.steps, most);
        walk.steps.resize(most);
    }
    walk.call = function + call.call;
    walk.result = std::move(call.result);
    walk.error = std::move(call.error);
    return walk;
}

}  // namespace course

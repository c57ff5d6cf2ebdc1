// Finding the expression of each recorded subscript in the source.
#include "course/halfedge/trace.h"

#if COURSE_TABLE == 2

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

namespace course {

namespace {

constexpr auto npos = std::string::npos;

constexpr std::array<const char*, 4> field_names = {"vi", "fi", "next", "opp"};

int& cell(HalfEdge& row, int field) {
    int* const cells[] = {&row.vi, &row.fi, &row.next, &row.opp};
    return *cells[field];
}

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// ---- the source, ready for matching brackets

/// Where the comment or literal that starts at `at` ends; `at` if none does.
std::size_t end_of_literal(std::string_view text, std::size_t at) {
    const auto past = [&](std::size_t end, std::size_t length) {
        return end == npos ? text.size() : end + length;
    };
    if (text.substr(at, 2) == "//") return past(text.find('\n', at), 0);
    if (text.substr(at, 2) == "/*") return past(text.find("*/", at + 2), 2);
    const char quote = text[at];
    const bool separates_digits =
        quote == '\'' && at > 0 && is_name(text[at - 1]);
    if ((quote != '"' && quote != '\'') || separates_digits) return at;
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != quote && text[end] != '\n')
        end += text[end] == '\\' ? 2U : 1U;
    return std::min(end + 1, text.size());
}

/// The source with blanks for comments and literals; all places stay.
std::string code_only(std::string_view source) {
    std::string code(source);
    for (std::size_t at = 0; at < source.size();) {
        const std::size_t end = end_of_literal(source, at);
        for (std::size_t k = at; k < end; ++k)
            if (code[k] != '\n') code[k] = ' ';
        at = std::max(end, at + 1);
    }
    return code;
}

std::size_t skip_blanks(std::string_view code, std::size_t at) {
    while (at < code.size() &&
           std::isspace(static_cast<unsigned char>(code[at])) != 0)
        ++at;
    return at;
}

std::size_t skip_name(std::string_view code, std::size_t at) {
    while (at < code.size() && is_name(code[at])) ++at;
    return at;
}

/// The ] at or after `at` whose [ stands before it.
std::size_t closing_bracket(std::string_view code, std::size_t at) {
    int depth = 0;
    for (; at < code.size(); ++at) {
        const char c = code[at];
        if (c == '[' || c == '(' || c == '{') ++depth;
        if (depth == 0 && c == ']') return at;
        if (depth == 0 && (c == ')' || c == '}' || c == ';')) return npos;
        if (c == ']' || c == ')' || c == '}') --depth;
    }
    return npos;
}

/// The bracket that matches the closing one at `at`.
std::size_t opening_bracket(std::string_view code, std::size_t at) {
    int depth = 0;
    for (std::size_t k = at + 1; k-- > 0;) {
        const char c = code[k];
        if (c == ']' || c == ')' || c == '}') ++depth;
        if (c == '[' || c == '(' || c == '{') --depth;
        if (depth == 0) return k;
    }
    return npos;
}

/// Where the expression before the place `end` begins: a name, or brackets
/// with what stands before them, as `he` or `(*table)`.
std::size_t begin_of_operand(std::string_view code, std::size_t end) {
    while (end > 0 &&
           std::isspace(static_cast<unsigned char>(code[end - 1])) != 0)
        --end;
    if (end > 0 && code[end - 1] == ')') {
        const std::size_t open = opening_bracket(code, end - 1);
        if (open == npos) return end;
        end = open;
    }
    while (end > 0 && is_name(code[end - 1])) --end;
    return end;
}

// ---- one expression

/// Where a subscript with its field stands.
struct Place {
    std::string field;
    int line = 0, from = 0, to = 0;
    bool write = false;
};

/// What is found in the source text: half-open range of the expression; of it
/// `anchor` is on the line that is shown.
struct Range {
    std::size_t from, anchor, to;
    std::string field;
};

class Source {
public:
    explicit Source(std::string_view text) : code_(code_only(text)) {
        line_starts_.push_back(0);
        for (std::size_t at = 0; at < code_.size(); ++at)
            if (code_[at] == '\n') line_starts_.push_back(at + 1);
    }

    Place place_of(const TraceEvent& event) const {
        const std::size_t at = offset_of(event);
        if (at == npos) return {"", event.line};
        std::optional<Range> range = macro_at(at);
        if (!range) range = subscript_at(at);
        return range ? placed(*range) : Place{"", event.line};
    }

    /// he.push_back({...}) round the place that a compiler gives: g++ that of
    /// the parenthesis, clang that of the first character.
    Place call_of(const TraceEvent& event, const std::string& name) const {
        const std::size_t at = offset_of(event);
        if (at == npos) return {"", event.line};
        const std::size_t start =
            code_[at] == '(' ? code_.rfind(name, at) : code_.find(name, at);
        if (start == npos) return {"", event.line};
        const std::size_t open = skip_blanks(code_, start + name.size());
        return placed({begin_of_operand(code_, start - 1),
                       start + name.size() - 1, after_arguments(open), ""});
    }

private:
    /// Where in the text an event is; npos when that is not known.
    std::size_t offset_of(const TraceEvent& event) const {
        if (event.line < 1 || event.column < 1 ||
            static_cast<std::size_t>(event.line) > line_starts_.size())
            return npos;
        const std::size_t at =
            line_starts_[static_cast<std::size_t>(event.line) - 1] +
            static_cast<std::size_t>(event.column) - 1;
        return at < code_.size() ? at : npos;
    }

    /// he[...].next round the place that a compiler gives: g++ that of the ],
    /// clang that of the first character of the index.
    std::optional<Range> subscript_at(std::size_t at) const {
        const std::size_t close = closing_bracket(code_, at);
        if (close == npos) return std::nullopt;
        const std::size_t open = opening_bracket(code_, close);
        if (open == npos) return std::nullopt;
        Range range{begin_of_operand(code_, open), close, close + 1, ""};
        range.field = field_after(range.to, range.to);
        return range;
    }

    /// The name of the field after `at`, if one follows; `end` is set after it.
    std::string field_after(std::size_t at, std::size_t& end) const {
        at = skip_blanks(code_, at);
        if (at >= code_.size() || code_[at] != '.') return "";
        at = skip_blanks(code_, at + 1);
        const std::size_t after = skip_name(code_, at);
        const std::string name = code_.substr(at, after - at);
        if (std::find(field_names.begin(), field_names.end(), name) ==
            field_names.end())
            return "";
        end = after;
        return name;
    }

    /// NEXT(i), where NEXT stands for a subscript: g++ gives the place of its
    /// first character, clang that of its last bracket.
    std::optional<Range> macro_at(std::size_t at) const {
        if (code_[at] == ')') {
            const std::size_t open = opening_bracket(code_, at);
            if (open != npos) at = begin_of_operand(code_, open);
        }
        const std::size_t name_end = skip_name(code_, at);
        const std::size_t close = body_bracket(code_.substr(at, name_end - at));
        if (close == npos) return std::nullopt;
        const std::size_t open = skip_blanks(code_, name_end);
        const bool has_arguments = open < code_.size() && code_[open] == '(';
        const std::size_t end =
            has_arguments ? after_arguments(open) : name_end;
        std::size_t unused = 0;
        return Range{at, at, end, field_after(close + 1, unused)};
    }

    /// The place after the parenthesis that matches the one at `open`.
    std::size_t after_arguments(std::size_t open) const {
        int depth = 0;
        for (std::size_t k = open; k < code_.size(); ++k) {
            if (code_[k] == '(') ++depth;
            if (code_[k] == ')' && --depth == 0) return k + 1;
        }
        return code_.size();
    }

    /// The first ] in the text that the macro stands for; npos if it is no
    /// macro of this source, or has none.
    std::size_t body_bracket(const std::string& name) const {
        if (name.empty()) return npos;
        const std::string start = "#define " + name;
        for (std::size_t at = code_.find(start); at != npos;
             at = code_.find(start, at + 1)) {
            const std::size_t after = at + start.size();
            if (after < code_.size() && is_name(code_[after])) continue;
            const std::size_t close = code_.find(']', after);
            return close < code_.find('\n', after) ? close : npos;
        }
        return npos;
    }

    /// Whether the expression is assigned to, from what stands round it.
    bool is_written(const Range& range) const {
        const std::string_view after =
            std::string_view(code_).substr(skip_blanks(code_, range.to));
        constexpr std::array<std::string_view, 12> writes = {
            "++", "--", "+=", "-=", "*=",  "/=",
            "%=", "&=", "|=", "^=", "<<=", ">>="};
        for (const std::string_view sign : writes)
            if (after.substr(0, sign.size()) == sign) return true;
        if (after.substr(0, 1) == "=" && after.substr(0, 2) != "==")
            return true;
        const std::string_view before =
            std::string_view(code_).substr(0, range.from);
        const std::size_t last = before.find_last_not_of(" \t\n");
        if (last == npos || last == 0) return false;
        const std::string_view sign = before.substr(last - 1, 2);
        return sign == "++" || sign == "--";
    }

    Place placed(const Range& range) const {
        const auto after = std::upper_bound(line_starts_.begin(),
                                            line_starts_.end(), range.anchor);
        const std::size_t start = *(after - 1);
        const std::size_t end =
            after == line_starts_.end() ? code_.size() + 1 : *after;
        // What stands on other lines is cut off; the ] is always kept.
        const std::size_t from =
            range.from >= start ? range.from : skip_blanks(code_, start);
        const std::size_t to = range.to < end ? range.to : range.anchor + 1;
        return {range.field, static_cast<int>(after - line_starts_.begin()),
                static_cast<int>(from - start) + 1,
                static_cast<int>(to - start) + 1, is_written(range)};
    }

    std::string code_;
    std::vector<std::size_t> line_starts_;
};

// ---- the steps

class Replay {
public:
    Replay(const HalfEdgeTable& initial, std::string_view source)
        : source_(source), tables_{{0, initial.rows()}} {}

    void add(const TraceEvent& event) {
        found_.first.push_back(found_.steps.size());
        rows_ = &tables_[event.table];
        std::vector<Change> changes = event.changes;
        if (event.kind == TraceEvent::Kind::begin && event.table > 0)
            *rows_ = event.rows;
        if (event.kind == TraceEvent::Kind::push_back)
            add_row(event, changes);
        else if (event.i >= 0)
            add_subscript(event, changes);
        for (const Change& change : changes)
            add_hidden_write(event.table, change);
        for (const Change& change : event.changes)
            cell(row(change.i), change.field) = change.after;
    }

    StepsByEvent steps() && {
        found_.first.push_back(found_.steps.size());
        return std::move(found_);
    }

private:
    HalfEdge& row(int i) {
        const auto at = static_cast<std::size_t>(i);
        if (at >= rows_->size()) rows_->resize(at + 1);
        return (*rows_)[at];
    }

    /// The step that the source shows; takes its change off the list.
    void add_subscript(const TraceEvent& event, std::vector<Change>& changes) {
        const Place place = source_.place_of(event);
        TraceStep step{event.i,  place.field, place.line, place.from,
                       place.to, place.write, 0,          0};
        step.table = event.table;
        const int field = static_cast<int>(
            std::find(field_names.begin(), field_names.end(), place.field) -
            field_names.begin());
        if (field < 4) step.value = step.before = cell(row(event.i), field);
        const auto own =
            std::find_if(changes.begin(), changes.end(), [&](const Change& c) {
                return c.i == event.i && c.field == field;
            });
        if (place.write && own != changes.end()) {
            step.value = own->after;
            changes.erase(own);
        }
        found_.steps.push_back(step);
    }

    /// A row that is appended; what it consists of is no write of its own.
    void add_row(const TraceEvent& event, std::vector<Change>& changes) {
        const Place place = source_.call_of(event, "push_back");
        TraceStep step{event.i,  "",   place.line, place.from,
                       place.to, true, 0,          0};
        step.added = true;
        step.table = event.table;
        std::erase_if(changes, [&](const Change& c) { return c.i == event.i; });
        found_.steps.push_back(step);
    }

    /// A write that stands elsewhere than its subscript.
    void add_hidden_write(int table, const Change& change) {
        const std::string name =
            field_names[static_cast<std::size_t>(change.field)];
        TraceStep step{change.i,     name,         0, 0, 0, true,
                       change.after, change.before};
        step.table = table;
        std::vector<TraceStep>& steps = found_.steps;
        const auto taken = std::find_if(
            steps.rbegin(), steps.rend(), [&](const TraceStep& earlier) {
                return earlier.i == change.i && earlier.table == table &&
                       (earlier.field.empty() || earlier.field == name);
            });
        if (taken != steps.rend()) {
            step.line = taken->line;
            step.from = taken->from;
            step.to = taken->to;
        }
        steps.push_back(step);
    }

    Source source_;
    std::map<int, std::vector<HalfEdge>> tables_;
    std::vector<HalfEdge>* rows_ = nullptr;  // of the event's table
    StepsByEvent found_;
};

}  // namespace

std::vector<TraceStep> trace_steps(const std::vector<TraceEvent>& events,
                                   const HalfEdgeTable& initial,
                                   std::string_view source) {
    return steps_by_event(events, initial, source).steps;
}

StepsByEvent steps_by_event(const std::vector<TraceEvent>& events,
                            const HalfEdgeTable& initial,
                            std::string_view source) {
    Replay replay(initial, source);
    for (const TraceEvent& event : events) replay.add(event);
    return std::move(replay).steps();
}

}  // namespace course

#endif

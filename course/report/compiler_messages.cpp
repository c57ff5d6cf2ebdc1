#include "course/report/compiler_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

namespace course {

namespace {

constexpr std::size_t most_messages = 3;
constexpr std::size_t most_lines_of_source = 4;
// Of a line, the rest of which nobody reads: std::regex needs some hundred
// bytes of stack for each of its characters.
constexpr std::size_t most_of_line = 2000;

/// What a message says, and what it mostly means here.
struct Usual {
    const char* pattern;  // quotes are ' in all of them; $1 is its first group
    const char* advice;
    bool explains_failures = false;
};

constexpr std::array<Usual, 22> usual_ones = {{
    {"has no member named '(?:v|vertex|vert|from|start)'|"
     "no member named '(?:v|vertex|vert|from|start)'",
     "The vertex that a half-edge leaves is its field vi: he[i].vi."},
    {"has no member named '(?:f|face)'|no member named '(?:f|face)'",
     "The face that a half-edge runs along is its field fi: he[i].fi."},
    {"'(?:const )?(?:struct |class )?HalfEdge' has no member named|"
     "no member named '\\w+' in '\\w*:*HalfEdge'",
     "A half-edge has four fields: vi, fi, next and opp."},
    {"HalfEdgeTable' has no member named|in '\\w*:*HalfEdgeTable'",
     "The table is used as he[i], he.size() and, to add a row, "
     "he.push_back(row)."},
    {"'(\\w+)' is not a member of 'std'|"
     "no member named '(\\w+)' in namespace 'std'",
     "Is an #include missing at the top of the file, or is the name spelled "
     "in another way?"},
    {"cannot convert '.*HalfEdge'|"
     "no viable conversion from '.*HalfEdge'|"
     "invalid operands .*HalfEdge|no match for 'operator.*HalfEdge",
     "he[i] is a whole row of the table. Which of its fields do you want: vi, "
     "fi, next or opp?"},
    {"in read-only object|cannot assign to .*const|"
     "discards qualifiers|is a read-only",
     "The table is const here: it can be read, not changed."},
    {"ambiguating new declaration|differ only in their return type",
     "The header of the exercise declares the function with another result: "
     "copy its line from there."},
    {"redefinition of|was declared twice|redeclaration of",
     "There are two of this name. Leave out the type where you want to give a "
     "new value to the first one."},
    {"expected ';'|expected ',' or ';'",
     "Does the line before end with a semicolon?"},
    {"expected '\\}' at end of input|expected '\\}'",
     "A brace { is open that is never closed."},
    {"was not declared in this scope|use of undeclared identifier",
     "Is the name spelled as where it was declared, and was it declared "
     "outside of inner braces?"},
    {"no return statement in function|"
     "control reaches end of non-void|does not return a value",
     "There is a way through the function that meets no return: then the "
     "answer is any number at all.",
     true},
    {"shadows a parameter|shadows a previous local|declaration shadows",
     "This is a second variable of the same name. It ends with the inner "
     "braces, and the one outside keeps its old value: leave out the type to "
     "change that one.",
     true},
    {"used uninitialized|uninitialized when used|may be used uninit",
     "The variable is read before it was given a value.", true},
    {"assignment used as truth value|"
     "using the result of an assignment as a condition",
     "= gives a value, == compares.", true},
    {"statement has no effect|value computed is not used|"
     "result unused|is unused, |expression result unused|"
     "comparison result unused",
     "A value is read and thrown away. Was it to be assigned, as in "
     "i = he[i].next?",
     true},
    {"suggest braces around empty body|has empty body|"
     "clause does not guard",
     "The loop or the condition ends at the semicolon: what stands below is "
     "not in it.",
     true},
    {"infinite recursion", "The function calls itself without end.", true},
    {"comparison .*between .*constant|always (?:true|false|evaluate)",
     "The condition is the same each time that it is asked.", true},
    {"unused variable|set but not used",
     "The variable is never looked at: is another one used in its place?",
     true},
    {"different signedness|comparison of integers of different signs",
     "An index is an int here: compare it with he.size(), or with "
     "static_cast<int>(list.size())."},
}};

struct Place {
    std::string file, position, kind, text;
};

/// "file:line:column: kind: text", or nothing.
std::optional<Place> place_of(const std::string& line) {
    static const std::regex form(
        "^([^ :][^:]*):([0-9]+:[0-9]+): (fatal error|error|warning|note): "
        "(.*)$");
    std::smatch parts;
    if (!std::regex_match(line, parts, form)) return std::nullopt;
    return Place{parts[1], parts[2], parts[3], parts[4]};
}

/// "file:line:column" where the line says what led to a message in a header.
std::string cause_in(const std::string& line) {
    static const std::regex form(
        "^([^ :][^:]*[.](?:cpp|cc|cxx):[0-9]+:[0-9]+): +(?:required|note: in "
        "inst).*$");
    std::smatch parts;
    return std::regex_match(line, parts, form) ? parts[1].str() : "";
}

bool is_own(const std::string& file) {
    return file.ends_with(".cpp") || file.ends_with(".cc") ||
           file.ends_with(".cxx");
}

/// Lines that are neither a message nor a piece of source.
bool is_context(const std::string& line) {
    static const std::regex form(
        "^(In file included from|                 from |[^ ].*: (In |At ).*:"
        "|[0-9]+ (errors?|warnings?) .*generated|cc1plus|compilation "
        "terminated).*");
    return std::regex_match(line, form);
}

std::string with_plain_quotes(std::string text) {
    for (const std::string quote : {"‘", "’"})
        for (auto at = text.find(quote); at != std::string::npos;
             at = text.find(quote, at))
            text.replace(at, quote.size(), "'");
    return text;
}

/// The usual messages' patterns, in their order.
const std::vector<std::regex>& patterns() {
    static const std::vector<std::regex> all = [] {
        std::vector<std::regex> made;
        for (const Usual& usual : usual_ones) made.emplace_back(usual.pattern);
        return made;
    }();
    return all;
}

/// The advice that fits, if any.
void advise(CompilerMessage& message) {
    const std::string plain = with_plain_quotes(message.text);
    for (std::size_t k = 0; k < usual_ones.size(); ++k)
        if (std::regex_search(plain, patterns()[k])) {
            message.advice = usual_ones[k].advice;
            message.explains_failures =
                !message.is_error && usual_ones[k].explains_failures;
            return;
        }
}

/// Reads the output line by line.
class Reader {
public:
    void take(const std::string& line) {
        const auto place = place_of(line);
        if (const std::string cause = cause_in(line); !cause.empty()) {
            if (waits_for_cause_) messages_.back().place = cause;
            waits_for_cause_ = false;
            cause_ = cause;
            shows_source_ = false;
        } else if (place && place->kind == "note") {
            note(*place);
        } else if (place) {
            begin(*place);
        } else if (shows_source_ && !is_context(line)) {
            add_source(line);
        } else {
            shows_source_ = false;
        }
    }

    std::vector<CompilerMessage> messages() {
        std::erase_if(messages_, [](const CompilerMessage& message) {
            return message.place.empty();
        });
        for (CompilerMessage& message : messages_) advise(message);
        return std::move(messages_);
    }

private:
    void begin(const Place& place) {
        CompilerMessage message;
        message.is_error = place.kind != "warning";
        message.text = place.text;
        shows_source_ = is_own(place.file);
        message.place =
            shows_source_ ? place.file + ":" + place.position : cause_;
        waits_for_cause_ = message.place.empty();
        cause_.clear();
        lines_ = 0;
        messages_.push_back(std::move(message));
    }

    /// Where the first one of two of a name is, the student wants to know.
    void note(const Place& place) {
        shows_source_ = false;
        static const std::regex tells("shadowed|previous|declared here");
        if (!messages_.empty() && is_own(place.file) &&
            std::regex_search(place.text, tells))
            messages_.back().source += fmt::format(
                "        (line {}: {})\n",
                place.position.substr(0, place.position.find(':')), place.text);
    }

    void add_source(const std::string& line) {
        if (++lines_ <= most_lines_of_source)
            messages_.back().source += line + "\n";
    }

    std::vector<CompilerMessage> messages_;
    std::string cause_;
    bool shows_source_ = false, waits_for_cause_ = false;
    std::size_t lines_ = 0;
};

int rank(const CompilerMessage& message) {
    return message.is_error ? 0 : message.explains_failures ? 1 : 2;
}

/// Of several messages at one place the first.
std::vector<CompilerMessage> without_echoes(
    std::vector<CompilerMessage> messages) {
    std::set<std::string> places;
    std::erase_if(messages, [&](const CompilerMessage& message) {
        return !places.insert(message.place).second;
    });
    return messages;
}

std::string text_of(const CompilerMessage& message) {
    return fmt::format(
        "{}: {}: {}\n{}{}", message.place,
        message.is_error ? "error" : "warning", message.text, message.source,
        message.advice.empty() ? "" : fmt::format("  -> {}\n", message.advice));
}

/// The line that stands before all where the compiler came to no end (see
/// compiled_from), or nothing.
std::string why_stopped(std::string_view output) {
    if (!output.starts_with("the compiler was stopped")) return "";
    return std::string(output.substr(0, output.find('\n'))) + "\n\n";
}

}  // namespace

std::vector<CompilerMessage> compiler_messages(std::string_view output) {
    Reader reader;
    std::istringstream lines{std::string(output)};
    for (std::string line; std::getline(lines, line);)
        reader.take(line.substr(0, most_of_line));
    std::vector<CompilerMessage> messages = reader.messages();
    std::stable_sort(messages.begin(), messages.end(),
                     [](const CompilerMessage& a, const CompilerMessage& b) {
                         return rank(a) < rank(b);
                     });
    return without_echoes(std::move(messages));
}

std::string explain_compiler(std::string_view output) {
    const std::vector<CompilerMessage> messages = compiler_messages(output);
    if (messages.empty()) return std::string(output);
    std::string text = why_stopped(output);
    for (std::size_t k = 0; k < messages.size() && k < most_messages; ++k)
        text += (k > 0 ? "\n" : "") + text_of(messages[k]);
    if (messages.size() > most_messages)
        text += fmt::format(
            "\n({} more {}: often they go with the first)\n",
            messages.size() - most_messages,
            messages.size() == most_messages + 1 ? "message" : "messages");
    return text;
}

}  // namespace course

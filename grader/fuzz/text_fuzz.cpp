// Texts of a submission on their way into reports: whatever came in, what goes
// out is UTF-8 that a reader sees as it is, of the length that was asked for.
#include "course/report/text.h"

#include "course/report/escape.h"
#include "grader/fuzz/fuzz.h"

namespace {

/// Whether it is UTF-8 with nothing invisible but line feeds and tabs.
bool is_plain(std::string_view text) {
    while (!text.empty()) {
        const course::Piece piece = course::first_piece(text);
        if (!piece.valid || course::is_invisible(piece.code)) return false;
        text.remove_prefix(piece.bytes.size());
    }
    return true;
}

bool has_none_of(std::string_view text, std::string_view characters) {
    return text.find_first_of(characters) == text.npos;
}

void require_no_markup(const std::string& escaped) {
    fuzz::require(is_plain(escaped) && has_none_of(escaped, "<>\"'"),
                  "HTML and XML hold no markup");
}

void require_no_formula(const std::string& field) {
    fuzz::require(is_plain(field) && has_none_of(field, "\n") &&
                      has_none_of(field.substr(0, 1), "=+-@\t"),
                  "a CSV field is a line and no formula");
}

void require_one_line(const std::string& line) {
    fuzz::require(is_plain(line) && has_none_of(line, "\n\t"),
                  "a terminal gets one line");
    for (const std::size_t columns : {1u, 2u, 7u, 40u})
        fuzz::require(course::width(course::fitted(line, columns)) <= columns,
                      "fitted text fits");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    const std::string shown = course::visible(text);
    fuzz::require(is_plain(shown), "visible text is plain");
    fuzz::require(course::visible(shown) == shown,
                  "what is visible stays as it is");
    fuzz::require(course::shortened(text, 60, 4).size() <= 60 + 64,
                  "shortened text is short");
    require_no_markup(course::escape_html(text));
    require_no_markup(course::escape_xml(text));
    require_no_formula(course::escape_csv(text));
    require_one_line(course::escape_terminal(text));
    fuzz::require(is_plain(course::escape_json(text)), "JSON is plain");
    return 0;
}

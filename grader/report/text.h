// Text that may hold anything, made fit to be shown: the part that all kinds
// of report share.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grader {

/// One piece of a text: a character in UTF-8, or a byte that is none.
struct Piece {
    std::string_view bytes;
    char32_t code = 0;
    bool valid = false;
};

/// The first piece of `text`. Overlong forms, surrogates and codes beyond
/// U+10FFFF are not valid. Precondition: `text` is not empty.
Piece first_piece(std::string_view text);

/// Whether a reader would not see the character, or see the text around it
/// changed: control characters but line feed and tab, marks that turn the
/// direction of writing, line separators, non-characters.
bool is_invisible(char32_t code);

/// "\x1B", "\u202E": how a piece is written that is not shown as it is.
std::string spelled_out(const Piece& piece);

/// `text` with every invisible character and invalid byte spelled out: valid
/// UTF-8, whatever came in.
std::string visible(std::string_view text);

/// Columns that `text` takes on a terminal; 2 for each wide character.
/// Precondition: `text` is visible and has no line feed or tab.
std::size_t width(std::string_view text);

/// `text` cut to at most `columns`, with "…" at the end when it was cut.
/// Precondition: as for width.
std::string fitted(std::string_view text, std::size_t columns);

/// At most about `bytes` bytes and `lines` lines of `text`, from its head and
/// its tail, with a line between that says how much was left out.
std::string shortened(std::string_view text, std::size_t bytes,
                      std::size_t lines);

/// "7.5", "10", "0.33": two digits at most, none that say nothing.
std::string points_text(double points);

/// "83.3", always with one digit; 0.0 when `max` is 0.
std::string percent_text(double points, double max);

/// "2024-03-01 09:30 UTC" of "2024-03-01T09:30:00Z"; other text as it is.
std::string time_text(std::string_view iso);

}  // namespace grader

#include "grader/report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace grader {

namespace {

struct Range {
    char32_t first, last;
};

template <std::size_t N>
bool in_any(const std::array<Range, N>& ranges, char32_t code) {
    return std::any_of(ranges.begin(), ranges.end(), [&](Range range) {
        return range.first <= code && code <= range.last;
    });
}

/// Bytes of a character by its first byte; 0 when no character begins so.
std::size_t length_by_first_byte(unsigned char first) {
    if (first < 0x80) return 1;
    if (first < 0xC2) return 0;  // a continuation, or an overlong form
    if (first < 0xE0) return 2;
    if (first < 0xF0) return 3;
    return first < 0xF5 ? 4 : 0;
}

/// The least code that needs so many bytes.
constexpr std::array<char32_t, 5> least_code = {0, 0, 0x80, 0x800, 0x10000};

bool is_surrogate(char32_t code) {
    return code >= 0xD800 && code <= 0xDFFF;
}

std::size_t columns_of(char32_t code) {
    constexpr std::array<Range, 3> combining = {
        {{0x0300, 0x036F}, {0x200C, 0x200D}, {0xFE00, 0xFE0F}}};
    constexpr std::array<Range, 8> wide = {{{0x1100, 0x115F},
                                            {0x2E80, 0xA4CF},
                                            {0xAC00, 0xD7A3},
                                            {0xF900, 0xFAFF},
                                            {0xFE30, 0xFE6F},
                                            {0xFF00, 0xFF60},
                                            {0x1F300, 0x1FAFF},
                                            {0x20000, 0x3FFFD}}};
    if (in_any(combining, code)) return 0;
    return in_any(wide, code) ? 2 : 1;
}

/// The end of the longest head of `text` that is no longer than `bytes` and
/// does not cut a character.
std::size_t whole_characters(std::string_view text, std::size_t bytes) {
    if (bytes >= text.size()) return text.size();
    std::size_t end = bytes;
    while (end > 0 && bytes - end < 4 &&
           (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;
    return end;
}

/// The head of `text`, of at most so many bytes and lines.
std::string_view head(std::string_view text, std::size_t bytes,
                      std::size_t lines) {
    std::size_t end = 0;
    for (std::size_t n = 0; n < lines && end < text.size(); ++n)
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
    return text.substr(0, whole_characters(text, std::min(end, bytes)));
}

/// The tail of `text`, of at most so many bytes and lines.
std::string_view tail(std::string_view text, std::size_t bytes,
                      std::size_t lines) {
    std::size_t begin = text.size();
    for (std::size_t n = 0; n < lines && begin > 0; ++n) {
        const std::size_t before =
            begin < 2 ? text.npos : text.rfind('\n', begin - 2);
        begin = before == text.npos ? 0 : before + 1;
    }
    if (text.size() - begin > bytes) begin = text.size() - bytes;
    return text.substr(whole_characters(text, begin));
}

}  // namespace

Piece first_piece(std::string_view text) {
    const auto byte = [&](std::size_t k) {
        return static_cast<unsigned char>(text[k]);
    };
    const std::size_t length = length_by_first_byte(byte(0));
    const Piece invalid = {text.substr(0, 1), byte(0), false};
    if (length == 0 || length > text.size()) return invalid;
    if (length == 1) return {text.substr(0, 1), byte(0), true};
    char32_t code = byte(0) & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0) != 0x80) return invalid;
        code = (code << 6) | (byte(k) & 0x3Fu);
    }
    if (code < least_code[length] || code > 0x10FFFF || is_surrogate(code))
        return invalid;
    return {text.substr(0, length), code, true};
}

bool is_invisible(char32_t code) {
    constexpr std::array<Range, 12> ranges = {{{0x00, 0x08},
                                               {0x0B, 0x1F},
                                               {0x7F, 0x9F},
                                               {0xAD, 0xAD},
                                               {0x061C, 0x061C},
                                               {0x200B, 0x200B},
                                               {0x200E, 0x200F},
                                               {0x2028, 0x202E},
                                               {0x2060, 0x206F},
                                               {0xFEFF, 0xFEFF},
                                               {0xFFF0, 0xFFFB},
                                               {0xE0000, 0xE0FFF}}};
    return in_any(ranges, code) || (code & 0xFFFE) == 0xFFFE ||
           (code >= 0xFDD0 && code <= 0xFDEF);
}

std::string spelled_out(const Piece& piece) {
    const auto code = static_cast<std::uint32_t>(piece.code);
    if (code < 0x100) return fmt::format("\\x{:02X}", code);
    return fmt::format("\\u{:04X}", code);
}

std::string visible(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Piece piece = first_piece(text);
        if (piece.valid && !is_invisible(piece.code))
            shown += piece.bytes;
        else
            shown += spelled_out(piece);
        text.remove_prefix(piece.bytes.size());
    }
    return shown;
}

std::size_t width(std::string_view text) {
    std::size_t columns = 0;
    while (!text.empty()) {
        const Piece piece = first_piece(text);
        columns += columns_of(piece.code);
        text.remove_prefix(piece.bytes.size());
    }
    return columns;
}

std::string fitted(std::string_view text, std::size_t columns) {
    if (width(text) <= columns) return std::string(text);
    std::string cut;
    std::size_t used = 0;
    while (!text.empty()) {
        const Piece piece = first_piece(text);
        used += columns_of(piece.code);
        if (used + 1 > columns) break;
        cut += piece.bytes;
        text.remove_prefix(piece.bytes.size());
    }
    return cut + "…";
}

std::string shortened(std::string_view text, std::size_t bytes,
                      std::size_t lines) {
    const auto breaks =
        static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    if (text.size() <= bytes && breaks <= lines) return std::string(text);
    const std::string_view first = head(text, bytes * 2 / 3, lines * 2 / 3);
    const std::string_view rest = text.substr(first.size());
    const std::string_view last =
        tail(rest, bytes - bytes * 2 / 3, lines - lines * 2 / 3);
    return fmt::format("{}{}[... {} bytes left out ...]\n{}", first,
                       first.ends_with('\n') || first.empty() ? "" : "\n",
                       rest.size() - last.size(), last);
}

std::string points_text(double points) {
    std::string text = fmt::format("{:.2f}", points);
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string percent_text(double points, double max) {
    return fmt::format("{:.1f}", max > 0 ? 100 * points / max : 0.0);
}

std::string time_text(std::string_view iso) {
    const bool known = iso.size() == 20 && iso[10] == 'T' && iso[19] == 'Z';
    if (!known) return std::string(iso);
    return fmt::format("{} {} UTC", iso.substr(0, 10), iso.substr(11, 5));
}

}  // namespace grader

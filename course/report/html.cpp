#include "course/report/html.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "course/report/escape.h"

namespace course::detail {

namespace {

/// With `digits` (0 or 1) after the point, correctly rounded.
void append_exactly(std::string& text, double number, int digits) {
    std::array<char, 400> room{};  // the largest double has 309 digits
    const auto end = std::to_chars(room.data(), room.data() + room.size(),
                                   number, std::chars_format::fixed, digits);
    text.append(room.data(), end.ptr);
}

/// The same, in a tenth of the time, for nearly all numbers: most of a drawing
/// is coordinates.
void append_fixed(std::string& text, double number, int digits) {
    const double scaled = std::abs(number) * (digits == 1 ? 10 : 1);
    if (!(scaled < 1e9)) return append_exactly(text, number, digits);
    const auto whole = static_cast<long>(scaled);
    const double part = scaled - static_cast<double>(whole);
    // Near a half the error of the product would decide.
    if (std::abs(part - 0.5) < 1e-6)
        return append_exactly(text, number, digits);
    const long rounded = whole + (part > 0.5 ? 1 : 0);
    std::array<char, 16> room{};
    char* end = room.data();
    if (std::signbit(number)) *end++ = '-';
    end = std::to_chars(end, room.data() + room.size(),
                        digits == 1 ? rounded / 10 : rounded)
              .ptr;
    if (digits == 1) {
        *end++ = '.';
        *end++ = static_cast<char>('0' + rounded % 10);
    }
    text.append(room.data(), end);
}

[[noreturn]] void do_not_fit(std::string_view where) {
    throw std::logic_error("places and values do not fit at: " +
                           std::string(where));
}

}  // namespace

std::string_view Filling::pass(std::size_t size_of_place) {
    const std::size_t begin = rest_.find('{');
    if (begin == rest_.npos || rest_.size() - begin < size_of_place)
        do_not_fit(rest_);
    const std::string_view place = rest_.substr(begin, size_of_place);
    text_.append(rest_, 0, begin);
    rest_.remove_prefix(begin + size_of_place);
    return place;
}

void Filling::pass_place() {
    if (pass(2) != "{}") do_not_fit(rest_);
}

void Filling::add(const Html& value) {
    pass_place();
    text_ += value.text;
}

void Filling::add(std::string_view text) {
    pass_place();
    text_ += escape_html(text);
}

void Filling::add(double number) {
    const std::string_view place = pass(6);
    const bool tenths = place == "{:.1f}";
    if (!tenths && place != "{:.0f}") do_not_fit(place);
    append_fixed(text_, number, tenths ? 1 : 0);
}

void Filling::end() {
    if (rest_.find('{') != rest_.npos) do_not_fit(rest_);
    text_ += rest_;
}

}  // namespace course::detail

// HTML that is safe by its type: text becomes Html only by being escaped.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace course {

/// Markup of our own, with all text in it escaped.
struct Html {
    std::string text;

    Html& operator+=(const Html& more) {
        text += more.text;
        return *this;
    }
};

namespace detail {

/// Appends a pattern to a page while its places are filled, from left to right.
/// A page is made of thousands of small pieces: with fmt, which can do more,
/// they take three times as long.
class Filling {
public:
    Filling(Html& page, std::string_view pattern)
        : text_(page.text), rest_(pattern) {}

    void add(const Html& value);
    void add(std::string_view text);
    void add(double number);
    void add(std::integral auto number) {
        pass_place();
        text_ += std::to_string(number);
    }

    void end();

private:
    std::string_view pass(std::size_t size_of_place);
    void pass_place();

    std::string& text_;
    std::string_view rest_;
};

}  // namespace detail

/// Appends to `page`. `pattern` is markup with a place for each value: `{}` or,
/// for a double, `{:.0f}` or `{:.1f}` with the meaning that fmt gives to them.
/// Html stands as it is, and text is escaped. Precondition: the pattern has no
/// other `{`.
/// Throws std::logic_error when the values do not fit the places.
template <class... Values>
void append(Html& page, std::string_view pattern, const Values&... values) {
    detail::Filling filling(page, pattern);
    (filling.add(values), ...);
    filling.end();
}

/// The same, for a piece of its own: of a page's larger parts, append saves a
/// copy.
template <class... Values>
Html markup(std::string_view pattern, const Values&... values) {
    Html piece;
    append(piece, pattern, values...);
    return piece;
}

}  // namespace course

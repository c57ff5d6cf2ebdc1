// HTML that is safe by its type: text becomes Html only by being escaped.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "grader/report/escape.h"

namespace grader {

/// Markup of our own, with all text in it escaped.
struct Html {
    std::string text;

    Html& operator+=(const Html& more) {
        text += more.text;
        return *this;
    }
};

namespace detail {

template <class T>
auto html_argument(const T& value) {
    if constexpr (std::is_same_v<T, Html>) {
        return value.text;
    } else if constexpr (std::is_arithmetic_v<T>) {
        return value;
    } else {
        return escape_html(std::string_view(value));
    }
}

}  // namespace detail

/// `pattern` is markup as for fmt::format; each value that is neither Html nor
/// a number is escaped.
template <class... Values>
Html markup(std::string_view pattern, const Values&... values) {
    auto arguments = std::make_tuple(detail::html_argument(values)...);
    return std::apply(
        [&](auto&... each) {
            return Html{fmt::vformat(pattern, fmt::make_format_args(each...))};
        },
        arguments);
}

}  // namespace grader

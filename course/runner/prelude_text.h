// Precompiled for submissions that need prelude.h and texts or exceptions.

#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "course/halfedge/table_errors.h"
#include "course/runner/prelude.h"
#include "course/runner/text_templates.h"

// Clang 14 evaluates no std::string at compile time; it has no need of it.
#ifndef __clang__

namespace course {

/// Uses what the inline functions of <string> use, at compile time: then it is
/// instantiated here, once, and not in every submission (35 ms).
template <class Char>
constexpr bool strings_are_ready() {
    using String = std::basic_string<Char>;
    const Char text[] = {Char('a'), Char('b'), Char()};
    String a(3, Char('a')), b;
    b = text;
    a += b;
    a.append(text).append(2, Char('c')).append(text, 1).push_back(Char('d'));
    a.insert(0, text).replace(0, 1, text).erase(0, 1).assign(text, 2);
    a.insert(0, b).assign(b);
    a.resize(20);
    a.reserve(100);
    const String sums[] = {
        a + b,         a + text,         text + a,
        a + Char('e'), String(a) + text, String(a) + String(b)};
    String c(text), d(text, text + 2), e(std::move(c));
    c = a.substr(1);
    d = std::move(c);
    swap(d, e);
    const std::basic_string_view<Char> view = a, same(text);
    bool used = a == b || e == text || a < b || view == same || view < same;
    used |= a.compare(b) == 0 || a.find(b) != a.find(text[0]) ||
            view.find(same) != view.find(text[0]) || view.compare(same) == 0 ||
            a.c_str() == b.data();
    return used || sums[0].size() + a.front() + a.back() + *d.begin() > 0;
}

static_assert(strings_are_ready<char>() && strings_are_ready<wchar_t>() &&
              strings_are_ready<char8_t>() && strings_are_ready<char16_t>() &&
              strings_are_ready<char32_t>());

}  // namespace course

#endif

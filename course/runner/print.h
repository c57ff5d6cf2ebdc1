// How values are shown in messages, by Catch2 and by the judge.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "course/halfedge/finding.h"
#include "course/runner/catch2.h"
#include "course/runner/codec.h"

namespace course {

#if COURSE_CATCH2 == 2
template <class T>
using CatchMatcherBase = Catch::MatcherBase<T>;
#else
template <class T>
using CatchMatcherBase = Catch::Matchers::MatcherBase<T>;
#endif

/// A value as messages show it.
template <class T>
std::string show(const T& value) {
    return Catch::Detail::stringify(value);
}

}  // namespace course

namespace Catch {

/// A fault by the name that contracts give it.
template <>
struct StringMaker<Fault> {
    static std::string convert(Fault fault);
};

/// A table: as many rows as help, then how many more.
template <>
struct StringMaker<HalfEdgeTable> {
    static std::string convert(const HalfEdgeTable& he);
};

/// A list: its first elements, then how many more. Hostile answers have a
/// million of them, for which Catch2 alone needs seconds.
template <class T>
struct is_range<std::vector<T>> : std::false_type {};

template <class T>
struct StringMaker<std::vector<T>> {
    static std::string convert(const std::vector<T>& list) {
        constexpr std::size_t most = 400;
        std::string text = "{ ";
        for (std::size_t k = 0; k < list.size() && k < most; ++k)
            text += (k > 0 ? ", " : "") +
                    ::Catch::Detail::stringify(static_cast<T>(list[k]));
        if (list.size() > most)
            text += ", ... " + std::to_string(list.size() - most) + " more";
        return text + " }";
    }
};

template <>
struct is_range<FaceList> : std::false_type {};

/// Faces, as a list of lists.
template <>
struct StringMaker<FaceList> {
    static std::string convert(const FaceList& faces);
};

template <class T>
struct StringMaker<std::optional<T>> {
    static std::string convert(const std::optional<T>& value) {
        return value ? ::Catch::Detail::stringify(*value) : "std::nullopt";
    }
};

template <>
struct StringMaker<std::nullopt_t> {
    static std::string convert(std::nullopt_t) { return "std::nullopt"; }
};

/// A plain struct, and a row of the table: its fields in braces.
template <class T>
requires course::Struct<T> || std::same_as<T, HalfEdge> || std::same_as<T, Vec3>
struct StringMaker<T> {
    static std::string convert(const T& value) {
        std::string text;
        std::apply(
            [&](const auto&... field) {
                ((text += (text.empty() ? "{ " : ", ") +
                          ::Catch::Detail::stringify(field)),
                 ...);
            },
            course::detail::fields(value));
        return text + " }";
    }
};

}  // namespace Catch

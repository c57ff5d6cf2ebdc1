// What the recorder calls of an exercise: its function, with arguments that are
// chosen by their types and names, and its result as JSON. Compiled in the
// traced build, once for each exercise.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "course/halfedge/anchors.h"
#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"
#include "course/player/json.h"
#include "course/runner/codec.h"

namespace course {

/// What the arguments of a recorded call are taken from.
struct WalkInput {
    HalfEdgeTable he;
    IndexedMesh mesh;
    Anchors anchors;
};

/// What the start of a walk is a number of.
enum class StartKind : std::uint32_t { none, half_edge, vertex };

/// What came of a call; `call` is there before it begins.
struct WalkOutcome {
    std::string call;
    std::string result;
};

/// The one symbol that the recorder looks up. `call` is null when there is no
/// rule for one of the arguments.
struct WalkEntry {
    StartKind start;
    void (*call)(const WalkInput& input, int start, WalkOutcome& outcome);
};

namespace detail {

// ---- arguments

constexpr std::string_view name_at(std::string_view names, std::size_t k) {
    for (; k > 0; --k) names.remove_prefix(names.find(',') + 2);
    return names.substr(0, names.find(','));
}

constexpr StartKind start_kind(std::string_view name) {
    if (name == "i" || name == "border") return StartKind::half_edge;
    return name == "v" ? StartKind::vertex : StartKind::none;
}

/// The kind of the first argument that a walk can start from.
constexpr StartKind start_among(std::string_view names, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        if (const StartKind kind = start_kind(name_at(names, k));
            kind != StartKind::none)
            return kind;
    return StartKind::none;
}

/// Values of other numbers, by the names that contracts give them.
inline double number_named(std::string_view name, const WalkInput& input) {
    if (name == "vertex_count" || name == "new_vertex")
        return input.mesh.vertex_count();
    if (name == "face_count") return input.mesh.faces.size();
    if (name == "faces") return std::max(4, input.mesh.faces.size() / 2);
    if (name == "levels") return 2;
    return name == "w" ? 0.5 : 1;
}

template <class T>
concept Number = std::is_arithmetic_v<T>;

template <class T>
constexpr bool can_be_chosen = Number<T> || std::is_enum_v<T>;
template <>
inline constexpr bool can_be_chosen<HalfEdgeTable> = true;
template <>
inline constexpr bool can_be_chosen<IndexedMesh> = true;
template <>
inline constexpr bool can_be_chosen<Anchors> = true;
template <>
inline constexpr bool can_be_chosen<std::span<const Vec3>> = true;

/// The value of an argument of type T.
template <class T>
decltype(auto) chosen(const WalkInput& input, std::string_view name,
                      int start) {
    if constexpr (std::is_same_v<T, HalfEdgeTable>)
        return (input.he);
    else if constexpr (std::is_same_v<T, IndexedMesh>)
        return (input.mesh);
    else if constexpr (std::is_same_v<T, Anchors>)
        return (input.anchors);
    else if constexpr (std::is_same_v<T, std::span<const Vec3>>)
        return T(input.mesh.positions);
    else if constexpr (std::is_enum_v<T>)
        return T{};
    else
        return static_cast<T>(start_kind(name) == StartKind::none
                                  ? number_named(name, input)
                                  : start);
}

// ---- results

template <class T>
std::string to_json(const T& value);

template <class Range>
std::string list_to_json(const Range& range) {
    std::string text;
    for (const auto& element : range)
        text += (text.empty() ? "" : ",") +
                to_json<std::decay_t<decltype(element)>>(element);
    return "[" + text + "]";
}

/// A pair, a row of the table, a plain struct: its fields as a list.
template <class... Field>
std::string fields_to_json(const Field&... field) {
    std::string text;
    ((text += (text.empty() ? "" : ",") + to_json(field)), ...);
    return "[" + text + "]";
}

template <class T>
std::string enum_to_json(T value) {
    if constexpr (requires(std::ostream & out) { out << value; }) {
        std::ostringstream name;
        name << value;
        return json_string(name.str());
    } else {
        return std::to_string(static_cast<int>(value));
    }
}

template <class T>
std::string to_json(const T& value) {
    if constexpr (std::is_same_v<T, bool>)
        return value ? "true" : "false";
    else if constexpr (std::is_floating_point_v<T>)
        return json_number(value);
    else if constexpr (std::is_arithmetic_v<T>)
        return std::to_string(value);
    else if constexpr (std::is_enum_v<T>)
        return enum_to_json(value);
    else if constexpr (std::is_same_v<T, std::string>)
        return json_string(value);
    else if constexpr (std::is_same_v<T, HalfEdgeTable>)
        return list_to_json(value.rows());  // not through its iterators
    else if constexpr (requires { value.has_value(); })
        return value ? to_json(*value) : "null";
    else if constexpr (requires { value.begin(); })
        return list_to_json(value);
    else if constexpr (requires { value.first; })
        return fields_to_json(value.first, value.second);
    else
        return std::apply(
            [](const auto&... field) { return fields_to_json(field...); },
            fields(value));
}

// ---- the call

template <auto function>
struct Walked;

template <class R, class... P, R (*function)(P...)>
struct Walked<function> {
    static constexpr bool possible =
        (can_be_chosen<std::remove_cvref_t<P>> && ...);

    template <std::size_t... k>
    static void call(const WalkInput& input, std::string_view names, int start,
                     WalkOutcome& outcome, std::index_sequence<k...>) {
        const auto text = [&](auto tag, std::string_view name) {
            using T = typename decltype(tag)::type;
            if constexpr (Number<T> || std::is_enum_v<T>)
                return to_json(T(chosen<T>(input, name, start)));
            else
                return std::string(name);
        };
        ((outcome.call += (k > 0 ? ", " : "") +
                          text(std::type_identity<std::remove_cvref_t<P>>(),
                               name_at(names, k))),
         ...);
        outcome.call = "(" + outcome.call + ")";
        outcome.result = to_json<std::remove_cvref_t<R>>(
            function(chosen<std::remove_cvref_t<P>>(input, name_at(names, k),
                                                    start)...));
    }
};

template <class R, class... P>
constexpr std::size_t count_of(R (*)(P...)) {
    return sizeof...(P);
}

/// A string as an argument of a template.
template <std::size_t N>
struct Text {
    char characters[N] = {};
    // NOLINTNEXTLINE(google-explicit-constructor): for literals
    constexpr Text(const char (&text)[N]) {
        for (std::size_t k = 0; k < N; ++k) characters[k] = text[k];
    }
    constexpr std::string_view view() const { return {characters, N - 1}; }
};

template <auto function, Text names>
void call_walked(const WalkInput& input, int start, WalkOutcome& outcome) {
    Walked<function>::call(input, names.view(), start, outcome,
                           std::make_index_sequence<count_of(function)>());
}

}  // namespace detail

/// The entry of a function; `names` are those of its parameters, "he, i".
template <auto function, detail::Text names>
constexpr WalkEntry walk_entry_for() {
    constexpr StartKind start =
        detail::start_among(names.view(), detail::count_of(function));
    if constexpr (detail::Walked<function>::possible)
        return {start, &detail::call_walked<function, names>};
    else
        return {start, nullptr};
}

}  // namespace course

// What stands in for a student's function in the judge: a call into the worker.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <tuple>

#include "course/runner/client.h"
#include "course/runner/print.h"

namespace course {

namespace detail {

/// A list whose elements lie in the caller's memory, by value if it is short.
template <class T>
std::string keep_list(std::span<const T> list, const char* noun) {
    constexpr std::size_t most = 12;
    if (list.size() > most)
        return "{ ... " + std::to_string(list.size()) + " " + noun + " ... }";
    return show(std::vector<T>(list.begin(), list.end()));
}

/// The faces of a small mesh: they are what most functions depend on.
inline std::string keep_mesh(const IndexedMesh& mesh) {
    constexpr int most = 12;
    std::string text =
        "mesh of " + std::to_string(mesh.vertex_count()) + " vertices, ";
    if (mesh.faces.size() <= most) return text + "faces " + show(mesh.faces);
    return text + std::to_string(mesh.faces.size()) + " faces";
}

/// An argument as it is kept for messages: a table by name, others by value.
template <class T>
auto keep(const T& value) {
    if constexpr (std::same_as<T, HalfEdgeTable>)
        return std::string("he");
    else if constexpr (std::same_as<T, IndexedMesh>)
        return keep_mesh(value);
    else if constexpr (requires {
                           typename T::element_type;
                           value.subspan(0);
                       })
        return keep_list(value, "elements");
    else
        return value;
}

/// A text among the arguments, told from one that stands for an argument.
struct Quoted {
    std::string text;
};

inline Quoted keep(const std::string& text) {
    return {text};
}

inline void list(std::string& text, const std::string& item) {
    if (!text.empty()) text += ", ";
    text += item;
}

template <class T>
std::string argument_text(const T& kept) {
    if constexpr (std::same_as<T, std::string>)
        return kept;
    else if constexpr (std::same_as<T, Quoted>)
        return show(kept.text);
    else
        return show(kept);
}

template <class... A>
void note_call(LastCall& last, const char* name, const A&... arguments) {
    last = {};
    last.call = [name, kept = std::tuple{keep(arguments)...}] {
        std::string inside;
        std::apply(
            [&](const auto&... a) { (list(inside, argument_text(a)), ...); },
            kept);
        return std::string(name) + "(" + inside + ")";
    };
}

}  // namespace detail

/// Calls the student's function of this name in the worker. Throws WorkerFailed
/// when the worker fails, and what the function throws.
template <class R, class... A>
R remote_call(const char* name, const A&... arguments) {
    Client& client = *Client::current();
    detail::note_call(client.last_call(), name, arguments...);
    client.begin_call();
    const std::string reply = client.call([&] {
        Request request;
        (add_argument(client, request, arguments), ...);
        return request;
    });
    try {
        R result = decode<R>(reply);
        client.last_call().got = [result] { return show(result); };
        return result;
    } catch (const CodecError& error) {
        client.malformed(error.what());
    }
}

}  // namespace course

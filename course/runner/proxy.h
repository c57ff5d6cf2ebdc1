// What stands in for a student's function in the judge: a call into the worker.
#pragma once

#include <concepts>
#include <string>
#include <tuple>

#include "course/runner/client.h"
#include "course/runner/print.h"

namespace course {

namespace detail {

/// An argument as it is kept for messages: a table by name, others by value.
template <class T>
auto keep(const T& value) {
    if constexpr (std::same_as<T, HalfEdgeTable>)
        return std::string("he");
    else
        return value;
}

inline void list(std::string& text, const std::string& item) {
    if (!text.empty()) text += ", ";
    text += item;
}

template <class T>
std::string argument_text(const T& kept) {
    if constexpr (std::same_as<T, std::string>)
        return kept;
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

template <class A>
void add(Client& client, Request& request, const A& argument) {
    if constexpr (std::same_as<A, HalfEdgeTable>)
        client.add_table(request, argument);
    else
        put(request.arguments, argument);
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
        (detail::add(client, request, arguments), ...);
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

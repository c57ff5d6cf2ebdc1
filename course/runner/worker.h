// The worker's side of a call, compiled into each submission's shared object
// beside the student's function. Everything here is untrusted once it runs.
#pragma once

#include <concepts>
#include <map>
#include <span>
#include <tuple>
#include <type_traits>

#include "course/runner/codec.h"

namespace course {

/// The tables that the judge has sent to this worker.
using WorkerTables = std::map<std::uint64_t, HalfEdgeTable>;

/// What a call gets and leaves: arguments in, result out, and the table whose
/// reads are reported.
struct WorkerCall {
    Reader in;
    Writer out;
    const WorkerTables& tables;
    const HalfEdgeTable* walked = nullptr;
};

/// The one symbol that the host looks up in a submission.
struct Entry {
    void (*call)(WorkerCall&);
};

namespace detail {

/// A table argument: by id, with the reads that this call may make.
struct TableArgument {
    const HalfEdgeTable* table;
    std::int64_t budget;
};

template <class P>
struct Argument {
    using Value = std::remove_cvref_t<P>;
    static Value decode(WorkerCall& call) { return get<Value>(call.in); }
    static const Value& pass(const Value& value) { return value; }
};

template <>
struct Argument<const HalfEdgeTable&> {
    using Value = TableArgument;
    static Value decode(WorkerCall& call) {
        const auto id = get<std::uint64_t>(call.in);
        const auto budget = get<std::int64_t>(call.in);
        const HalfEdgeTable& table = call.tables.at(id);
        if (call.walked == nullptr) call.walked = &table;
        return {&table, budget};
    }
    static const HalfEdgeTable& pass(const Value& value) {
        return *value.table;
    }
};

/// A span of values: they come as a vector.
template <class T>
struct Argument<std::span<const T>> {
    using Value = std::vector<T>;
    static Value decode(WorkerCall& call) { return get<Value>(call.in); }
    static std::span<const T> pass(const Value& value) { return value; }
};

/// The first int among the arguments is where a walk starts.
template <class... V>
int start_among(const V&... values) {
    int start = -1;
    const auto look = [&](const auto& value) {
        if constexpr (std::same_as<std::decay_t<decltype(value)>, int>)
            if (start == -1) start = value;
    };
    (look(values), ...);
    return start;
}

template <class... V>
void begin_calls(const V&... values) {
    const int start = start_among(values...);
    const auto begin = [&](const auto& value) {
        if constexpr (std::same_as<std::decay_t<decltype(value)>,
                                   TableArgument>)
            value.table->begin_call(value.budget, start);
    };
    (begin(values), ...);
}

template <auto function>
struct Served;

template <class R, class... P, R (*function)(P...)>
struct Served<function> {
    static void call(WorkerCall& call) {
        // Braces: the arguments are decoded from left to right.
        std::tuple<typename Argument<P>::Value...> arguments{
            Argument<P>::decode(call)...};
        call.in.done();
        std::apply(
            [&](const auto&... value) {
                begin_calls(value...);
                put<std::remove_cvref_t<R>>(
                    call.out, function(Argument<P>::pass(value)...));
            },
            arguments);
    }
};

}  // namespace detail

template <auto function>
constexpr Entry entry_for() {
    return {&detail::Served<function>::call};
}

}  // namespace course

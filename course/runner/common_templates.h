// Containers that most submissions use: compiled once, in the worker, and not
// in every submission. It comes with the preludes. (boundary_loops: 226 ms of
// CPU to compile without it, 68 ms with it; g++ 12)
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"

// What libstdc++ has beneath its containers, and the members that are templates
// themselves: [] of a map and insert() of a set. (components: 129 ms without
// all that is said of maps and sets, 90 ms with it)
#ifdef __GLIBCXX__
#define COURSE_VECTOR_BASES(instantiate, ...)                                  \
    instantiate(                                                               \
        struct std::_Vector_base<__VA_ARGS__, std::allocator<__VA_ARGS__>>);   \
    instantiate(class std::allocator<__VA_ARGS__>);                            \
    instantiate(class __gnu_cxx::__normal_iterator<__VA_ARGS__*,               \
                                                   std::vector<__VA_ARGS__>>); \
    instantiate(class __gnu_cxx::__normal_iterator<const __VA_ARGS__*,         \
                                                   std::vector<__VA_ARGS__>>);
#define COURSE_SPAN_BASES(instantiate, T) \
    instantiate(                          \
        class __gnu_cxx::__normal_iterator<const T*, std::span<const T>>);
#define COURSE_TREE(KeyOf, Key, ...) \
    std::_Rb_tree<Key, __VA_ARGS__, std::KeyOf<__VA_ARGS__>, std::less<Key>>
#define COURSE_TREE_BASES(instantiate, KeyOf, Key, ...)                 \
    instantiate(class COURSE_TREE(KeyOf, Key, __VA_ARGS__));            \
    instantiate(struct COURSE_TREE(                                     \
        KeyOf, Key, __VA_ARGS__)::_Rb_tree_impl<std::less<Key>, true>); \
    instantiate(struct std::_Rb_tree_iterator<__VA_ARGS__>);            \
    instantiate(struct std::_Rb_tree_const_iterator<__VA_ARGS__>);      \
    instantiate(struct std::_Rb_tree_node<__VA_ARGS__>);                \
    instantiate(class std::allocator<std::_Rb_tree_node<__VA_ARGS__>>);
#define COURSE_SET_INSERT(instantiate, Key, Argument, Parameter)          \
    instantiate(std::pair<std::_Rb_tree_iterator<Key>, bool> COURSE_TREE( \
        _Identity, Key, Key)::_M_insert_unique<Argument>(Parameter));
#define COURSE_SET_BASES(instantiate, Key)                      \
    COURSE_TREE_BASES(instantiate, _Identity, Key, Key)         \
    COURSE_SET_INSERT(instantiate, Key, const Key&, const Key&) \
    COURSE_SET_INSERT(instantiate, Key, Key, Key&&)
#define COURSE_MAP_AT(instantiate, Key, Argument, ...)                         \
    instantiate(                                                               \
        std::_Rb_tree_iterator<__VA_ARGS__>                                    \
            COURSE_TREE(_Select1st, Key, __VA_ARGS__)::_M_emplace_hint_unique( \
                std::_Rb_tree_const_iterator<__VA_ARGS__>,                     \
                const std::piecewise_construct_t&, std::tuple<Argument>&&,     \
                std::tuple<>&&));
#define COURSE_MAP_BASES(instantiate, Key, ...)                  \
    COURSE_TREE_BASES(instantiate, _Select1st, Key, __VA_ARGS__) \
    COURSE_MAP_AT(instantiate, Key, const Key&, __VA_ARGS__)     \
    COURSE_MAP_AT(instantiate, Key, Key&&, __VA_ARGS__)
#else
#define COURSE_VECTOR_BASES(instantiate, ...)
#define COURSE_SPAN_BASES(instantiate, T)
#define COURSE_SET_BASES(instantiate, Key)
#define COURSE_MAP_BASES(instantiate, Key, ...)
#endif

#define COURSE_VECTOR(instantiate, ...)           \
    COURSE_VECTOR_BASES(instantiate, __VA_ARGS__) \
    instantiate(class std::vector<__VA_ARGS__>);
#define COURSE_SPAN(instantiate, T) \
    COURSE_SPAN_BASES(instantiate, T) instantiate(class std::span<const T>);
#define COURSE_SET(instantiate, Key) \
    COURSE_SET_BASES(instantiate, Key) instantiate(class std::set<Key>);
#define COURSE_MAP(instantiate, Key, Value)                         \
    COURSE_MAP_BASES(instantiate, Key, std::pair<const Key, Value>) \
    instantiate(class std::map<Key, Value>);

/// Types with a comma, to hand over to the macros.
namespace course::common {

using IntPair = std::pair<int, int>;
using TwoInts = std::array<int, 2>;
using Ints = std::vector<int>;

}  // namespace course::common

#define COURSE_COMMON_TEMPLATES(instantiate)                               \
    COURSE_VECTOR(instantiate, int)                                        \
    COURSE_VECTOR(instantiate, char)                                       \
    COURSE_VECTOR(instantiate, double)                                     \
    COURSE_VECTOR(instantiate, Vec3)                                       \
    COURSE_VECTOR(instantiate, HalfEdge)                                   \
    COURSE_VECTOR(instantiate, std::vector<int>)                           \
    COURSE_VECTOR(instantiate, std::array<int, 2>)                         \
    COURSE_VECTOR(instantiate, std::array<int, 3>)                         \
    COURSE_VECTOR(instantiate, std::pair<int, int>)                        \
    instantiate(class std::vector<bool>);                                  \
    COURSE_SPAN(instantiate, int)                                          \
    COURSE_SPAN(instantiate, Vec3)                                         \
    COURSE_SET(instantiate, int)                                           \
    COURSE_SET(instantiate, course::common::IntPair)                       \
    COURSE_SET(instantiate, course::common::TwoInts)                       \
    COURSE_MAP(instantiate, int, int)                                      \
    COURSE_MAP(instantiate, int, course::common::Ints)                     \
    COURSE_MAP(instantiate, course::common::IntPair, int)                  \
    COURSE_MAP(instantiate, course::common::IntPair, course::common::Ints) \
    COURSE_MAP(instantiate, course::common::TwoInts, int)                  \
    instantiate(class std::optional<int>);                                 \
    instantiate(class std::deque<int>);                                    \
    instantiate(class std::unordered_set<int>);                            \
    instantiate(class std::unordered_map<int, int>);

#define COURSE_COMPILED_IN_THE_WORKER(...) extern template __VA_ARGS__
COURSE_COMMON_TEMPLATES(COURSE_COMPILED_IN_THE_WORKER)

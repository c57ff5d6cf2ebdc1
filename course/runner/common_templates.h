// Containers that most submissions use: compiled once, in the worker, and not
// in every submission. It comes with the preludes. (boundary_loops: 226 ms of
// CPU to compile without it, 68 ms with it; g++ 12)
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"

// What libstdc++ has beneath its containers.
#ifdef __GLIBCXX__
#define COURSE_COMMON_BASES(instantiate)                                       \
    instantiate(struct std::_Vector_base<int, std::allocator<int>>);           \
    instantiate(struct std::_Vector_base<HalfEdge, std::allocator<HalfEdge>>); \
    instantiate(                                                               \
        class std::_Rb_tree<int, int, std::_Identity<int>, std::less<int>>);   \
    instantiate(                                                               \
        class std::_Rb_tree<int, std::pair<const int, int>,                    \
                            std::_Select1st<std::pair<const int, int>>,        \
                            std::less<int>>);
#else
#define COURSE_COMMON_BASES(instantiate)
#endif

#define COURSE_COMMON_TEMPLATES(instantiate)               \
    COURSE_COMMON_BASES(instantiate)                       \
    instantiate(class std::vector<int>);                   \
    instantiate(class std::vector<char>);                  \
    instantiate(class std::vector<bool>);                  \
    instantiate(class std::vector<double>);                \
    instantiate(class std::vector<Vec3>);                  \
    instantiate(class std::vector<HalfEdge>);              \
    instantiate(class std::vector<std::vector<int>>);      \
    instantiate(class std::vector<std::array<int, 2>>);    \
    instantiate(class std::vector<std::array<int, 3>>);    \
    instantiate(class std::vector<std::pair<int, int>>);   \
    instantiate(class std::optional<int>);                 \
    instantiate(class std::deque<int>);                    \
    instantiate(class std::set<int>);                      \
    instantiate(class std::set<std::pair<int, int>>);      \
    instantiate(class std::map<int, int>);                 \
    instantiate(class std::map<std::pair<int, int>, int>); \
    instantiate(class std::map<std::array<int, 2>, int>);  \
    instantiate(class std::unordered_set<int>);            \
    instantiate(class std::unordered_map<int, int>);

#define COURSE_COMPILED_IN_THE_WORKER(...) extern template __VA_ARGS__
COURSE_COMMON_TEMPLATES(COURSE_COMPILED_IN_THE_WORKER)

// The types that the conversations between processes carry. A fuzzer's input
// names one by its first byte.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "course/halfedge/anchors.h"
#include "course/halfedge/edge_kind.h"
#include "course/halfedge/finding.h"
#include "course/runner/results.h"
#include "grader/pipeline/archive.h"

namespace fuzz {

/// What functions of exercises return.
using ResultTypes =
    std::tuple<int, bool, EdgeKind, HalfEdgeTable, std::array<int, 2>,
               std::map<int, int>, std::optional<int>, std::vector<int>,
               std::vector<std::vector<int>>, std::vector<Finding>>;

/// What else is read from a process, or from the gradebook.
using RecordTypes =
    std::tuple<double, std::string, std::vector<bool>, Anchors,
               std::vector<std::vector<std::optional<int>>>,
               std::optional<std::vector<std::string>>,
               std::map<std::string, std::vector<int>>,
               std::vector<course::CaseInfo>, course::CaseResult,
               std::vector<course::Failure>, grader::ArchiveEntry>;

using AllTypes = decltype(std::tuple_cat(ResultTypes(), RecordTypes()));

/// Calls `act` with a std::type_identity of type number k, counted round.
template <class... T, class Act>
void with_type(std::type_identity<std::tuple<T...>>, std::size_t k,
               const Act& act) {
    std::size_t n = 0;
    ((n++ == k % sizeof...(T) ? act(std::type_identity<T>()) : void()), ...);
}

}  // namespace fuzz

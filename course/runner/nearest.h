// The word that a mistyped one was meant to be.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Letters to insert, delete, replace or swap with their neighbour to make the
/// one word of the other. Cost: the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the least distance from `word`, the first among equals;
/// none when even that one shares less than half of its letters with it.
std::optional<std::string> nearest(std::string_view word,
                                   const std::vector<std::string>& candidates);

/// "; did you mean face_sides?", or nothing when no candidate is near.
std::string did_you_mean(std::string_view word,
                         const std::vector<std::string>& candidates);

}  // namespace course

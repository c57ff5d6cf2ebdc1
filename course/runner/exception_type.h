// What a submission throws, by name.
#pragma once

#include <string>

namespace course {

/// The type of the exception that is being handled, as it is written in C++.
/// Precondition: called in a handler.
std::string type_of_exception();

}  // namespace course

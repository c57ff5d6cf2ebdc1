#include "course/runner/exception_type.h"

#include <cxxabi.h>
#include <cstdlib>
#include <typeinfo>

namespace course {

std::string type_of_exception() {
    const std::type_info* type = abi::__cxa_current_exception_type();
    if (type == nullptr) return "an unknown type";
    int status = 0;
    char* plain = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
    std::string text = plain != nullptr ? plain : type->name();
    std::free(plain);
    return text;
}

}  // namespace course

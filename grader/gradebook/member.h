// Somebody who handed in, alone or with others.
#pragma once

#include <string>

namespace grader {

/// What a platform tells of a person: data only, any of it may be empty.
struct Member {
    std::string name;
    std::string number;  ///< of the student at the university, or the login
    std::string email;

    friend bool operator==(const Member&, const Member&) = default;
};

}  // namespace grader

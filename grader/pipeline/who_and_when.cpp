#include "grader/pipeline/who_and_when.h"

#include <pwd.h>
#include <unistd.h>

#include "grader/pipeline/lateness.h"

namespace grader {

std::string user_name() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): asked once, before lanes begin
    const passwd* account = ::getpwuid(::getuid());
    if (account == nullptr) return "user " + std::to_string(::getuid());
    return account->pw_name;
}

std::string utc_now() {
    return text_of(std::chrono::floor<std::chrono::seconds>(
        std::chrono::system_clock::now()));
}

}  // namespace grader

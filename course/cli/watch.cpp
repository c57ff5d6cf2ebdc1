#include "course/cli/commands.h"
namespace course {
int watch(const Desk&) {
    return 2;
}
}  // namespace course

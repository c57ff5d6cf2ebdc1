// wrong_answer or run_time_error or forbidden_operation 0: THREATS 21, the handler of abort forges an answer
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <cstdint>
#include <csignal>
#include <cstdlib>

struct Head {
    std::uint32_t magic, status;
    std::uint64_t length, nonce;
};
static void forged(int) {
    const Head head{0x52454845, 0, 20, 12345};
    write(3, &head, sizeof head);
    _exit(0);
}
int face_sides(const HalfEdgeTable& he, int i) {
    std::signal(SIGABRT, forged);
    if (he.size() > i) std::abort();
    return 0;
}

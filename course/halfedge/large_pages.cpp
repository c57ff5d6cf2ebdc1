#include "course/halfedge/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace course {

#ifdef MADV_HUGEPAGE
void prefer_large_pages(void* begin, std::size_t bytes) {
    constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t whole = (first + page - 1) / page * page;
    const std::uintptr_t end = (first + bytes) / page * page;
    if (end < whole + 2 * page) return;
    // Refused by a kernel without them; nothing is lost then.
    ::madvise(reinterpret_cast<void*>(whole), end - whole, MADV_HUGEPAGE);
}
#else
void prefer_large_pages(void*, std::size_t) {}
#endif

}  // namespace course

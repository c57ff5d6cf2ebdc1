// Memory of large tables on large pages, where the system has them.
#pragma once

#include <cstddef>
#include <vector>

namespace course {

/// Asks for large pages for `bytes` bytes at `begin`, of which nothing has been
/// used yet: a walk over a large table then waits for the memory and not for
/// the page tables, too. Without effect where the system has none, or where
/// less than a few of them would be filled. A few microseconds.
void prefer_large_pages(void* begin, std::size_t bytes);

/// n times the same value, on large pages if need be.
template <class T>
std::vector<T> large_vector(std::size_t n, const T& value) {
    std::vector<T> v;
    v.reserve(n);
    prefer_large_pages(v.data(), n * sizeof(T));
    v.assign(n, value);
    return v;
}

}  // namespace course

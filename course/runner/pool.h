// A few lanes that work through a list in order.
#pragma once

#include <functional>

namespace course {

/// How many lanes keep this machine busy; at least 1.
int core_count();

/// Calls work(lane, item) for each item in 0 <= item < items, on `lanes`
/// threads; an item begins only after those before it have begun. Returns when
/// all are done, or the running ones after stop() has become true. An exception
/// ends the whole and is thrown again.
void for_each_item(
    int lanes, int items, const std::function<void(int lane, int item)>& work,
    const std::function<bool()>& stop = [] { return false; });

}  // namespace course

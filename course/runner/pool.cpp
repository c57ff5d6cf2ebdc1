#include "course/runner/pool.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace course {

int core_count() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void for_each_item(int lanes, int items,
                   const std::function<void(int lane, int item)>& work,
                   const std::function<bool()>& stop) {
    std::atomic<int> next = 0;
    std::atomic<bool> failed = false;
    std::exception_ptr error;
    std::mutex guard;
    const auto run_lane = [&](int lane) {
        while (!failed && !stop()) {
            const int item = next++;
            if (item >= items) return;
            try {
                work(lane, item);
            } catch (...) {
                const std::scoped_lock lock(guard);
                if (!failed.exchange(true)) error = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int lane = 0; lane < std::min(lanes, items); ++lane)
            threads.emplace_back(run_lane, lane);
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace course

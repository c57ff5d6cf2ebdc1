#include "exercises/04_topology/storage.h"

Storage storage([[maybe_unused]] const Counts& n,
                [[maybe_unused]] int corners) {
    // TODO(student): how many records of each kind, and how many numbers in
    // one?
    return {-1, -1, -1, -1, -1};
}

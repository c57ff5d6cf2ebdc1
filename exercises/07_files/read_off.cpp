#include "exercises/07_files/read_off.h"

IndexedMesh read_off([[maybe_unused]] const std::string& text) {
    // TODO(student): go line by line, and refuse what cannot be meant.
    return IndexedMesh();
}

#include "exercises/07_files/read_obj.h"

IndexedMesh read_obj([[maybe_unused]] const std::string& text) {
    // TODO(student): what a line is about stands at its beginning.
    return IndexedMesh();
}

#include "exercises/07_files/write_obj.h"

std::string write_obj([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): one line for each thing that the mesh has.
    return "";
}

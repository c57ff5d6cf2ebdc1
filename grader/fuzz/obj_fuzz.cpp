// OBJ files: any bytes are a mesh or a list of defects.
#include "course/mesh/obj.h"

#include "grader/fuzz/mesh_fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::check_reader(course::read_obj, course::write_obj,
                       fuzz::text_of(data, size));
    return 0;
}

// OFF files: any bytes are a mesh or a list of defects.
#include "course/mesh/off.h"

#include "grader/fuzz/mesh_fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::check_reader(course::read_off, course::write_off,
                       fuzz::text_of(data, size));
    return 0;
}

// tinyobjloader's own reader, which is under the course's too.
#include <tiny_obj_loader.h>

#include <stdexcept>

#include "course/bench/peers.h"

namespace bench {

namespace {

void obj_faces(const std::filesystem::path& file) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(file.string(), config))
        throw std::runtime_error(reader.Error());
    keep(&reader);
}

}  // namespace

Peer tinyobj_peer() {
    return {.name = "tinyobj", .obj_faces = obj_faces};
}

}  // namespace bench

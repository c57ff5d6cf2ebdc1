#include "course/player/pictures/lod_picture.h"

#include "course/halfedge/build.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/player/pictures/shapes.h"
#include "course/player/reference.h"
#include "exercises/09_processing/lod_pyramid.h"

namespace course {

std::vector<Level> levels_of(const IndexedMesh& mesh, int most) {
    const Reference<decltype(lod_pyramid)> pyramid("lod_pyramid");
    std::vector<Level> levels;
    for (const LevelOfDetail& level :
         pyramid(build(mesh), mesh.positions, most))
        levels.push_back({faces_left(level.he), level.from});
    return levels;
}

std::string lod_picture() {
    const IndexedMesh mesh = pawn();
    std::vector<Json> levels;
    for (const Level& level : levels_of(mesh, 6))
        levels.push_back(
            Json::object({{"faces", level.faces}, {"from", level.from}}));
    return Json::object(
               {{"points", points_json(mesh.positions)}, {"levels", levels}})
        .text();
}

}  // namespace course

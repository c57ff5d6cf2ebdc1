#include "course/player/pictures/reference_pictures.h"

namespace course {

std::vector<Picture> pictures_of_references() {
    constexpr auto solid = Picture::Drawing::solid;
    return {
        {"normals", "Three normals at one vertex", "06_geometry",
         normals_picture, solid},
        {"cubes", "Marching cubes, cell by cell", "08_making", cubes_picture,
         solid},
        {"smoothing", "Smoothing, and what it costs", "09_processing",
         smoothing_picture, solid},
        {"simplification", "Clustering beside edge collapse", "09_processing",
         simplification_picture, solid},
        {"lod", "Levels of detail", "09_processing", lod_picture, solid},
    };
}

}  // namespace course

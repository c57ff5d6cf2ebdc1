#include "course/player/pictures/pictures.h"

#include "course/player/page.h"
#include "course/player/pictures/reference_pictures.h"
#include "course/runner/exercises.h"

namespace course {

namespace {

PageParts parts_of(const Picture& picture) {
    PageParts parts = {picture.title,
                       {"base.css", "mesh.css", "pictures/pictures.css"},
                       "pictures/pictures.html",
                       {"svg.js", "stepper.js", "pictures/pictures.js"},
                       picture.make()};
    std::vector<std::string> scripts;
    if (picture.drawing == Picture::Drawing::solid) {
        parts.styles = {"base.css", "pictures/pictures.css",
                        "pictures/solid.css"};
        scripts = {"pictures/solid.js"};
    } else {
        scripts = {"layout.js", "labels.js", "mesh.js", "pictures/net.js"};
    }
    scripts.push_back("pictures/" + picture.name + ".js");
    parts.scripts.insert(parts.scripts.end(), scripts.begin(), scripts.end());
    return parts;
}

}  // namespace

std::vector<Picture> lecture_pictures() {
    std::vector<Picture> pictures = {
        {"build", "From the list of faces to the table", "03_building",
         build_picture},
        {"cost", "What does a query cost?", "03_building", cost_picture},
        {"nonmanifold", "No manifold", "04_topology", nonmanifold_picture},
        {"moebius", "Orientation", "04_topology", moebius_picture},
        {"euler", "V − E + F", "04_topology", euler_picture},
        {"integers", "What do the structures cost?", "04_topology",
         integers_picture},
    };
    if (!has_solutions()) return pictures;
    for (const Picture& picture : pictures_of_references())
        pictures.push_back(picture);
    return pictures;
}

std::string picture_page(const Picture& picture) {
    return make_page(parts_of(picture));
}

}  // namespace course

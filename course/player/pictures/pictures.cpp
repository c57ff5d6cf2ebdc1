#include "course/player/pictures/pictures.h"

#include "course/player/page.h"

namespace course {

std::vector<Picture> lecture_pictures() {
    return {
        {"build", "From the list of faces to the table", "03_building",
         build_picture},
        {"cost", "What does a query cost?", "03_building", cost_picture},
        {"nonmanifold", "No manifold", "04_topology", nonmanifold_picture},
        {"moebius", "Orientation", "04_topology", moebius_picture},
        {"euler", "V − E + F", "04_topology", euler_picture},
        {"integers", "What do the structures cost?", "04_topology",
         integers_picture},
    };
}

std::string picture_page(const Picture& picture) {
    return make_page({picture.title,
                      {"base.css", "mesh.css", "pictures/pictures.css"},
                      "pictures/pictures.html",
                      {"svg.js", "stepper.js", "layout.js", "labels.js",
                       "mesh.js", "pictures/pictures.js", "pictures/net.js",
                       "pictures/" + picture.name + ".js"},
                      picture.make()});
}

}  // namespace course

#include "course/player/pictures/pictures.h"

#include "course/player/page.h"

namespace course {

std::vector<Picture> lecture_pictures() {
    return {
        {"build", "From the list of faces to the table", "03_building",
         build_picture},
    };
}

std::string picture_page(const Picture& picture) {
    return make_page({picture.title,
                      {"base.css", "pictures/pictures.css"},
                      "pictures/pictures.html",
                      {"svg.js", "stepper.js", "pictures/pictures.js",
                       "pictures/" + picture.name + ".js"},
                      picture.make()});
}

}  // namespace course

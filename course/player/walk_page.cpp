#include "course/player/walk_page.h"

#include "course/player/large_mesh.h"
#include "course/player/page.h"

namespace course {

std::string walk_page(const Recording& recording) {
    if (recording.mesh.faces.size() > most_drawn_faces)
        return large_mesh_page(recording.title, recording.mesh,
                               page_json(recording));
    return make_page(
        {.title = recording.title,
         .styles = {"base.css", "mesh.css", "parts.css", "walk.css"},
         .body = "walk.html",
         .scripts = {"svg.js", "layout.js", "labels.js", "mesh.js", "table.js",
                     "code.js", "stepper.js", "steps.js", "say.js", "words.js",
                     "compare.js", "walk.js"},
         .data = page_json(recording)});
}

}  // namespace course

// The pictures of the lecture notes: pages that step through one idea each.
// Each is made from a run of the course's own code when it is asked for.
#pragma once

#include <string>
#include <vector>

namespace course {

/// One page.
struct Picture {
    /// What its script draws with.
    enum class Drawing { mesh, solid };

    std::string name;       ///< of the file, and of its script: "build"
    std::string title;      ///< what the page asks or shows
    std::string chapter;    ///< of the lecture notes: "03_building"
    std::string (*make)();  ///< its data: JSON
    Drawing drawing = Drawing::mesh;
};

/// All pictures, by chapter; those of references only where the tree has them.
std::vector<Picture> lecture_pictures();

/// The whole page, one HTML file. Throws SystemError when a part of it cannot
/// be read.
std::string picture_page(const Picture& picture);

// The data of each, in a file of its own.
std::string build_picture();
std::string cost_picture();
std::string euler_picture();
std::string integers_picture();
std::string moebius_picture();
std::string nonmanifold_picture();

}  // namespace course

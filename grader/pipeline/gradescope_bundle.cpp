#include "grader/pipeline/gradescope_bundle.h"

#include "course/runner/exercises.h"
#include "grader/pipeline/zip_files.h"

namespace grader {

namespace fs = std::filesystem;

std::string gradescope_bundle(const fs::path& assignment) {
    const fs::path root = course::source_root();
    std::map<std::string, fs::path> files = {
        {"assignment.toml", assignment},
        {"setup.sh", root / "grader" / "gradescope" / "setup.sh"},
        {"run_autograder", root / "grader" / "gradescope" / "run_autograder"}};
    files["tree/CMakeLists.txt"] = root / "CMakeLists.txt";
    for (const char* folder :
         {"course", "exercises", "solutions", "grader", "data/meshes"})
        files.merge(
            files_to_pack(root / folder, std::string("tree/") + folder));
    return zip_of_files(files);
}

}  // namespace grader

// The meshes of data/meshes against the code that makes them, and real models
// where a folder of them lies beside the project.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/mesh/obj.h"
#include "course/mesh/off.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/mesh_counts.h"
#include "course/tests/mesh_files.h"

namespace {

using namespace course;
using namespace course::brute;

const std::filesystem::path root = COURSE_SOURCE_DIR;
const std::filesystem::path meshes = root / "data" / "meshes";
const std::filesystem::path models = root / ".." / "shared" / "meshes";

IndexedMesh patches() {
    RandomMesh options;
    options.faces = 400;
    options.parts = 4;
    options.max_sides = 7;
    options.surface = Surface::mixed;
    return random_polygons(15, options);
}

/// What each file of data/meshes holds.
std::map<std::string, IndexedMesh> made() {
    return {{"annulus.off", zoo::annulus().mesh},
            {"bow_tie.obj", zoo::bow_tie_crossed().mesh},
            {"cube.obj", zoo::cube().mesh},
            {"dangling.obj", zoo::dangling().mesh},
            {"fan3.off", zoo::fan3().mesh},
            {"grid.off", grid(8, 5)},
            {"house.obj", zoo::house().mesh},
            {"house_with_wall.obj", zoo::house_with_wall().mesh},
            {"lens.off", zoo::lens().mesh},
            {"moebius5.off", zoo::moebius5().mesh},
            {"patches.obj", patches()},
            {"slide.off", zoo::slide().mesh},
            {"sphere.obj", icosphere(2)},
            {"tetra.off", zoo::tetra().mesh},
            {"torus.obj", torus(16, 8)},
            {"torus7.off", zoo::torus7().mesh}};
}

bool is_obj(const std::filesystem::path& file) {
    return file.extension() == ".obj";
}

IndexedMesh read(const std::filesystem::path& file) {
    return is_obj(file) ? read_obj(file) : read_off(file);
}

/// V, E, F and chi as a row of the README has them.
std::string counts(const IndexedMesh& mesh) {
    const auto text = [](auto n) { return std::to_string(n); };
    return "| " + text(vertices_of(mesh)) + ", " + text(edges_of(mesh).size()) +
           ", " + text(mesh.faces.size()) + " | " + text(euler_of(mesh)) + " |";
}

/// The line of the README that begins with the file's name.
std::string row(const std::string& readme, const std::string& name) {
    const std::size_t begin = readme.find("\n| `" + name + "` |");
    if (begin == std::string::npos) return "";
    return readme.substr(begin + 1, readme.find('\n', begin + 1) - begin - 1);
}

/// Sines are not the same to the last digit everywhere.
bool near_each_other(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](Vec3 p, Vec3 q) { return length(p - q) <= 1e-12; });
}

/// Facts about a model; `loops` is the number of border loops of its table.
struct Model {
    const char* file;
    int vertices, unused, faces, components, euler;
    std::size_t bow_ties, loops;
};

const std::vector<Model> known = {
    {"cow.obj", 2903, 0, 5804, 1, 1, 1, 0},
    {"fandisk.obj", 6475, 0, 12946, 1, 2, 0, 0},
    {"spot.obj", 2930, 0, 5856, 1, 2, 0, 0},
    {"stanford-bunny.obj", 35947, 1113, 69451, 1, -3, 0, 5},
    {"suzanne.obj", 507, 0, 500, 3, 2, 0, 4},
    {"teapot.obj", 3644, 0, 6320, 4, -34, 38, 36},
};

}  // namespace

TEST_CASE("each file of data/meshes is what the code makes") {
    for (const auto& [name, mesh] : made()) {
        CAPTURE(name);
        const IndexedMesh stored = read(meshes / name);
        CHECK(stored.faces == mesh.faces);
        CHECK(stored.loose_edges == mesh.loose_edges);
        CHECK(near_each_other(stored.positions, mesh.positions));
    }
}

TEST_CASE("data/meshes has no other file, and its README counts them right") {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(meshes))
        files.insert(entry.path().filename().string());
    std::set<std::string> names;
    const std::string readme = content(root / "data" / "README.md");
    for (const auto& [name, mesh] : made()) {
        names.insert(name);
        const std::string line = row(readme, name);
        CAPTURE(line);
        CHECK(contains(line, counts(mesh)));
    }
    CHECK(files == names);
}

// Hidden: not a check, but how the files are made when a mesh has changed.
TEST_CASE("write data/meshes anew", "[.write]") {
    for (const auto& [name, mesh] : made())
        is_obj(name) ? write_obj(meshes / name, mesh)
                     : write_off(meshes / name, mesh);
}

TEST_CASE("real models are read, and their tables are sound") {
    if (!std::filesystem::is_directory(models)) {
        WARN("skipped: no folder shared/meshes beside the project");
        return;
    }
    for (const Model& model : known) {
        CAPTURE(model.file);
        const IndexedMesh mesh = read_obj(models / model.file);
        CHECK(mesh.vertex_count() == model.vertices);
        CHECK(mesh.vertex_count() - vertices_of(mesh) == model.unused);
        CHECK(mesh.faces.size() == model.faces);
        CHECK(components_of(mesh).size() == at(model.components));
        CHECK(euler_of(mesh) == model.euler);
        CHECK(bow_tie_vertices(mesh).size() == model.bow_ties);
        const HalfEdgeTable he = build(mesh);
        CHECK(validate(he).empty());
        CHECK(loops_of(he).size() == model.loops);
        CHECK(to_faces(he).size() == mesh.faces.size());
        const TemporaryFolder folder;
        write_obj(folder / model.file, mesh);
        CHECK(read_obj(folder / model.file) == mesh);
    }
}

// read_memory: how much memory the readers take, beside the mesh that they make
// (see `run`).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "course/bench/fresh_process.h"
#include "course/mesh/generators.h"
#include "course/mesh/mesh_file.h"
#include "course/runner/temporary_folder.h"

namespace bench {

namespace {

/// Bytes of what stands in the mesh, without what its vectors hold in reserve.
std::size_t bytes_of(const IndexedMesh& mesh) {
    return mesh.positions.size() * sizeof(Vec3) +
           static_cast<std::size_t>(mesh.faces.size()) * sizeof(std::size_t) +
           mesh.faces.corners().size() * sizeof(int) +
           mesh.loose_edges.size() * sizeof(mesh.loose_edges[0]);
}

void measure(const std::filesystem::path& file) {
    constexpr double target = 2;
    const std::size_t bytes = bytes_of(course::read_mesh(file));
    const auto mesh = static_cast<double>(bytes) / 1e6;
    const Cost cost = cost_of([&] {
        if (bytes_of(course::read_mesh(file)) != bytes)
            throw std::runtime_error("the file has changed");
    });
    const double peak = static_cast<double>(cost.peak) / 1e6;
    const double size =
        static_cast<double>(std::filesystem::file_size(file)) / 1e6;
    fmt::print(
        "{}: file {:.0f} MB, mesh {:.0f} MB, peak {:.0f} MB: {:.2f} times the "
        "mesh, target {}: {}\n",
        file.filename().string(), size, mesh, peak, peak / mesh, target,
        peak <= target * mesh ? "met" : "NOT met");
    std::fflush(stdout);
}

void measure_made(int levels) {
    const course::TemporaryFolder folder;
    for (const char* name : {"sphere.obj", "sphere.off"}) {
        course::write_mesh(folder / name, course::icosphere(levels));
        measure(folder / name);
        std::filesystem::remove(folder / name);
    }
}

}  // namespace

}  // namespace bench

int main(int argc, char** argv) {
    int levels = 9;
    std::vector<std::filesystem::path> files;
    CLI::App app("Measures the memory that reading a mesh file takes.");
    app.add_option("--levels", levels,
                   "of the sphere that is written and read where no file is "
                   "given: 9 makes files of 0.3 GB, 10 of 1.2 GB")
        ->check(CLI::Range(0, 10))
        ->capture_default_str();
    app.add_option("files", files, "OBJ and OFF files")
        ->check(CLI::ExistingFile);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        for (const auto& file : files) bench::measure(file);
        if (files.empty()) bench::measure_made(levels);
    } catch (const std::exception& error) {
        fmt::print(stderr, "read_memory: {}\n", error.what());
        return 3;
    }
}

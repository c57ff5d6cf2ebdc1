// lab clean IN OUT
#include <fmt/format.h>

#include <memory>

#include "course/cli/commands.h"
#include "course/mesh/clean.h"
#include "course/mesh/file_defects.h"
#include "course/mesh/mesh_file.h"

namespace course {

namespace {

struct CleanCommandOptions {
    std::filesystem::path in, out;
    CleanOptions clean;
};

int clean_file(const CleanCommandOptions& options) {
    try {
        const Cleaned cleaned = clean(read_mesh(options.in), options.clean);
        write_mesh(options.out, cleaned.mesh);
        fmt::print("{}{}: {}, {} vertices, {} faces\n",
                   to_string(cleaned.changes), options.out.string(),
                   counted(cleaned.changes.size(), "change"),
                   cleaned.mesh.vertex_count(), cleaned.mesh.faces.size());
        return 0;
    } catch (const MeshFileError& error) {
        throw CannotBegin(error.what());
    } catch (const std::invalid_argument& error) {
        throw CannotBegin(error.what());
    }
}

}  // namespace

void add_clean(CLI::App& program, int& code) {
    const auto options = std::make_shared<CleanCommandOptions>();
    CLI::App* command = program.add_subcommand(
        "clean", "Mend a mesh so that it has a half-edge table, and say how");
    command->add_option("in", options->in, "an .obj or .off file")->required();
    command
        ->add_option("out", options->out,
                     "where to: an .obj, .off or .ply file")
        ->required();
    command
        ->add_option("--fill", options->clean.most_sides,
                     "close holes of at most so many edges, too")
        ->check(CLI::PositiveNumber);
    command->add_flag("--drop-unused", options->clean.drop_unused,
                      "drop vertices that nothing uses, too");
    command->footer(
        "What is wrong with the file itself, such as indices of nothing, is "
        "told by line and not mended.\n"
        "Exit code: 0 written, 2 wrong usage, or a file that cannot be read "
        "or written, 3 lab itself failed.");
    command->callback([options, &code] { code = clean_file(*options); });
}

}  // namespace course

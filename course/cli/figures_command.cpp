// lab figures DIR
#include <fmt/format.h>

#include <memory>

#include "course/cli/commands.h"
#include "course/cli/figures.h"
#include "course/mesh/file_defects.h"

namespace course {

namespace {

int figures(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const auto all = lecture_figures();
    for (const auto& [name, svg] : all) replace_text(folder / name, svg);
    fmt::print("{} figures are in {}.\n", all.size(), folder.string());
    return 0;
}

}  // namespace

void add_figures(CLI::App& program, int& code) {
    const auto dir = std::make_shared<std::filesystem::path>();
    CLI::App* command = program.add_subcommand(
        "figures", "Draw the figures of the lecture notes, as SVG");
    command->add_option("dir", *dir, "where to")->required();
    command->callback([dir, &code] { code = figures(*dir); });
}

}  // namespace course

#include "course/cli/desk.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "course/cli/commands.h"
#include "course/mesh/file_defects.h"

namespace course {

namespace {

namespace fs = std::filesystem;

/// A name that no earlier backup has.
fs::path backup_name(const fs::path& folder, const Exercise& exercise) {
    const std::string extension = fs::path(exercise.file_name()).extension();
    const std::string stem = fmt::format("{}.{:%Y-%m-%d.%H%M%S}", exercise.name,
                                         fmt::localtime(std::time(nullptr)));
    fs::path file = folder / (stem + extension);
    for (int k = 2; fs::exists(file); ++k)
        file = folder / fmt::format("{}.{}{}", stem, k, extension);
    return file;
}

}  // namespace

fs::path Desk::file(const Exercise& exercise) const {
    const fs::path whole =
        root / "exercises" / exercise.topic / exercise.file_name();
    const fs::path near = fs::relative(whole);
    // A way that leads up and down again is harder to read than the whole.
    return near.empty() || *near.begin() == ".." ? whole : near;
}

std::optional<std::string> Desk::original(const Exercise& exercise) const {
    const fs::path kept = source_root() / ".lab" / "originals" /
                          exercise.topic / exercise.file_name();
    if (fs::exists(kept)) return read_file(kept);
    const bool is_elsewhere = !fs::equivalent(root, source_root());
    if (is_elsewhere) return read_file(exercise.skeleton());
    return std::nullopt;
}

bool Desk::is_untouched(const Exercise& exercise) const {
    const fs::path mine = file(exercise);
    return fs::exists(mine) && original(exercise) == read_file(mine);
}

std::optional<fs::path> Desk::reset(const Exercise& exercise) const {
    const auto text = original(exercise);
    if (!text)
        throw CannotBegin(
            fmt::format("nothing to go back to: {} keeps no original of {}",
                        (source_root() / ".lab" / "originals").string(),
                        exercise.file_name()));
    const fs::path mine = file(exercise);
    std::optional<fs::path> kept;
    if (fs::exists(mine)) {
        const fs::path folder = memory() / "backup";
        fs::create_directories(folder);
        kept = backup_name(folder, exercise);
        replace_text(*kept, read_file(mine));
    }
    if (mine.has_parent_path()) fs::create_directories(mine.parent_path());
    replace_text(mine, *text);
    return kept;
}

}  // namespace course

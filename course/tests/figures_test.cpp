// The figures of the lecture notes are those that the tables give, and every
// page finds the ones that it shows. Anew: ./course/lab figures
// course/lectures/figures
#include "course/cli/figures.h"

#include <filesystem>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"

using namespace course;
namespace fs = std::filesystem;

namespace {

const fs::path folder = source_root() / "course" / "lectures" / "figures";

}  // namespace

TEST_CASE("the figures are drawn from the tables as they are now") {
    const auto figures = lecture_figures();
    CHECK(figures.size() > 20);
    for (const auto& [name, svg] : figures) {
        INFO(name);
        CHECK(read_file(folder / name) == svg);
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
        INFO(entry.path());
        CHECK(figures.contains(entry.path().filename().string()));
    }
}

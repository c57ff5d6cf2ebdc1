// The limits of an assignment hold for its submissions, in the sandbox; others
// are judged again only where they changed.
#include <filesystem>
#include <fstream>

#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/tests/grader_program.h"

namespace fs = std::filesystem;

using namespace grader;
using namespace grader::tests;

namespace {

/// What a program does before it is asked anything.
const std::string burns_time =
    "#include <ctime>\nstatic const bool burnt = [] {\n"
    "    while (std::clock() < CLOCKS_PER_SEC * 4 / 10) {}\n"
    "    return true;\n}();\n";
const std::string takes_memory =
    "#include <vector>\n"
    "static const std::vector<char> much(std::size_t{800} << 20, 'x');\n";

/// A class of one student, whose files are slow, large, and neither.
class OneStudent {
public:
    OneStudent() {
        hand_in("06_geometry/signed_area.cpp", burns_time);
        hand_in("06_geometry/area_vector.cpp", takes_memory);
        hand_in("06_geometry/signed_volume.cpp", "");
        hand_in("00_table/complete_table.csv", "");
    }

    Said run(const std::string& limits) const {
        const fs::path file = folder_ / "a.toml";
        std::ofstream(file) << "[exercises]\nsigned_area = 1\narea_vector = 1"
                               "\nsigned_volume = 1\ncomplete_table = 1\n"
                            << limits;
        return grader_says({"run", folder_ / "class", "--out", folder_ / "out",
                            "--assignment", file, "--repeats", "1",
                            "--no-mistakes"});
    }

    course::Verdict verdict(const std::string& exercise) const {
        const Gradebook book(folder_ / "out" / "gradebook.sqlite",
                             Gradebook::Access::read);
        return book.latest("anna", "06_geometry/" + exercise)
            .value()
            .result.verdict;
    }

    std::string report() const {
        return course::read_file(folder_ / "out" / "report.html");
    }

private:
    void hand_in(const fs::path& name, const std::string& before) const {
        const fs::path to = folder_ / "class" / "anna" / name.filename();
        fs::create_directories(to.parent_path());
        std::ofstream(to) << before
                          << course::read_file(course::source_root() /
                                               "solutions" / name);
    }

    course::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("limits of an assignment hold, and others regrade what they touch") {
    if (!has_sandbox()) return;
    using course::Verdict;
    const OneStudent anna;
    CHECK(contains(anna.run("").text, "4 submissions were graded"));
    CHECK(anna.verdict("signed_area") == Verdict::time_limit_exceeded);
    CHECK(anna.verdict("area_vector") != Verdict::accepted);
    CHECK(anna.verdict("signed_volume") == Verdict::accepted);
    CHECK(contains(anna.report(), "<th>limits</th><td>2 s for a call"));

    CHECK(contains(anna.run("[limits.signed_area]\ncpu_seconds = 3\n").text,
                   "1 submissions were graded"));
    CHECK(anna.verdict("signed_area") == Verdict::accepted);
    CHECK(anna.verdict("area_vector") != Verdict::accepted);
    CHECK(contains(anna.report(),
                   "<th>limits of signed_area</th><td>2 s for "
                   "a call, 5 s for a case, 20 s for all; 3 s "
                   "of CPU"));

    // A table that was handed in runs nothing.
    CHECK(contains(anna.run("[limits]\nmemory_mib = 1024\n"
                            "[limits.signed_area]\ncpu_seconds = 3\n")
                       .text,
                   "3 submissions were graded"));
    CHECK(anna.verdict("signed_area") == Verdict::accepted);
    CHECK(anna.verdict("area_vector") == Verdict::accepted);

    // What was judged under the limits of before is still there.
    CHECK(contains(anna.run("").text, "0 submissions were graded"));
    CHECK(anna.verdict("signed_area") == Verdict::time_limit_exceeded);
}

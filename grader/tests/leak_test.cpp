// Everything that a student may see is searched for everything that only the
// instructor may: hidden meshes, arguments, expected values, and what came of
// hidden cases. The submissions of this class tell all that they get to know.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <set>

#include "course/runner/print.h"
#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"

namespace fs = std::filesystem;

using namespace grader::tests;

namespace {

struct Function {
    const char* exercise;
    const char* declaration;
    const char* argument;  ///< "i", or a constant where there is none
    const char* wrong;     ///< a value of the result type
};

constexpr Function functions[] = {
    {"face_sides", "int face_sides(const HalfEdgeTable& he, int i)", "i",
     "1234567"},
    {"prev", "int prev(const HalfEdgeTable& he, int i)", "i", "1234567"},
    {"face_vertices",
     "std::vector<int> face_vertices(const HalfEdgeTable& he, int i)", "i",
     "std::vector<int>{1234567}"},
    {"boundary_loops",
     "std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he)",
     "0", "(std::vector<std::vector<int>>{{1234567}})"},
};

/// What a submission does with what it was asked; `all` holds it as text.
constexpr const char* tellings[] = {
    "std::fputs(all.c_str(), stdout); std::fputs(all.c_str(), stderr);",
    "throw std::runtime_error(all);",
    "throw Leak{};",
    "return he[1000000 + he[0].vi].vi, WRONG;",
    "if (he.size() % 2 == 1) std::abort(); std::puts(all.c_str());",
};

std::string telling_source(const Function& function, const std::string& header,
                           const std::string& telling) {
    std::string what = telling;
    if (const auto at = what.find("WRONG"); at != std::string::npos)
        what.replace(at, 5, function.wrong);
    return fmt::format(
        "#include \"{}\"\n#include <cstdio>\n#include <cstdlib>\n"
        "#include <stdexcept>\n#include <string>\n"
        "struct Leak : std::exception {{\n"
        "    const char* what() const noexcept override {{ return text; }}\n"
        "    static inline char text[4000];\n}};\n"
        "{} {{\n"
        "    std::string all = \"asked \" + std::to_string({}) + \" of \";\n"
        "    for (int k = 0; k < he.size() && k < 100; ++k)\n"
        "        for (int x : {{he[k].vi, he[k].fi, he[k].next, he[k].opp}})\n"
        "            all += std::to_string(x) + \" \";\n"
        "    all.copy(Leak::text, sizeof Leak::text - 1);\n"
        "    {}\n    return {};\n}}\n",
        header, function.declaration, function.argument, what, function.wrong);
}

void hand_in(const fs::path& dir) {
    int number = 0;
    for (const char* telling : tellings) {
        const fs::path folder = dir / fmt::format("telling{}", number++);
        fs::create_directories(folder);
        for (const Function& function : functions) {
            const auto exercise = course::exercise_named(function.exercise);
            std::ofstream(folder / exercise.file_name()) << telling_source(
                function, "exercises/" + exercise.full_name() + ".h", telling);
        }
    }
}

/// Letters and digits only: whatever a sink does with the rest, and however it
/// wraps and escapes, a text is found again.
std::string essence(std::string_view text) {
    std::string letters;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) letters += c;
    return letters;
}

/// The texts of a case, one after the other.
std::string texts_of(const course::CaseResult& result) {
    std::string all = essence(result.printed);
    for (const course::Failure& failure : result.failures)
        for (const std::string& text :
             {failure.call, failure.expected, failure.got, failure.note,
              Catch::Detail::stringify(failure.mesh.rows)})
            all += "|" + essence(text);
    return all + "|";
}

/// The pieces of a text by which it would be known again.
void add_pieces(std::set<std::string>& pieces, const std::string& text) {
    constexpr std::size_t length = 14;
    for (std::size_t at = 0; at + length <= text.size(); at += length)
        if (text.find('|', at) >= at + length)
            pieces.insert(text.substr(at, length));
}

/// What hidden cases hold, and what may be known, some of it the same.
struct Secrets {
    std::set<std::string> hidden;
    std::string shown;
};

Secrets secrets_of(const grader::Gradebook& book, const std::string& student) {
    Secrets found;
    for (const Function& function : functions) {
        const auto attempt = book.latest(
            student, course::exercise_named(function.exercise).full_name());
        REQUIRE(attempt);
        for (const course::CaseResult& result : attempt->result.cases)
            if (result.info.visibility == course::Visibility::shown)
                found.shown += texts_of(result);
            else
                add_pieces(found.hidden, texts_of(result));
    }
    return found;
}

/// All files of one student, as they would be sent.
std::string all_that_may_be_seen(const fs::path& folder) {
    std::string all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) all += file_contents(entry.path());
    return essence(all);
}

void check_student(const fs::path& out, const grader::Gradebook& book,
                   const std::string& student) {
    const Secrets secrets = secrets_of(book, student);
    CHECK(secrets.hidden.size() > 20);  // there is something to hide
    const std::string seen = all_that_may_be_seen(out / "students" / student);
    CHECK(seen.size() > 1000);
    int searched = 0;
    for (const std::string& piece : secrets.hidden) {
        if (contains(secrets.shown, piece)) continue;
        ++searched;
        INFO(student << " may read " << piece);
        CHECK_FALSE(contains(seen, piece));
    }
    CHECK(searched > 10);
}

}  // namespace

TEST_CASE(
    "a student sees nothing of a hidden case but name, verdict and hint") {
    if (!has_sandbox()) return;
    const course::TemporaryFolder folder;
    hand_in(folder / "class");
    const fs::path out = folder / "out";
    for (const char* level : {"names", "names_and_hints"}) {
        INFO(level);
        const fs::path assignment = folder / "assignment.toml";
        std::ofstream text(assignment);
        text << "hidden_feedback = \"" << level << "\"\n[exercises]\n";
        for (const Function& function : functions)
            text << function.exercise << " = 1\n";
        text.close();
        const Said said = grader_says({"run", folder / "class", "--out", out,
                                       "--assignment", assignment.string()});
        INFO(said.text);
        REQUIRE(said.code == 0);
        const grader::Gradebook book(out / "gradebook.sqlite",
                                     grader::Gradebook::Access::read);
        for (std::size_t k = 0; k < std::size(tellings); ++k)
            check_student(out, book, fmt::format("telling{}", k));
    }
}

TEST_CASE("where the instructor allows it, all of a hidden case is told") {
    if (!has_sandbox()) return;
    // The search above would find what it looks for.
    const course::TemporaryFolder folder;
    hand_in(folder / "class");
    const fs::path assignment = folder / "assignment.toml";
    std::ofstream(assignment) << "hidden_feedback = \"full\"\n[exercises]\n"
                                 "face_sides = 1\n";
    const Said said = grader_says({"run", folder / "class", "--out",
                                   folder / "out", "--assignment",
                                   assignment.string(), "--only", "telling1"});
    REQUIRE(said.code == 0);
    const grader::Gradebook book(folder / "out" / "gradebook.sqlite",
                                 grader::Gradebook::Access::read);
    const auto attempt = book.latest("telling1", "01_traversal/face_sides");
    REQUIRE(attempt);
    std::set<std::string> hidden;
    for (const course::CaseResult& result : attempt->result.cases)
        if (result.info.visibility == course::Visibility::hidden)
            add_pieces(hidden, texts_of(result));
    const std::string seen =
        all_that_may_be_seen(folder / "out" / "students" / "telling1");
    CHECK(std::count_if(hidden.begin(), hidden.end(), [&](const auto& piece) {
              return contains(seen, piece);
          }) > 5);
}

#include "exercises/07_files/write_off.h"

#include <cstdlib>
#include <sstream>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The words of a text: comments, blanks and line ends do not matter.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream left(line.substr(0, line.find('#')));
        for (std::string word; left >> word;) words.push_back(word);
    }
    return words;
}

}  // namespace

TEST_CASE("the slide mesh is written", "[points:1]") {
    hint("Which counts, and which vertex numbers, stand in an OFF file?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    std::vector<std::string> words = words_of(write_off(slide.mesh));
    REQUIRE(words.size() == 4 + 6 * 3 + 4 + 5 + 4);
    CHECK(words[0] == "OFF");
    CHECK(words[1] == "6");
    CHECK(words[2] == "3");
    words.erase(words.begin(), words.begin() + 4 + 6 * 3);
    CHECK(words == words_of("3 0 2 1  4 1 2 5 4  3 2 3 5"));
}

TEST_CASE("a third is a third when it is read again", "[points:1]") {
    hint("Which double does one get who reads what you wrote?");
    const IndexedMesh mesh{{{1.0 / 3, 0.1 + 0.2, 1e-20}}, {}, {}};
    const std::vector<std::string> words = words_of(write_off(mesh));
    REQUIRE(words.size() == 7);
    CHECK(std::strtod(words[4].c_str(), nullptr) == 1.0 / 3);
    CHECK(std::strtod(words[5].c_str(), nullptr) == 0.1 + 0.2);
    CHECK(std::strtod(words[6].c_str(), nullptr) == 1e-20);
}

TEST_CASE("a mesh with a loose edge is refused", "[points:1]") {
    hint("What has the mesh that an OFF file cannot say?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK_THROWS_AS(write_off(dangling.mesh), std::invalid_argument);
}

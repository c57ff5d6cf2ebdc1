#include "exercises/07_files/write_obj.h"

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

TEST_CASE("the slide mesh and a loose edge", "[points:1]") {
    hint("Which number has vertex 0 in an OBJ file? What is an l line for?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    std::vector<std::string> words = words_of(write_obj(dangling.mesh));
    REQUIRE(words.size() == 7 * 4 + 4 + 5 + 4 + 3);
    CHECK(words[0] == "v");
    CHECK(words[4] == "v");
    words.erase(words.begin(), words.begin() + 7 * 4);
    CHECK(words == words_of("f 1 3 2  f 2 3 6 5  f 3 4 6  l 5 7"));
}

TEST_CASE("a third is a third when it is read again", "[points:1]") {
    hint("Which double does one get who reads what you wrote?");
    const IndexedMesh mesh{{{1.0 / 3, 0.1 + 0.2, 1e-20}}, {}, {}};
    const std::vector<std::string> words = words_of(write_obj(mesh));
    REQUIRE(words.size() == 4);
    CHECK(std::strtod(words[1].c_str(), nullptr) == 1.0 / 3);
    CHECK(std::strtod(words[2].c_str(), nullptr) == 0.1 + 0.2);
    CHECK(std::strtod(words[3].c_str(), nullptr) == 1e-20);
}

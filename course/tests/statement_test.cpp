// The statements in both languages: from one file, cut in the right place, and
// whole in each of them.
#include "course/runner/statement.h"

#include <algorithm>
#include <sstream>

#include "course/runner/catch2.h"

using namespace course;

namespace {

constexpr std::string_view both =
    "# Title\n\nText.\n\n## Hints\n\n1. First\n   goes on.\n2. Second.\n"
    "\n<!-- it -->\n\n# Titolo\n\nTesto.\n\n## Suggerimenti\n\n1. Primo.\n";

/// The calls that a text writes as code: the same in every language.
std::vector<std::string> code_in(const std::string& text) {
    std::vector<std::string> pieces;
    std::istringstream in(text);
    std::string piece;
    for (bool is_code = false; std::getline(in, piece, '`'); is_code = !is_code)
        if (is_code && piece.find('(') != std::string::npos &&
            piece.find('\n') == std::string::npos)
            pieces.push_back(piece);
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
}

}  // namespace

TEST_CASE("a file has its English part before the mark and Italian behind") {
    const std::string english = part_in(both, Language::english);
    CHECK(english.find("Second.") != std::string::npos);
    CHECK(english.find("<!--") == std::string::npos);
    CHECK(english.find("Testo") == std::string::npos);
    CHECK(part_in(both, Language::italian).rfind("# Titolo", 0) == 0);
    CHECK(part_in("# Title\n", Language::italian).empty());
}

TEST_CASE("languages are known by their name and by a locale's") {
    CHECK(language_named("it") == Language::italian);
    CHECK(language_named("it_IT.UTF-8") == Language::italian);
    CHECK(language_named("en_GB") == Language::english);
    CHECK(language_named("C") == Language::english);
    CHECK_FALSE(language_named("fr").has_value());
    CHECK_FALSE(language_named("italiano").has_value());
}

TEST_CASE("every statement is in Italian, too, and whole") {
    for (const Exercise& exercise : all_exercises()) {
        INFO(exercise.full_name());
        const Statement english = statement_of(exercise, Language::english);
        const Statement italian = statement_of(exercise, Language::italian);
        CHECK(italian.language == Language::italian);
        CHECK(italian.title != english.title);
        CHECK(italian.hints.size() == english.hints.size());
        CHECK(italian.text.find("Difficoltà: ★") != std::string::npos);
        CHECK(code_in(italian.text) == code_in(english.text));
    }
}

TEST_CASE("where there is no Italian part, English comes and says so") {
    const Statement got = statement_in(
        "# Title\n\nText.\n\n## Hints\n\n1. A.\n", Language::italian);
    CHECK(got.language == Language::english);
    CHECK(got.title == "Title");
    CHECK(got.hints == std::vector<std::string>{"A."});
}

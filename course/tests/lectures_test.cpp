// The pages of the lecture notes and of the exercises: every link leads
// somewhere, and every row of the checklist of what the lecture teaches is
// covered by something.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"

using namespace course;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> pages() {
    std::vector<fs::path> all;
    for (const char* folder : {"course/lectures", "exercises"})
        for (const auto& entry :
             fs::recursive_directory_iterator(source_root() / folder))
            if (entry.path().extension() == ".md") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

/// A heading as the anchor that readers of Markdown make of it.
std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) || c == '_' || c == '-' || letter >= 0x80)
            anchor += static_cast<char>(std::tolower(letter));
        else if (c == ' ')
            anchor += '-';
    }
    return anchor;
}

std::set<std::string> anchors_of(const fs::path& page) {
    std::set<std::string> anchors;
    std::istringstream lines(read_file(page));
    const std::regex named("<a (?:id|name)=\"([^\"]*)\"");
    for (std::string line; std::getline(lines, line);) {
        const auto text = line.find_first_not_of('#');
        if (text != 0 && text != line.npos && line[text] == ' ')
            anchors.insert(anchor_of(line.substr(text + 1)));
        for (std::sregex_iterator at(line.begin(), line.end(), named), end;
             at != end; ++at)
            anchors.insert((*at)[1]);
    }
    return anchors;
}

/// The targets of all links and pictures, without those out of the tree.
std::vector<std::string> links_in(const std::string& text) {
    std::vector<std::string> links;
    const std::regex link("\\]\\(([^) ]+)\\)");
    for (std::sregex_iterator at(text.begin(), text.end(), link), end;
         at != end; ++at)
        if ((*at)[1].str().find("://") == std::string::npos)
            links.push_back((*at)[1]);
    return links;
}

/// Why a link on a page leads nowhere, or "".
std::string complaint(const fs::path& page, const std::string& link) {
    const auto hash = link.find('#');
    const std::string name = link.substr(0, hash);
    const fs::path target =
        name.empty() ? page : (page.parent_path() / name).lexically_normal();
    if (!fs::exists(target)) return "there is no " + target.string();
    if (hash == link.npos) return "";
    const std::string anchor = link.substr(hash + 1);
    if (anchors_of(target).contains(anchor)) return "";
    return target.string() + " has no place #" + anchor;
}

/// The checklist: so many rows under each letter.
const std::map<char, int> checklist = {
    {'A', 10}, {'B', 7}, {'C', 12}, {'D', 10}, {'E', 5},  {'F', 8},
    {'G', 11}, {'H', 5}, {'I', 8},  {'J', 3},  {'K', 12}, {'L', 3}};

}  // namespace

TEST_CASE("every link of the lecture notes and statements leads somewhere") {
    for (const fs::path& page : pages()) {
        INFO(page);
        for (const std::string& link : links_in(read_file(page))) {
            INFO(link);
            CHECK(complaint(page, link).empty());
        }
    }
}

TEST_CASE("everything that the lecture teaches is covered by something") {
    const fs::path page = source_root() / "course/lectures/coverage.md";
    std::istringstream lines(read_file(page));
    std::map<std::string, std::string> rows;
    const std::regex row("^\\| *([A-L][0-9]+) *\\|.*");
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, match, row)) {
            INFO(line);
            CHECK_FALSE(rows.contains(match[1]));
            rows[match[1]] = line;
        }
    for (const auto& [letter, count] : checklist)
        for (int k = 1; k <= count; ++k) {
            const std::string id = letter + std::to_string(k);
            INFO(id);
            REQUIRE(rows.contains(id));
            const auto links = links_in(rows[id]);
            CHECK_FALSE(links.empty());
            for (const std::string& link : links) {
                INFO(link);
                CHECK(complaint(page, link).empty());
            }
        }
}

TEST_CASE("every exercise stands in the README of its chapter") {
    for (const Exercise& exercise : all_exercises()) {
        INFO(exercise.full_name());
        const std::string readme =
            read_file(exercise.statement().parent_path() / "README.md");
        const std::string link =
            "`" + exercise.name + "`](" + exercise.name + ".md)";
        CHECK(readme.find(link) != std::string::npos);
    }
}

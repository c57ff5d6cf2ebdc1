#include "grader/pipeline/attacks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "course/runner/descriptors.h"
#include "course/runner/exercises.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

fs::path corpus_folder() {
    return course::source_root() / "grader" / "tests" / "attacks";
}

BadAttack bad(const Attack& attack, const std::string& expected,
              const std::string& found) {
    return BadAttack(fmt::format("{}: expected {}, found \"{}\"", attack.name(),
                                 expected, found));
}

/// "all", "3.5" or "<=3".
void read_points(std::string text, Attack& attack) {
    const std::string whole = text;
    attack.at_most = text.starts_with("<=");
    if (attack.at_most) text.erase(0, 2);
    if (text == "all") return;
    double points = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, points);
    if (read.ec != std::errc() || read.ptr != end)
        throw bad(attack, "a number of points or \"all\"", whole);
    attack.points = points;
}

void read_expectation(const std::string& line, Attack& attack) {
    const auto colon = line.find(": ");
    std::vector<std::string> all;
    if (line.starts_with("// ") && colon != std::string::npos) {
        std::istringstream words(line.substr(3, colon - 3));
        for (std::string word; words >> word;)
            if (word != "or") all.push_back(word);
    }
    if (all.size() < 2) throw bad(attack, "// <verdict> <points>: ...", line);
    attack.what = line.substr(colon + 2);
    read_points(all.back(), attack);
    all.pop_back();
    for (const std::string& word : all) {
        const auto verdict = course::verdict_named(word);
        if (!verdict) throw bad(attack, "the name of a verdict", word);
        attack.verdicts.push_back(*verdict);
    }
}

}  // namespace

std::string Attack::name() const {
    return exercise + "/" + file.filename().string();
}

bool Attack::is_as_expected(const course::ExerciseResult& result) const {
    const double right = points.value_or(result.max());
    return std::count(verdicts.begin(), verdicts.end(), result.verdict) > 0 &&
           (result.points() == right || (at_most && result.points() < right));
}

std::string Attack::expectation() const {
    std::vector<std::string_view> names;
    for (const course::Verdict verdict : verdicts)
        names.push_back(course::name(verdict));
    return fmt::format("{}, {}{} points", fmt::join(names, " or "),
                       at_most ? "at most " : "",
                       points ? fmt::format("{}", *points) : "all");
}

fs::path hand_in(const Attack& attack, const fs::path& folder) {
    std::string text = course::read_file(attack.file);
    const std::string key = "@ROOT@";
    const std::string root = course::source_root();
    for (auto at = text.find(key); at != std::string::npos;
         at = text.find(key, at + root.size()))
        text.replace(at, key.size(), root);
    fs::path file =
        folder / course::exercise_named(attack.exercise).file_name();
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) course::throw_errno("cannot write " + file.string());
    return file;
}

Attack read_attack(const fs::path& file) {
    Attack attack;
    attack.file = file;
    attack.exercise = file.parent_path().filename();
    const std::string name = file.filename();
    const auto number =
        std::from_chars(name.data(), name.data() + name.size(), attack.item);
    if (number.ec != std::errc())
        throw bad(attack, "a name that begins with a number", name);
    const std::string text = course::read_file(file);
    read_expectation(text.substr(0, text.find('\n')), attack);
    return attack;
}

Attack attack_named(const std::string& exercise, const std::string& name) {
    return read_attack(corpus_folder() / exercise / (name + ".cpp"));
}

std::vector<Attack> attack_corpus() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(corpus_folder()))
        if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Attack> attacks;
    for (const fs::path& file : files) attacks.push_back(read_attack(file));
    return attacks;
}

}  // namespace grader

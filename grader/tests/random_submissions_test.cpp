// Submissions that nobody wrote: bytes, cut and damaged sources, huge files.
// Each gets a verdict, and none is a fault of the grader. Sampled; with
// RANDOM_SUBMISSIONS=1000 in the environment, as many.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <random>

#include "course/runner/judge_submission.h"
#include "course/runner/pool.h"
#include "course/runner/temporary_folder.h"
#include "grader/tests/grader_program.h"

namespace fs = std::filesystem;

using namespace grader::tests;

namespace {

using Random = std::mt19937;

int below(Random& random, std::size_t bound) {
    return static_cast<int>(random() % bound);
}

std::string bytes(Random& random, std::size_t size) {
    std::string text;
    while (text.size() < size) text += static_cast<char>(random() & 0xFF);
    return text;
}

std::string damaged(Random& random, std::string text) {
    const int times = 1 + below(random, 6);
    for (int k = 0; k < times && !text.empty(); ++k) {
        const auto at = static_cast<std::size_t>(below(random, text.size()));
        switch (below(random, 4)) {
            case 0:
                text[at] = static_cast<char>(random() & 0x7F);
                break;
            case 1:
                text.erase(at, 1 + random() % 9);
                break;
            case 2:
                text.insert(at, text.substr(at, random() % 40));
                break;
            default:
                text.insert(at, 1, "{}();<>\"'\\#&*=-"[random() % 15]);
        }
    }
    return text;
}

std::string tokens(Random& random) {
    constexpr const char* words[] = {
        "int",    "face_sides", "(",  ")",  "{", "}",      "he", "[",   "]",
        "i",      ".next",      ";",  "if", "=", "return", "#",  "<",   ">",
        "struct", "template",   "\n", ",",  "&", "while",  "::", "auto"};
    std::string text = "#include \"exercises/01_traversal/face_sides.h\"\n";
    for (int k = 0; k < 300; ++k)
        text += std::string(words[random() % std::size(words)]) + " ";
    return text;
}

std::string random_submission(Random& random, const std::string& reference) {
    switch (below(random, 12)) {
        case 0:
            return bytes(random, random() % 5000);
        case 1:
            return std::string(random() % 100'000, '\0');
        case 2:
            return std::string((5u << 20) + random() % 100, 'x');
        case 3:
            return reference + std::string(3u << 20, ' ');
        case 4:
            return tokens(random);
        case 5:
            return "";
        case 6:
        case 7:
            return reference.substr(0, random() % (reference.size() + 1));
        default:
            return damaged(random, reference);
    }
}

int how_many() {
    const char* asked = std::getenv("RANDOM_SUBMISSIONS");
    return asked != nullptr ? std::atoi(asked) : 40;
}

}  // namespace

TEST_CASE("submissions that nobody wrote get a verdict each") {
    const grader::Stage stage;
    const grader::Probe found = grader::probe(stage);
    if (found.isolation == grader::Isolation::none) return;
    const auto exercises = course::all_exercises();
    std::mutex guard;
    course::for_each_item(2, how_many(), [&](int lane, int item) {
        Random random(static_cast<unsigned>(item));
        const course::Exercise& exercise =
            exercises[random() % exercises.size()];
        const std::string reference = course::read_file(exercise.solution());
        const course::TemporaryFolder folder;
        const fs::path file = folder / exercise.file_name();
        std::ofstream(file, std::ios::binary)
            << random_submission(random, reference);
        const auto workplace = grader::workplace(found.isolation, stage, lane);
        const auto result = course::judge_submission(
            *workplace, exercise, file, course::JudgeKind::grade, {1, 2});
        const std::scoped_lock lock(guard);
        INFO("submission " << item << " for " << exercise.name << ": "
                           << result.message.substr(0, 500));
        CHECK(name(result.verdict) != "grader_fault");
        CHECK(result.max() > 0);
    });
}

#include "grader/bench/made_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "course/runner/descriptors.h"

namespace grader::bench {

namespace {

namespace fs = std::filesystem;
using course::Exercise;

/// Those that end by themselves.
std::vector<fs::path> wrong_ones(const Exercise& exercise) {
    std::vector<fs::path> files;
    for (const char* verdict : {"wrong_answer", "run_time_error"}) {
        const fs::path folder = course::source_root() / "grader" / "wrong" /
                                exercise.topic / exercise.name / verdict;
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The reference, with `loop` before all that its function does.
std::string looping(const Exercise& exercise, const std::string& loop) {
    std::string text = course::read_file(exercise.solution());
    const auto name = text.find(" " + exercise.name + "(");
    const auto body = name == text.npos ? name : text.find('{', name);
    if (body == text.npos)
        throw course::SystemError(exercise.full_name() +
                                  ": no function of that name in solutions/");
    return text.insert(body + 1, "\n    " + loop);
}

/// Chooses what each file has; file by file in their order.
class Author {
public:
    explicit Author(const ClassShape& shape)
        : content_(shape.content), random_(shape.seed) {}

    std::string next(const Exercise& exercise) {
        if (content_ == Content::references)
            return course::read_file(exercise.solution());
        constexpr std::size_t block = 20;
        if (count_ % block == 0) endless_ = below(block);
        if (count_++ % block == endless_) return endless(exercise);
        const std::size_t dice = below(20);
        const auto wrong = wrong_ones(exercise);
        if (dice < 10 || wrong.empty())
            return course::read_file(exercise.solution());
        if (dice < 13) return course::read_file(exercise.skeleton());
        return course::read_file(wrong[below(wrong.size())]);
    }

private:
    /// In turn one that the budget of reads ends, where there is a table to
    /// read, and one that the clock must.
    std::string endless(const Exercise& exercise) {
        by_clock_ = !by_clock_;
        const bool has_table =
            course::read_file(exercise.solution()).find("HalfEdgeTable& he") !=
            std::string::npos;
        return looping(exercise, by_clock_ || !has_table
                                     ? "for (;;) {}"
                                     : "for (;;) static_cast<void>(he[0]);");
    }
    /// Not a distribution of the library: those differ between machines.
    std::size_t below(std::size_t bound) { return random_() % bound; }

    Content content_;
    std::mt19937 random_;
    std::size_t count_ = 0;
    std::size_t endless_ = 0;
    bool by_clock_ = true;
};

void write_file(const fs::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) course::throw_errno("cannot write " + file.string());
}

std::string assignment_of(const std::vector<Exercise>& exercises) {
    std::string text = "name = \"Benchmark\"\n[exercises]\n";
    for (const Exercise& exercise : exercises)
        text += fmt::format("{} = 1\n", exercise.name);
    return text;
}

}  // namespace

std::vector<Exercise> chosen_exercises(int most) {
    std::vector<Exercise> all = course::all_exercises();
    std::erase_if(all, [](const Exercise& e) { return e.is_data; });
    const std::size_t n = std::min(static_cast<std::size_t>(most), all.size());
    std::vector<Exercise> chosen;
    for (std::size_t k = 0; k < n; ++k)
        chosen.push_back(all[k * all.size() / n]);
    return chosen;
}

MadeClass make_class(const fs::path& at, const ClassShape& shape) {
    MadeClass made{at / "class", at / "assignment.toml", {}};
    Author author(shape);
    for (int student = 1; student <= shape.students; ++student) {
        const fs::path folder =
            made.folder / fmt::format("student_{:04}", student);
        fs::create_directories(folder);
        for (const Exercise& exercise : shape.exercises) {
            const fs::path file = folder / exercise.file_name();
            write_file(file, fmt::format("{}\n// student {}\n",
                                         author.next(exercise), student));
            made.files.push_back({exercise, file});
        }
    }
    write_file(made.assignment, assignment_of(shape.exercises));
    return made;
}

}  // namespace grader::bench

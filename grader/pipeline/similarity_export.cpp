#include "grader/pipeline/similarity_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "course/mesh/file_defects.h"
#include "course/report/escape.h"
#include "grader/pipeline/keys.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::Exercise;

std::vector<std::string> anonymous_names(const SubmittedClass& submitted) {
    const auto& all = submitted.submissions;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return sha256(all[a].id) < sha256(all[b].id);
    });
    std::vector<std::string> names(all.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        names[order[k]] = fmt::format("student_{:03}", k + 1);
    return names;
}

std::vector<std::string> names_of(const SubmittedClass& submitted,
                                  Naming naming) {
    if (naming == Naming::anonymous) return anonymous_names(submitted);
    std::vector<std::string> names;
    for (const Submission& one : submitted.submissions) names.push_back(one.id);
    return names;
}

void write(const fs::path& file, std::string_view bytes) {
    fs::create_directories(file.parent_path());
    course::replace_text(file, bytes);
}

std::string info_csv(const SubmittedClass& submitted, std::size_t exercise,
                     const std::string& file_name, Naming naming,
                     const std::vector<std::string>& names) {
    std::string text = "filename,full_name\n";
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Submission& one = submitted.submissions[k];
        if (!one.files[exercise]) continue;
        text += fmt::format(
            "submissions/{}/{},{}\n", names[k], file_name,
            course::escape_csv(naming == Naming::ids ? one.student : names[k]));
    }
    return text;
}

}  // namespace

std::vector<std::string> export_for_similarity(
    const SubmittedClass& submitted, const std::vector<Exercise>& exercises,
    Naming naming, const fs::path& folder) {
    std::vector<std::string> names = names_of(submitted, naming);
    fs::create_directories(folder / "submissions");
    for (std::size_t e = 0; e < exercises.size(); ++e) {
        const std::string file = exercises[e].file_name();
        write(folder / "base" / file,
              course::read_file(exercises[e].skeleton()));
        for (std::size_t k = 0; k < names.size(); ++k)
            if (const Submission& one = submitted.submissions[k]; one.files[e])
                write(folder / "submissions" / names[k] / file,
                      submitted.bytes(one, e));
        if (!exercises[e].is_data)
            write(folder / fmt::format("info_{}.csv", exercises[e].name),
                  info_csv(submitted, e, file, naming, names));
    }
    return names;
}

std::string names_csv(const SubmittedClass& submitted,
                      const std::vector<std::string>& names) {
    std::string text = "name,student\n";
    for (std::size_t k = 0; k < names.size(); ++k)
        text += names[k] + "," +
                course::escape_csv(submitted.submissions[k].student) + "\n";
    return text;
}

}  // namespace grader

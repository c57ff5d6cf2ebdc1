#include "grader/pipeline/keys.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>

#include "course/runner/codec.h"
#include "course/runner/compile.h"
#include "course/runner/limits.h"
#include "course/runner/process.h"
#include "course/runner/run_judge.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

std::string compiler_version() {
    course::Command command;
    command.arguments = {course::compiler(), "--version"};
    command.environment = course::plain_environment();
    return course::run(command, std::chrono::seconds(10), 4096).output;
}

/// All headers that a submission may include, in order of their names.
std::string headers() {
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::recursive_directory_iterator(course::student_include()))
        if (entry.path().extension() == ".h") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string all;
    for (const fs::path& file : files) all += course::read_file(file);
    return all;
}

/// Nothing runs of a table that was handed in: other limits leave its result.
std::string limits_of(const course::Exercise& exercise) {
    return course::encode(exercise.is_data ? course::Limits()
                                           : exercise.limits);
}

}  // namespace

std::string sha256(std::string_view bytes) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(),
                   nullptr) != 1)
        throw course::SystemError("SHA-256 failed");
    std::string text;
    for (unsigned k = 0; k < size; ++k)
        text += fmt::format("{:02x}", digest[k]);
    return text;
}

std::vector<std::uint64_t> judging_seeds(std::uint64_t seed, int repeats,
                                         std::string_view source) {
    constexpr std::size_t digits = 8;  // suites reckon with multiples of it
    std::vector<std::uint64_t> seeds;
    for (int k = 0; k < repeats; ++k) {
        const std::string hash =
            sha256(fmt::format("{} {} {}", seed, k, sha256(source)));
        seeds.push_back(std::stoull(hash.substr(0, digits), nullptr, 16));
    }
    return seeds;
}

Keys::Keys(const std::vector<course::Exercise>& exercises,
           const std::string& surroundings) {
    const std::string worker =
        course::read_file(course::build_root() / "grader" / "grader_worker");
    const auto arguments =
        course::compile_arguments("s", "o", "i", course::Prelude::lean);
    common_ = sha256(course::encode(std::vector<std::string>{
        sha256(worker), sha256(headers()), compiler_version(),
        fmt::format("{}", fmt::join(arguments, " ")), surroundings}));
    for (const course::Exercise& exercise : exercises) {
        std::string judge = course::read_file(
            course::judge_program(exercise, course::JudgeKind::grade));
        if (!exercise.is_data)
            judge += course::read_file(course::entry_object(exercise));
        suites_[exercise.name] = sha256(judge);
    }
}

std::string Keys::suite_version(const course::Exercise& exercise) const {
    constexpr std::size_t enough = 12;
    return suites_.at(exercise.name).substr(0, enough);
}

std::string Keys::of(const course::Exercise& exercise,
                     std::string_view source) const {
    return sha256(course::encode(
        std::vector<std::string>{common_, suites_.at(exercise.name),
                                 sha256(source), limits_of(exercise)}));
}

}  // namespace grader

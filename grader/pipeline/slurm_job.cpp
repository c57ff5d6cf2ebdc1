#include "grader/pipeline/slurm_job.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <set>
#include <string_view>

#include "course/runner/codec.h"
#include "course/runner/descriptors.h"
#include "grader/pipeline/keys.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::ExerciseResult;

/// What stands in the file of a result.
struct Judged {
    std::uint64_t task = 0;
    std::string source;  ///< its hash
    ExerciseResult result;
};

/// Another number for each change of what is encoded behind it.
constexpr std::string_view magic = "half-edge grader job, version 2\n";
constexpr std::size_t hash_length = 64;

std::string sealed(const std::string& body) {
    return fmt::format("{}{}{}", magic, sha256(body), body);
}

std::optional<std::string> unsealed(const std::string& bytes) {
    if (!bytes.starts_with(magic) || bytes.size() < magic.size() + hash_length)
        return std::nullopt;
    std::string body = bytes.substr(magic.size() + hash_length);
    if (bytes.compare(magic.size(), hash_length, sha256(body)) != 0)
        return std::nullopt;
    return body;
}

/// The value in a sealed file, or nothing where there is none.
template <class T>
std::optional<T> read_sealed(const fs::path& file) {
    try {
        const auto body = unsealed(course::read_file(file));
        if (!body) return std::nullopt;
        return course::decode<T>(*body);
    } catch (const course::SystemError&) {
        return std::nullopt;
    } catch (const course::CodecError&) {
        return std::nullopt;
    }
}

/// Two nodes may be writing the same file at the same time.
std::string temporary_name(const fs::path& file) {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return fmt::format(".{}-{}-{}", file.filename().string(), host.data(),
                       ::getpid());
}

void write_whole(const fs::path& file, const std::string& bytes) {
    const fs::path unfinished = file.parent_path() / temporary_name(file);
    std::ofstream out(unfinished, std::ios::binary);
    out << bytes;
    out.close();
    if (!out) course::throw_errno("cannot write " + file.string());
    std::error_code error;
    fs::rename(unfinished, file, error);
    if (error)
        throw course::SystemError(
            fmt::format("cannot write {}: {}", file.string(), error.message()));
}

std::optional<std::size_t> number_in(const std::string& name) {
    std::size_t number = 0;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    return number;
}

fs::path source_file(const fs::path& job, std::size_t task) {
    return job / "sources" / std::to_string(task);
}
fs::path result_file(const fs::path& job, std::size_t task) {
    return job / "results" / std::to_string(task);
}

}  // namespace

course::Limits limits_in(const Job& job, const std::string& exercise) {
    const auto found = job.limits.find(exercise);
    return found == job.limits.end() ? course::Limits() : found->second;
}

std::vector<course::Exercise> exercises_of(const Job& job) {
    std::set<std::string> names;
    for (const JobTask& task : job.tasks) names.insert(task.exercise);
    std::vector<course::Exercise> found;
    for (course::Exercise& exercise : course::all_exercises()) {
        if (names.erase(exercise.full_name()) == 0) continue;
        exercise.limits = limits_in(job, exercise.full_name());
        found.push_back(std::move(exercise));
    }
    if (!names.empty())
        throw course::UnknownExercise(
            fmt::format("there is no exercise \"{}\" here", *names.begin()));
    return found;
}

std::string build_version(const std::vector<course::Exercise>& exercises) {
    const Keys keys(exercises, sha256(course::read_file("/proc/self/exe")));
    std::vector<std::string> all;
    for (const course::Exercise& exercise : exercises)
        all.push_back(keys.of(exercise, ""));
    return sha256(course::encode(all));
}

JobFolder JobFolder::make(const fs::path& parent) {
    std::error_code error;
    fs::create_directories(parent, error);
    std::string path = parent / "grader-XXXXXX";
    if (error || ::mkdtemp(path.data()) == nullptr)
        course::throw_errno("cannot make a folder " + path);
    for (const char* name : {"sources", "results", "log"})
        fs::create_directory(fs::path(path) / name);
    return JobFolder(path);
}

void JobFolder::write_source(std::size_t task,
                             const std::string& source) const {
    write_whole(source_file(path_, task), source);
}

void JobFolder::write(const Job& job) const {
    write_whole(path_ / "job", sealed(course::encode(job)));
}

std::optional<Job> JobFolder::job() const {
    return read_sealed<Job>(path_ / "job");
}

std::string JobFolder::source(std::size_t task, const JobTask& listed) const {
    const fs::path file = source_file(path_, task);
    std::string source = course::read_file(file);
    if (sha256(source) != listed.source)
        throw course::SystemError(fmt::format(
            "{} is not the file that the head has written", file.string()));
    return source;
}

void JobFolder::write_result(std::size_t task, const JobTask& listed,
                             const ExerciseResult& result) const {
    write_whole(result_file(path_, task),
                sealed(course::encode(Judged{task, listed.source, result})));
}

std::optional<ExerciseResult> JobFolder::result(std::size_t task,
                                                const JobTask& listed) const {
    auto judged = read_sealed<Judged>(result_file(path_, task));
    if (!judged || judged->task != task || judged->source != listed.source)
        return std::nullopt;
    return std::move(judged->result);
}

std::vector<std::size_t> JobFolder::results() const {
    std::vector<std::size_t> found;
    std::error_code error;
    for (fs::directory_iterator entry(path_ / "results", error), end;
         !error && entry != end; entry.increment(error))
        if (const auto number = number_in(entry->path().filename()))
            found.push_back(*number);
    return found;
}

std::string JobFolder::log(std::size_t chunk) const {
    const fs::path file = path_ / "log" / std::to_string(chunk);
    const course::Descriptor log(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (!log)
        return fmt::format("there is no {}: do the nodes have this folder?",
                           file.string());
    return course::last_bytes(log.get());
}

void JobFolder::remove() const {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove(path_.parent_path(), ignored);  // when it was the last one
}

}  // namespace grader

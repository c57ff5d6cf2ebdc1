#include "grader/pipeline/gradescope_metadata.h"

#include <fmt/format.h>
#ifdef GRADER_HAS_YAML
#include <yaml-cpp/yaml.h>
#endif

#include <chrono>

#include "course/runner/codec.h"
#include "grader/sandbox/confined.h"

namespace grader {

namespace {

#ifdef GRADER_HAS_YAML

constexpr std::size_t most_submissions = 20'000;
constexpr std::size_t most_in_a_list = 100;
constexpr std::size_t longest_text = 500;
constexpr std::size_t most_answer_bytes = 64u << 20;
constexpr unsigned most_seconds = 20;  // of CPU

/// What the child says: a mistake, or the submissions.
struct Answer {
    std::string mistake;
    std::vector<GradescopeSubmission> submissions;
};

std::string text_of(const YAML::Node& map, const char* key) {
    const YAML::Node value = map[key];
    return value && value.IsScalar() ? value.Scalar().substr(0, longest_text)
                                     : "";
}

std::vector<Member> members_in(const YAML::Node& list) {
    std::vector<Member> members;
    if (!list || !list.IsSequence()) return members;
    for (const YAML::Node& who : list)
        if (who.IsMap() && members.size() < most_in_a_list)
            members.push_back({text_of(who, ":name"), text_of(who, ":sid"),
                               text_of(who, ":email")});
    return members;
}

GradescopeSubmission submission_of(const std::string& folder,
                                   const YAML::Node& facts) {
    GradescopeSubmission one;
    one.folder = folder;
    one.created_at = text_of(facts, ":created_at");
    one.submitters = members_in(facts[":submitters"]);
    return one;
}

Answer parsed(const std::string& bytes) {
    Answer answer;
    try {
        const YAML::Node all = YAML::Load(bytes);
        if (!all.IsMap()) return {"it is no table of submissions", {}};
        for (const auto& entry : all) {
            if (answer.submissions.size() == most_submissions) break;
            if (entry.first.IsScalar() && entry.second.IsMap())
                answer.submissions.push_back(
                    submission_of(entry.first.Scalar().substr(0, longest_text),
                                  entry.second));
        }
    } catch (const YAML::Exception& error) {
        return {std::string(error.what()).substr(0, longest_text), {}};
    }
    return answer;
}

/// All that comes out of a child until it closes its end.
std::string all_from(Confined& child) {
    const auto until =
        course::Clock::now() + std::chrono::seconds(2 * most_seconds);
    std::string bytes;
    std::uint64_t size = 0;
    if (course::receive_all(child.out(), bytes, sizeof size, until) ==
        course::Transfer::done)
        size = course::decode<std::uint64_t>(bytes);
    bytes.clear();
    if (size == 0 || size > most_answer_bytes ||
        course::receive_all(child.out(), bytes, size, until) !=
            course::Transfer::done)
        throw MetadataError(
            fmt::format("it could not be read ({})", child.how_it_failed()));
    return bytes;
}

#endif

}  // namespace

#ifdef GRADER_HAS_YAML

std::vector<GradescopeSubmission> read_gradescope_metadata(
    const std::string& bytes) {
    ConfinedLimits limits;
    limits.cpu_seconds = most_seconds;
    Confined child(limits, {}, [&](int out) {
        const std::string answer = course::encode(parsed(bytes));
        const std::string size = course::encode(std::uint64_t{answer.size()});
        course::write_all(out, size.data(), size.size());
        course::write_all(out, answer.data(), answer.size());
    });
    const std::string said = all_from(child);
    Answer answer;
    try {
        answer = course::decode<Answer>(said);
    } catch (const course::CodecError&) {
        throw MetadataError("its process said what cannot be");
    }
    if (!answer.mistake.empty())
        throw MetadataError(answer.mistake.substr(0, longest_text));
    return std::move(answer.submissions);
}

#else

std::vector<GradescopeSubmission> read_gradescope_metadata(const std::string&) {
    throw MetadataError(
        "this grader was built without yaml-cpp (Debian: libyaml-cpp-dev)");
}

#endif

}  // namespace grader

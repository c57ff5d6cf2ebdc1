// Archives: any bytes are entries within the limits, whose paths lead nowhere
// else, or an ArchiveError. The first byte of an input says what the rest is
// taken for. (The decompression runs in a process without rights, in grading.)
#include "grader/pipeline/archive.h"

#include "grader/fuzz/fuzz.h"

namespace {

using grader::ArchiveEntry;

constexpr grader::ArchiveLimits limits{200, std::uint64_t{4} << 20};
constexpr std::size_t most_bytes = 2000;

std::optional<std::size_t> wanted(std::string_view path) {
    if (!path.ends_with(".cpp")) return std::nullopt;
    return most_bytes;
}

void check_path(std::string_view path) {
    using namespace std::literals;
    fuzz::require(!path.empty() && path.size() <= 1024,
                  "a path has its length");
    fuzz::require(path.find_first_of("\0\\"sv) == path.npos,
                  "a path has no NUL and no backslash");
    while (!path.empty()) {
        const std::string_view part = path.substr(0, path.find('/'));
        fuzz::require(!part.empty() && part != "." && part != "..",
                      "a path leads to below");
        path.remove_prefix(std::min(part.size() + 1, path.size()));
    }
}

/// What is asked of each entry, and of all of them together.
class Entries {
public:
    void take(const ArchiveEntry& entry) {
        fuzz::require(entry.index > last_ && entry.index <= limits.entries,
                      "entries are counted");
        last_ = entry.index;
        if (entry.kind == ArchiveEntry::Kind::refused)
            return check_refused(entry);
        check_path(entry.path);
        const bool is_file = entry.kind == ArchiveEntry::Kind::file;
        fuzz::require(
            entry.bytes.has_value() == (is_file && wanted(entry.path)),
            "bytes come with the files that are wanted");
        if (!entry.bytes) return;
        fuzz::require(entry.bytes->size() <= most_bytes,
                      "a file has at most the bytes that it may have");
        bytes_ += entry.bytes->size();
        fuzz::require(bytes_ <= limits.bytes, "all files are within the limit");
    }

private:
    static void check_refused(const ArchiveEntry& entry) {
        fuzz::require(!entry.refusal.empty() && !entry.bytes,
                      "a refusal has a reason, and nothing comes with it");
        fuzz::require(entry.path.size() <= 2048, "what is shown is short");
    }

    std::uint64_t last_ = 0;
    std::uint64_t bytes_ = 0;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile input;
    if (size == 0) return -1;
    input.with(fuzz::text_of(data + 1, size - 1));
    const auto format = data[0] % 2 == 0 ? grader::ArchiveFormat::zip
                                         : grader::ArchiveFormat::tar;
    Entries entries;
    try {
        grader::read_archive(
            input.rewound(), format, limits, wanted,
            [&](const ArchiveEntry& entry) { entries.take(entry); });
    } catch (const grader::ArchiveError& error) {
        fuzz::require(error.what()[0] != '\0', "a refusal has a reason");
    }
    return 0;
}

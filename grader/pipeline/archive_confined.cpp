// read_archive in a child: frames of entries from it, and their inspection.
#include <fmt/format.h>

#include <chrono>
#include <cstring>

#include "course/runner/codec.h"
#include "grader/pipeline/archive.h"
#include "grader/pipeline/archive_paths.h"
#include "grader/sandbox/confined.h"

namespace grader {

namespace {

constexpr std::uint64_t entry_frame = 'e';
constexpr std::uint64_t error_frame = 'x';
constexpr std::uint64_t end_frame = 'd';
constexpr std::size_t longest_text = 1000;  // of what the child says
constexpr std::uint64_t frame_overhead = 8192;

struct FrameStart {
    std::uint64_t length;
    std::uint64_t kind;
};

void send(int out, std::uint64_t kind, const std::string& body) {
    const FrameStart start{body.size(), kind};
    if (!course::write_all(out, &start, sizeof start) ||
        !course::write_all(out, body.data(), body.size()))
        throw course::SystemError("nobody reads the archive");
}

std::string cut(const std::string& text) {
    return text.substr(0, longest_text);
}

/// The entries that a child sent, looked at as if it were hostile: reading a
/// hostile archive it may have become so.
class EntryStream {
public:
    EntryStream(Confined& child, const ArchiveLimits& limits,
                unsigned cpu_seconds, const MostBytes& most_bytes)
        : child_(child),
          limits_(limits),
          patience_(2 * cpu_seconds + 5),
          most_bytes_(most_bytes) {}

    /// Nothing at the end. Throws ArchiveError.
    std::optional<ArchiveEntry> next() {
        const FrameStart start = receive_start();
        const std::string body = receive(start.length);
        if (start.kind == end_frame) return std::nullopt;
        if (start.kind == error_frame) throw ArchiveError(cut(body));
        if (start.kind != entry_frame) throw lied();
        ArchiveEntry entry;
        try {
            entry = course::decode<ArchiveEntry>(body);
        } catch (const course::CodecError&) {
            throw lied();
        }
        if (!is_possible(entry)) throw lied();
        return entry;
    }

private:
    static ArchiveError lied() {
        return ArchiveError(
            "could not be read (its process said what cannot be)");
    }

    FrameStart receive_start() {
        FrameStart start{};
        const std::string bytes = receive(sizeof start);
        std::memcpy(&start, bytes.data(), sizeof start);
        if (start.length > limits_.file_bytes + frame_overhead) throw lied();
        return start;
    }

    std::string receive(std::size_t size) {
        std::string bytes;
        const auto until = course::Clock::now() + patience_;
        const auto result =
            course::receive_all(child_.out(), bytes, size, until);
        if (result == course::Transfer::timed_out)
            throw ArchiveError("could not be read (its process hangs)");
        if (result == course::Transfer::closed) {
            const std::string how = child_.how_it_failed();
            throw ArchiveError(
                fmt::format("could not be read ({})",
                            how.empty() ? "its process ended too early" : how));
        }
        return bytes;
    }

    bool is_possible(const ArchiveEntry& entry) {
        if (entry.index != ++entries_ || entries_ > limits_.entries)
            return false;
        if (entry.path.size() > longest_path ||
            entry.refusal.size() > longest_text)
            return false;
        using Kind = ArchiveEntry::Kind;
        switch (entry.kind) {
            case Kind::refused:
                return !entry.refusal.empty() && !entry.bytes;
            case Kind::folder:
                return !entry.bytes && why_refused(entry.path).empty();
            case Kind::file:
                return !entry.path.empty() && why_refused(entry.path).empty() &&
                       has_possible_bytes(entry);
        }
        return false;
    }

    bool has_possible_bytes(const ArchiveEntry& entry) {
        const std::optional<std::size_t> most = most_bytes_(entry.path);
        if (most.has_value() != entry.bytes.has_value()) return false;
        if (!most) return true;
        bytes_ += entry.bytes->size();
        return entry.bytes->size() <= *most && bytes_ <= limits_.bytes;
    }

    Confined& child_;
    const ArchiveLimits& limits_;
    std::chrono::seconds patience_;
    const MostBytes& most_bytes_;
    std::uint64_t entries_ = 0;
    std::uint64_t bytes_ = 0;
};

}  // namespace

void read_archive_confined(int fd, ArchiveFormat format,
                           const ArchiveLimits& limits, unsigned cpu_seconds,
                           const MostBytes& most_bytes, const TakeEntry& take) {
    const auto work = [&](int out) {
        try {
            read_archive(fd, format, limits, most_bytes,
                         [out](const ArchiveEntry& entry) {
                             send(out, entry_frame, course::encode(entry));
                         });
            send(out, end_frame, {});
        } catch (const ArchiveError& error) {
            send(out, error_frame, cut(error.what()));
        }
    };
    ConfinedLimits confined;
    confined.cpu_seconds = cpu_seconds;
    Confined child(confined, std::span(&fd, 1), work);
    EntryStream stream(child, limits, cpu_seconds, most_bytes);
    while (auto entry = stream.next()) take(std::move(*entry));
}

}  // namespace grader

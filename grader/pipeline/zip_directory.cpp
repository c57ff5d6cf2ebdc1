#include "grader/pipeline/zip_directory.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string_view>

#include "course/report/text.h"
#include "grader/pipeline/archive.h"

namespace grader {

namespace {

using namespace std::string_view_literals;

constexpr std::uint64_t most_directory_bytes = std::uint64_t{256} << 20;
constexpr std::uint64_t encryption = 0x2041;       // of an entry's flags
constexpr std::uint64_t all_ones_16 = 0xffff;      // "see zip64"
constexpr std::uint64_t all_ones_32 = 0xffffffff;  // "see zip64"

/// The number of that many bytes, least first, as every number of a zip.
std::uint64_t number(std::string_view bytes, std::size_t at, int width) {
    if (at + static_cast<std::size_t>(width) > bytes.size())
        throw ArchiveError("the zip file is cut short");
    std::uint64_t value = 0;
    for (int k = width - 1; k >= 0; --k)
        value = value << 8 | static_cast<unsigned char>(
                                 bytes[at + static_cast<std::size_t>(k)]);
    return value;
}

std::uint64_t size_of(int fd) {
    struct stat status {};
    if (::fstat(fd, &status) != 0 || status.st_size < 0)
        throw ArchiveError("the file has no size");
    return static_cast<std::uint64_t>(status.st_size);
}

std::string bytes_at(int fd, std::uint64_t offset, std::uint64_t size) {
    std::string bytes(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got = ::pread(fd, bytes.data() + done, size - done,
                                    static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw ArchiveError("the zip file is cut short");
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

/// Where the directory lies.
struct Place {
    std::uint64_t entries, size, offset;
    std::uint64_t end;  ///< what follows the directory begins here
};

/// A number of the short record must be that of the long one, or all ones.
void check_zip64(std::uint64_t narrow, std::uint64_t ones, std::uint64_t wide) {
    if (narrow != wide && narrow != ones)
        throw ArchiveError(fmt::format(
            "the zip file says both {} and {} of its directory", narrow, wide));
}

/// The zip64 record, which the 20 bytes before `short_record` may point at.
Place widened(int fd, std::uint64_t short_record, const Place& narrow) {
    if (short_record < 20) return narrow;
    const std::string locator = bytes_at(fd, short_record - 20, 20);
    if (!locator.starts_with("PK\6\7"sv)) return narrow;
    const std::uint64_t at = number(locator, 8, 8);
    if (at > short_record) throw ArchiveError("the zip64 record lies outside");
    const std::string record = bytes_at(fd, at, 56);
    const Place wide = {number(record, 32, 8), number(record, 40, 8),
                        number(record, 48, 8), at};
    if (!record.starts_with("PK\6\6"sv) ||
        number(record, 4, 8) != short_record - 20 - at - 12 ||
        number(record, 24, 8) != wide.entries)
        throw ArchiveError("the zip64 record is broken");
    check_zip64(narrow.entries, all_ones_16, wide.entries);
    check_zip64(narrow.size, all_ones_32, wide.size);
    check_zip64(narrow.offset, all_ones_32, wide.offset);
    return wide;
}

/// Throws when the directory cannot lie there.
void check_place(const Place& place) {
    if (place.size > place.end || place.offset > place.end - place.size)
        throw ArchiveError("the zip file's directory lies outside of it");
    if (place.entries == 0 && place.end > 0)
        throw ArchiveError("the zip file is not empty, and says that it is");
    if (place.size > most_directory_bytes)
        throw ArchiveError(
            fmt::format("the zip file's directory has {} bytes; at most {} are "
                        "read",
                        place.size, most_directory_bytes));
}

Place find_directory(int fd) {
    const std::uint64_t size = size_of(fd);
    const std::uint64_t tail_size = std::min<std::uint64_t>(size, 22 + 65535);
    const std::string tail = bytes_at(fd, size - tail_size, tail_size);
    const std::size_t at = tail.rfind("PK\5\6"sv);
    if (at == tail.npos)
        throw ArchiveError(
            "it is no zip file or cut short: it has no directory at its end");
    if (at + 22 + number(tail, at + 20, 2) != tail.size())
        throw ArchiveError("the zip file does not end where it says");
    if (number(tail, at + 4, 4) != 0 ||
        number(tail, at + 8, 2) != number(tail, at + 10, 2))
        throw ArchiveError("the zip file is one part of several");
    const std::uint64_t record = size - tail_size + at;
    const Place place =
        widened(fd, record,
                {number(tail, at + 10, 2), number(tail, at + 12, 4),
                 number(tail, at + 16, 4), record});
    check_place(place);
    return place;
}

constexpr std::uint64_t zip64_kind = 1;
constexpr std::uint64_t times_kind = 0x5455;  // "UT": seconds since 1970

/// That field among the extra fields; empty where there is none.
std::string_view extra_field(std::string_view extra, std::uint64_t kind) {
    while (extra.size() >= 4) {
        const std::size_t size = number(extra, 2, 2);
        if (size > extra.size() - 4) break;
        if (number(extra, 0, 2) == kind) return extra.substr(4, size);
        extra.remove_prefix(4 + size);
    }
    return {};
}

/// Of the clock that the zip's maker saw, with steps of two seconds.
std::optional<FileTime> clock_time(std::uint64_t day, std::uint64_t time) {
    const std::chrono::year_month_day date(
        std::chrono::year(static_cast<int>(1980 + (day >> 9))),
        std::chrono::month(static_cast<unsigned>(day >> 5 & 15)),
        std::chrono::day(static_cast<unsigned>(day & 31)));
    if (!date.ok()) return std::nullopt;
    const auto days = std::chrono::sys_days(date).time_since_epoch();
    const std::uint64_t seconds =
        3600 * (time >> 11) + 60 * (time >> 5 & 63) + 2 * (time & 31);
    return FileTime{
        std::chrono::seconds(days).count() + static_cast<std::int64_t>(seconds),
        true};
}

std::optional<FileTime> time_of(std::string_view record,
                                std::string_view extra) {
    const std::string_view field = extra_field(extra, times_kind);
    constexpr int of_last_change = 1;
    if (field.size() >= 5 && (field[0] & of_last_change) != 0)
        return FileTime{static_cast<std::int32_t>(number(field, 1, 4)), false};
    return clock_time(number(record, 14, 2), number(record, 12, 2));
}

/// A size or offset of 32 bits, or of 64 in the field, in which only those
/// stand that are all ones here.
std::uint64_t wide_number(std::string_view record, std::size_t at,
                          std::string_view& field) {
    const std::uint64_t narrow = number(record, at, 4);
    if (narrow != all_ones_32 || field.empty()) return narrow;
    const std::uint64_t wide = number(field, 0, 8);
    field.remove_prefix(8);
    return wide;
}

/// Its name as messages say it: any bytes may stand in it.
std::string shown(const ZipEntry& entry) {
    return course::visible(entry.name.substr(0, 255));
}

[[noreturn]] void disagree(const ZipEntry& entry) {
    throw ArchiveError(
        fmt::format("{}: the zip file's directory and the entry's own header "
                    "disagree",
                    shown(entry)));
}

/// Compares what the directory and the local header say.
void check_same(std::string_view record, std::string_view local,
                const ZipEntry& entry) {
    constexpr std::uint64_t size_follows = 8;
    const std::uint64_t flags = number(local, 6, 2);
    if (!local.starts_with("PK\3\4"sv) || local.substr(30) != entry.name ||
        number(local, 26, 2) != entry.name.size() ||
        (flags & encryption) != (number(record, 8, 2) & encryption) ||
        number(local, 8, 2) != number(record, 10, 2))
        disagree(entry);
    for (const std::size_t at : {14u, 18u, 22u}) {  // sum, packed, inflated
        const std::uint64_t here = number(local, at, 4);
        const bool is_told =
            (flags & size_follows) == 0 && !(at > 14 && here == all_ones_32);
        if (is_told && here != number(record, at + 2, 4)) disagree(entry);
    }
}

/// Looks at the local header, and finds where the entry ends.
void check_local(int fd, std::string_view record, std::uint64_t packed_size,
                 std::uint64_t begin_of_directory, ZipEntry& entry) {
    const std::uint64_t head = 30 + entry.name.size();
    if (entry.offset > begin_of_directory ||
        head > begin_of_directory - entry.offset)
        throw ArchiveError(shown(entry) + ": lies outside of the zip file");
    const std::string local = bytes_at(fd, entry.offset, head);
    check_same(record, local, entry);
    entry.encrypted = (number(local, 6, 2) & encryption) != 0;
    entry.end = entry.offset + head + number(local, 28, 2);
    if (entry.end > begin_of_directory ||
        packed_size > begin_of_directory - entry.end)
        throw ArchiveError(shown(entry) + ": is cut short");
    entry.end += packed_size;
}

/// Takes one record from the front of the directory.
ZipEntry take_record(int fd, std::string_view& directory,
                     std::uint64_t begin_of_directory, std::uint64_t before) {
    const std::size_t name_size = number(directory, 28, 2);
    const std::size_t extra_size = number(directory, 30, 2);
    const std::size_t size =
        46 + name_size + extra_size + number(directory, 32, 2);
    if (!directory.starts_with("PK\1\2"sv) || size > directory.size())
        throw ArchiveError("the zip file's directory is broken");
    const std::string_view record = directory.substr(0, size);
    directory.remove_prefix(size);
    const std::string_view extra = record.substr(46 + name_size, extra_size);
    std::string_view field = extra_field(extra, zip64_kind);
    ZipEntry entry;
    entry.modified = time_of(record, extra);
    entry.name = record.substr(46, name_size);
    entry.size = wide_number(record, 24, field);
    const std::uint64_t packed_size = wide_number(record, 20, field);
    entry.offset = wide_number(record, 42, field);
    if (entry.offset > begin_of_directory)
        throw ArchiveError("the zip file's directory points outside");
    entry.offset += before;
    check_local(fd, record, packed_size, begin_of_directory, entry);
    return entry;
}

void check_apart(const std::vector<ZipEntry>& entries) {
    for (std::size_t k = 1; k < entries.size(); ++k)
        if (entries[k].offset < entries[k - 1].end)
            throw ArchiveError(shown(entries[k]) +
                               ": shares bytes with another entry");
}

}  // namespace

std::vector<ZipEntry> zip_directory(int fd, std::uint64_t most) {
    const Place place = find_directory(fd);
    if (place.entries > most)
        throw ArchiveError(fmt::format(
            "has {} entries; at most {} are looked at", place.entries, most));
    const std::uint64_t begin = place.end - place.size;
    const std::string bytes = bytes_at(fd, begin, place.size);
    std::string_view left = bytes;
    std::vector<ZipEntry> entries;
    for (std::uint64_t k = 0; k < place.entries; ++k)
        entries.push_back(take_record(fd, left, begin, begin - place.offset));
    if (!left.empty())
        throw ArchiveError("the zip file's directory has more than it says");
    std::sort(entries.begin(), entries.end(),
              [](const auto& a, const auto& b) { return a.offset < b.offset; });
    check_apart(entries);
    return entries;
}

}  // namespace grader

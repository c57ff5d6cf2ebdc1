#include "grader/pipeline/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "grader/pipeline/archive_paths.h"
#include "grader/pipeline/zip_directory.h"

namespace grader {

namespace {

/// libarchive turns names into the locale's characters and composes accents on
/// the way; in the plain locale they stay the bytes that they are.
class PlainLocale {
public:
    PlainLocale()
        : plain_(newlocale(LC_ALL_MASK, "C", nullptr)),
          before_(uselocale(plain_)) {}
    PlainLocale(const PlainLocale&) = delete;
    PlainLocale& operator=(const PlainLocale&) = delete;
    ~PlainLocale() {
        uselocale(before_);
        freelocale(plain_);
    }

private:
    locale_t plain_, before_;
};

struct Free {
    void operator()(archive* reader) const { archive_read_free(reader); }
};
using Handle = std::unique_ptr<archive, Free>;

/// A warning means that libarchive would start another program for it.
void check_support(int result) {
    if (result != ARCHIVE_OK)
        throw ArchiveError(
            "this machine's libarchive cannot read zip, tar, gzip, bzip2, xz "
            "and zstd by itself");
}

Handle reader_of(ArchiveFormat format) {
    Handle reader(archive_read_new());
    if (!reader) throw std::bad_alloc();
    if (format == ArchiveFormat::zip) {
        check_support(archive_read_support_format_zip_seekable(reader.get()));
        return reader;
    }
    check_support(archive_read_support_format_tar(reader.get()));
    check_support(archive_read_support_filter_gzip(reader.get()));
    check_support(archive_read_support_filter_bzip2(reader.get()));
    check_support(archive_read_support_filter_xz(reader.get()));
    check_support(archive_read_support_filter_zstd(reader.get()));
    return reader;
}

/// Reads one archive from its begin to its end.
class ArchiveReading {
public:
    ArchiveReading(int fd, ArchiveFormat format, const ArchiveLimits& limits,
                   const MostBytes& most_bytes)
        : format_(format), limits_(limits), most_bytes_(most_bytes) {
        if (format == ArchiveFormat::zip)
            directory_ = zip_directory(fd, limits.entries);
        ::lseek(fd, 0, SEEK_SET);
        reader_ = reader_of(format);
        constexpr std::size_t block = 1u << 16;
        if (archive_read_open_fd(reader_.get(), fd, block) != ARCHIVE_OK)
            throw broken();
        if (archive_filter_count(reader_.get()) > 2)  // and one for the file
            throw ArchiveError("is compressed more than once");
    }

    /// Nothing at the end of the archive.
    std::optional<ArchiveEntry> next() {
        archive_entry* head = nullptr;
        const la_int64_t before = archive_filter_bytes(reader_.get(), 0);
        const int result = archive_read_next_header(reader_.get(), &head);
        if (result == ARCHIVE_EOF) {
            check_end(before);
            return std::nullopt;
        }
        ++index_;
        if (result != ARCHIVE_OK && result != ARCHIVE_WARN) throw broken();
        if (index_ > limits_.entries)
            throw ArchiveError(fmt::format(
                "has more than {} entries, and no more are looked at",
                limits_.entries));
        count(0);
        ArchiveEntry entry = described(head);
        read_data(entry);
        return entry;
    }

private:
    /// Whether all is there: a tar that is cut between two entries ends without
    /// the zeros that are its end mark.
    void check_end(la_int64_t before) const {
        if (format_ == ArchiveFormat::zip && index_ != directory_.size())
            throw unlike_directory();
        if (format_ == ArchiveFormat::tar &&
            archive_filter_bytes(reader_.get(), 0) <= before)
            throw ArchiveError(fmt::format(
                "is cut short: after entry {} its end mark is missing",
                index_));
    }

    ArchiveError broken() const {
        const char* text = archive_error_string(reader_.get());
        return ArchiveError(
            fmt::format("entry {}: {}", index_,
                        text == nullptr ? "libarchive cannot read it" : text));
    }

    ArchiveError unlike_directory() const {
        return ArchiveError(
            fmt::format("entry {}: the zip file's directory says something "
                        "else than was read",
                        index_));
    }

    static void refuse(ArchiveEntry& entry, std::string why) {
        entry.kind = ArchiveEntry::Kind::refused;
        entry.refusal = std::move(why);
    }

    /// Its name, as it stands in the archive.
    std::optional<std::string> name_of(archive_entry* head) const {
        if (format_ == ArchiveFormat::zip) return listed(head).name;
        const char* name = archive_entry_pathname(head);
        if (name == nullptr) return std::nullopt;
        return name;
    }

    std::optional<FileTime> time_of(archive_entry* head) const {
        if (format_ == ArchiveFormat::zip) return listed(head).modified;
        if (archive_entry_mtime_is_set(head) == 0) return std::nullopt;
        return FileTime{archive_entry_mtime(head), false};
    }

    const ZipEntry& listed(archive_entry* head) const {
        if (index_ > directory_.size()) throw unlike_directory();
        const ZipEntry& entry = directory_[index_ - 1];
        if (archive_entry_filetype(head) == AE_IFREG &&
            archive_entry_size_is_set(head) != 0 &&
            static_cast<std::uint64_t>(archive_entry_size(head)) != entry.size)
            throw unlike_directory();
        return entry;
    }

    /// Kind, name, and whether it is refused for one of them.
    ArchiveEntry described(archive_entry* head) const {
        ArchiveEntry entry;
        entry.index = index_;
        const std::optional<std::string> name = name_of(head);
        if (!name) {
            refuse(entry, "has a name that cannot be told");
            return entry;
        }
        entry.path = plain_path(*name);
        entry.modified = time_of(head);
        entry.kind =
            archive_entry_filetype(head) == AE_IFDIR || name->ends_with('/')
                ? ArchiveEntry::Kind::folder
                : ArchiveEntry::Kind::file;
        std::string why = why_refused(entry.path);
        if (why.empty()) why = why_no_file(head);
        if (why.empty() && entry.path.empty() &&
            entry.kind == ArchiveEntry::Kind::file)
            why = "has no name";
        if (!why.empty()) refuse(entry, std::move(why));
        entry.path.resize(std::min(entry.path.size(), longest_path));
        return entry;
    }

    std::string why_no_file(archive_entry* head) const {
        if (archive_entry_hardlink(head) != nullptr) return "is a hard link";
        const auto type = archive_entry_filetype(head);
        if (type == AE_IFLNK) return "is a symbolic link";
        if (type != AE_IFREG && type != AE_IFDIR && type != 0)
            return "is not a regular file";
        if (archive_entry_sparse_count(head) > 0) return "is stored with holes";
        if (format_ == ArchiveFormat::zip && listed(head).encrypted)
            return "is encrypted";
        return {};
    }

    /// The bytes of a wanted file. In a tar the others pass by as well, here
    /// where they are counted, and not unseen on the way to the next entry.
    void read_data(ArchiveEntry& entry) {
        std::optional<std::size_t> most;
        if (entry.kind == ArchiveEntry::Kind::file)
            most = most_bytes_(entry.path);
        if (!most && format_ == ArchiveFormat::zip) return;
        std::string bytes;
        bool fits = true;
        while (const auto block = next_block()) {
            fits = fits && most && bytes.size() + block->size() <= *most;
            if (fits) bytes.append(*block);
            if (!fits && format_ == ArchiveFormat::zip) break;
        }
        if (fits && most && format_ == ArchiveFormat::zip &&
            bytes.size() != directory_[index_ - 1].size)
            throw unlike_directory();
        if (most && fits)
            entry.bytes = std::move(bytes);
        else if (most)
            refuse(entry, fmt::format("has more than {} bytes, and no more "
                                      "are taken",
                                      *most));
    }

    std::optional<std::string_view> next_block() {
        const void* data = nullptr;
        std::size_t size = 0;
        la_int64_t offset = 0;
        const int result =
            archive_read_data_block(reader_.get(), &data, &size, &offset);
        if (result == ARCHIVE_EOF) return std::nullopt;
        if (result != ARCHIVE_OK) throw broken();  // a wrong sum is a warning
        count(size);
        return std::string_view(static_cast<const char*>(data), size);
    }

    /// Counts what was inflated; in a tar that is headers as well.
    void count(std::size_t size) {
        data_ += size;
        if (format_ == ArchiveFormat::tar)
            data_ = static_cast<std::uint64_t>(
                archive_filter_bytes(reader_.get(), 0));
        if (data_ > limits_.bytes)
            throw ArchiveError(
                fmt::format("entry {}: inflates to more than {} bytes, and no "
                            "more are read",
                            index_, limits_.bytes));
    }

    ArchiveFormat format_;
    const ArchiveLimits& limits_;
    const MostBytes& most_bytes_;
    std::vector<ZipEntry> directory_;
    Handle reader_;
    std::uint64_t index_ = 0;
    std::uint64_t data_ = 0;
};

}  // namespace

void read_archive(int fd, ArchiveFormat format, const ArchiveLimits& limits,
                  const MostBytes& most_bytes, const TakeEntry& take) {
    const PlainLocale locale;
    ArchiveReading reading(fd, format, limits, most_bytes);
    while (auto entry = reading.next()) take(std::move(*entry));
}

}  // namespace grader

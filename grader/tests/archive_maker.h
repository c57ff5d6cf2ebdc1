// Archives for the tests, made in memory: honest ones by libarchive, and those
// that no honest program writes byte by byte.
#pragma once

#include <archive.h>
#include <archive_entry.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace grader::tests {

/// One entry for libarchive to write.
struct Packed {
    std::string path;
    std::string bytes = "int x;";
    unsigned type = AE_IFREG;
    unsigned mode = 0644;
    std::string link = {};       ///< target of a symbolic link
    std::string hard_link = {};  ///< target of a hard link
};

/// Which archive: format and filter by libarchive's names, and options.
struct Maker {  // no filter: ""
    const char* format = "zip";
    const char* filter = "";
    const char* options = "";
};

inline const Maker zip = {};
inline const Maker tar = {"pax", "", ""};
inline const Maker gnu_tar = {"gnutar", "", ""};
inline const Maker tar_gz = {"pax", "gzip", "gzip:compression-level=1"};
inline const Maker tar_bz2 = {"pax", "bzip2", "bzip2:compression-level=1"};
inline const Maker tar_xz = {"pax", "xz", "xz:compression-level=0"};
inline const Maker tar_zst = {"pax", "zstd", "zstd:compression-level=1"};

/// Writes an archive into a string, entry by entry.
class ArchiveWriter {
public:
    explicit ArchiveWriter(const Maker& maker) {
        const auto no_close = [](archive*, void*) { return ARCHIVE_OK; };
        check(archive_write_set_format_by_name(to_.get(), maker.format));
        if (*maker.filter != '\0')
            check(archive_write_add_filter_by_name(to_.get(), maker.filter));
        check(archive_write_set_options(to_.get(), maker.options));
        archive_write_set_bytes_in_last_block(to_.get(), 1);
        check(
            archive_write_open(to_.get(), &bytes_, nullptr, append, no_close));
    }

    ArchiveWriter& add(const Packed& packed) { return add_zeros(packed, 0); }

    /// The entry's bytes and then so many zeros.
    ArchiveWriter& add_zeros(const Packed& packed, std::size_t zeros) {
        const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(
            archive_entry_new(), archive_entry_free);
        archive_entry_set_pathname(entry.get(), packed.path.c_str());
        archive_entry_set_filetype(entry.get(), packed.type);
        archive_entry_set_perm(entry.get(), static_cast<mode_t>(packed.mode));
        if (!packed.link.empty())
            archive_entry_set_symlink(entry.get(), packed.link.c_str());
        if (!packed.hard_link.empty())
            archive_entry_set_hardlink(entry.get(), packed.hard_link.c_str());
        const bool has_data =
            packed.type == AE_IFREG && packed.hard_link.empty();
        archive_entry_set_size(
            entry.get(),
            has_data ? static_cast<la_int64_t>(packed.bytes.size() + zeros)
                     : 0);
        check(archive_write_header(to_.get(), entry.get()));
        if (has_data) write(packed.bytes, zeros);
        return *this;
    }

    std::string finish() {
        check(archive_write_close(to_.get()));
        return bytes_;
    }

private:
    struct Free {
        void operator()(archive* a) const { archive_write_free(a); }
    };

    static la_ssize_t append(archive*, void* to, const void* data,
                             std::size_t size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              size);
        return static_cast<la_ssize_t>(size);
    }

    void check(int result) const {
        if (result != ARCHIVE_OK && result != ARCHIVE_WARN)
            throw std::runtime_error(archive_error_string(to_.get()));
    }

    void write(const std::string& bytes, std::size_t zeros) {
        archive_write_data(to_.get(), bytes.data(), bytes.size());
        const std::string block(1u << 20, '\0');
        for (; zeros > 0; zeros -= std::min(zeros, block.size()))
            archive_write_data(to_.get(), block.data(),
                               std::min(zeros, block.size()));
    }

    std::string bytes_;
    std::unique_ptr<archive, Free> to_{archive_write_new()};
};

inline std::string packed(const Maker& maker,
                          const std::vector<Packed>& entries) {
    ArchiveWriter writer(maker);
    for (const Packed& entry : entries) writer.add(entry);
    return writer.finish();
}

/// An archive of one file with so many zeros.
inline std::string bomb(const Maker& maker, const std::string& path,
                        std::size_t zeros) {
    return ArchiveWriter(maker).add_zeros({path, ""}, zeros).finish();
}

// ---- byte by byte

/// A number of that many bytes, least first.
inline std::string little(std::uint64_t value, int width) {
    std::string bytes;
    for (int k = 0; k < width; ++k)
        bytes += static_cast<char>(value >> (8 * k) & 0xff);
    return bytes;
}

inline std::uint32_t crc32_of(std::string_view bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

/// A stored entry of a zip, and what it lies about.
struct ZipPart {
    std::string name;
    std::string bytes = "int x;";
    std::string local_name = name;
    unsigned flags = 0;
    unsigned mode = S_IFREG | 0644;
    std::uint32_t crc = crc32_of(bytes);
    std::uint64_t local_size = bytes.size();
    std::uint64_t size = bytes.size();
    std::string extra = {};                    ///< in the directory
    std::uint64_t offset = ~std::uint64_t{0};  ///< all ones: the right one
};

/// What the end of a zip says of its directory.
struct ZipEnd {
    std::uint64_t entries;
    std::uint64_t size;
    std::uint64_t offset;
    std::string before = {};  ///< between directory and end: a zip64 record
    std::string comment = {};
};

inline std::string zip_local(const ZipPart& part) {
    return "PK\3\4" + little(20, 2) + little(part.flags, 2) + little(0, 2) +
           little(0, 4) + little(part.crc, 4) + little(part.local_size, 4) +
           little(part.local_size, 4) + little(part.local_name.size(), 2) +
           little(0, 2) + part.local_name + part.bytes;
}

inline std::string zip_record(const ZipPart& part, std::uint64_t offset) {
    return "PK\1\2" + little(0x314, 2) + little(20, 2) + little(part.flags, 2) +
           little(0, 2) + little(0, 4) + little(part.crc, 4) +
           little(part.size, 4) + little(part.size, 4) +
           little(part.name.size(), 2) + little(part.extra.size(), 2) +
           little(0, 2) + little(0, 4) +
           little(std::uint64_t{part.mode} << 16, 4) + little(offset, 4) +
           part.name + part.extra;
}

inline std::string zip_end(const ZipEnd& end) {
    return end.before + "PK\5\6" + little(0, 4) + little(end.entries, 2) +
           little(end.entries, 2) + little(end.size, 4) +
           little(end.offset, 4) + little(end.comment.size(), 2) + end.comment;
}

/// The entries and the directory of a zip, and where the latter lies.
struct ZipBody {
    std::string bytes;
    ZipEnd end;
};

inline ZipBody zip_body(const std::vector<ZipPart>& parts) {
    std::string bytes, directory;
    for (const ZipPart& part : parts) {
        const std::uint64_t offset =
            part.offset == ~std::uint64_t{0} ? bytes.size() : part.offset;
        directory += zip_record(part, offset);
        bytes += zip_local(part);
    }
    const ZipEnd end = {parts.size(), directory.size(), bytes.size()};
    return {bytes + directory, end};
}

inline std::string zip_of(const std::vector<ZipPart>& parts) {
    const ZipBody body = zip_body(parts);
    return body.bytes + zip_end(body.end);
}

inline std::string octal(std::uint64_t value, std::size_t width) {
    std::string digits(width, '0');
    for (std::size_t k = width; k-- > 0; value /= 8)
        digits[k] = static_cast<char>('0' + value % 8);
    return digits;
}

/// One entry of a tar: its header, as it is, and its bytes.
struct TarPart {
    std::string name;
    char type = '0';
    std::string bytes = "int x;";
    std::string link = {};
    std::string size = octal(bytes.size(), 11);  ///< as it is said
};

inline std::string tar_part(const TarPart& part) {
    std::string head(512, '\0');
    head.replace(0, std::min<std::size_t>(part.name.size(), 100), part.name, 0,
                 100);
    head.replace(100, 7, "0000644");
    head.replace(108, 7, "0000000");
    head.replace(116, 7, "0000000");
    head.replace(124, part.size.size(), part.size);
    head.replace(136, 11, octal(0, 11));
    head.replace(148, 8, "        ");
    head[156] = part.type;
    head.replace(157, part.link.size(), part.link);
    head.replace(257, 8, std::string("ustar\00000", 8));
    unsigned sum = 0;
    for (const char c : head) sum += static_cast<unsigned char>(c);
    head.replace(148, 7, octal(sum, 6) + '\0');
    const std::string padding((512 - part.bytes.size() % 512) % 512, '\0');
    return head + part.bytes + padding;
}

inline std::string tar_of(const std::vector<TarPart>& parts) {
    std::string bytes;
    for (const TarPart& part : parts) bytes += tar_part(part);
    return bytes + std::string(1024, '\0');
}

/// "25 path=../x\n": its length counts itself.
inline std::string pax_record(const std::string& key,
                              const std::string& value) {
    const std::string rest = " " + key + "=" + value + "\n";
    std::string length = "1";
    while (std::to_string(length.size() + rest.size()) != length)
        length = std::to_string(length.size() + rest.size());
    return length + rest;
}

}  // namespace grader::tests

// Archives that no student hands in by mistake, and what is said of each.
#pragma once

#include <random>

#include "grader/tests/archive_maker.h"

namespace grader::tests {

struct HostileArchive {
    std::string what;
    std::string name;   ///< of the file in the student's folder
    std::string bytes;  ///< holds a face_sides.cpp where it can
    std::string note;   ///< a part of what the student's notes must say
};

// ---- names

/// Names, and why each is refused.
inline const std::vector<std::pair<std::string, std::string>> bad_names = {
    {"../face_sides.cpp", "leads out of its folder by \"..\""},
    {"a/../../face_sides.cpp", "leads out of its folder by \"..\""},
    {"a/..", "leads out of its folder"},
    {"../anna-evil/face_sides.cpp", "leads out of its folder"},
    {"/face_sides.cpp", "has an absolute path"},
    {"//server/face_sides.cpp", "has an absolute path"},
    {"C:/face_sides.cpp", "begins with a drive letter"},
    {"c:face_sides.cpp", "begins with a drive letter"},
    {"..\\face_sides.cpp", "has a backslash in its name"},
    {"a//face_sides.cpp", "has an empty folder name"},
    {"a/./face_sides.cpp", "has \".\" in its path"},
    {"a/" + std::string(256, 'n') + "/face_sides.cpp", "a name of 256"},
    {std::string(1100, 'n'), "has a path of 1100 bytes"},
};

inline void add_names(std::vector<HostileArchive>& all) {
    for (const auto& [name, why] : bad_names) {
        all.push_back({"zip: " + name, "a.zip", zip_of({{name}}), why});
        const std::string header =
            tar_part({"x", 'x', pax_record("path", name)});
        all.push_back({"pax: " + name, "a.tar",
                       header + tar_of({{"face_sides.cpp"}}), why});
        if (name.size() <= 100)
            all.push_back({"tar: " + name, "a.tar", tar_of({{name}}), why});
    }
}

inline void add_odd_names(std::vector<HostileArchive>& all) {
    using namespace std::string_literals;
    all.push_back({"the root", "a.zip", zip_of({{"/"}}),
                   "a.zip//: has an absolute path: refused"});
    all.push_back({"NUL", "a.zip", zip_of({{"face_sides.cpp\0.txt"s}}),
                   "a.zip/face_sides.cpp\0.txt: has a NUL in its name"s});
    all.push_back({"no name", "a.zip", zip_of({{""}}),
                   "a.zip/entry 1: has no name: refused"});
    std::string deep;
    for (int k = 0; k < 500; ++k) deep += "d/";
    all.push_back({"500 folders", "a.zip", zip_of({{deep + "face_sides.cpp"}}),
                   "a.zip/d/d/d/: lies more than 3 folders deep"});
}

// ---- what is no file

inline void add_kinds(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    const std::string is_link = ": is a symbolic link: refused";
    for (const auto& [file, maker] :
         {std::pair<std::string, Maker>{"a.zip", zip}, {"a.tar", tar}})
        all.push_back(
            {"symbolic link in " + file, file,
             packed(maker, {{name, "", AE_IFLNK, 0777, "/etc/passwd"}}),
             file + "/face_sides.cpp" + is_link});
    all.push_back({"a file through a link", "a.tar",
                   tar_of({{"out", '2', "", "/tmp"}, {"out/evil.cpp"}}),
                   "a.tar/out" + is_link});
    all.push_back({"hard link", "a.tar",
                   tar_of({{name, '1', "", "/etc/passwd"}}),
                   "a.tar/face_sides.cpp: is a hard link: refused"});
    all.push_back({"hard link to what is no character", "a.tar",
                   tar_part({"x", 'x', pax_record("linkpath", "\xC3\x84")}) +
                       tar_of({{name, '1', "", "/etc/passwd"}}),
                   "a.tar/face_sides.cpp: is a hard link: refused"});
}

inline void add_devices(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    for (const char type : {'3', '4', '6'})
        all.push_back({"tar type " + std::string(1, type), "a.tar",
                       tar_of({{name, type, ""}}),
                       "face_sides.cpp: is not a regular file: refused"});
    for (const unsigned mode : {0020000u, 0060000u, 0140000u}) {
        ZipPart part = {name};
        part.mode = mode | 0666;
        all.push_back({"zip mode " + std::to_string(mode), "a.zip",
                       zip_of({part}),
                       "face_sides.cpp: is not a regular file: refused"});
    }
}

// ---- too much

inline constexpr std::size_t mb = 1u << 20;
inline const std::string too_much = "inflates to more than 67108864 bytes";

inline void add_large_files(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    std::string liar = bomb(zip, name, 32 * mb);
    liar.replace(liar.rfind("PK\1\2") + 24, 4, little(100, 4));
    all.push_back(
        {"zip that says 100 bytes", "a.zip", liar, "nothing is taken from it"});
    all.push_back({"file of 32 MB", "a.zip", bomb(zip, name, 32 * mb),
                   "a.zip/face_sides.cpp: has more than 4194304 bytes"});
    all.push_back({"file of 32 MB in a tar", "a.tgz",
                   bomb(tar_gz, name, 32 * mb),
                   "a.tgz/face_sides.cpp: has more than 4194304 bytes"});
}

inline void add_bombs(std::vector<HostileArchive>& all) {
    const std::vector<std::pair<std::string, std::string>> bombs = {
        {"a.tar.gz", bomb(tar_gz, "x", 1024 * mb)},
        {"a.tar.zst", bomb(tar_zst, "x", 1024 * mb)},
        {"a.tar.xz", bomb(tar_xz, "x", 200 * mb)},
        {"a.tar.bz2", bomb(tar_bz2, "x", 200 * mb)}};
    for (const auto& [file, bytes] : bombs)
        all.push_back(
            {file + " of zeros", file, bytes, file + ": entry 1: " + too_much});
}

inline void add_long_headers(std::vector<HostileArchive>& all) {
    std::string headers;
    for (int k = 0; k < 100; ++k)
        headers +=
            tar_part(
                {"x", 'x', pax_record("comment", std::string(mb - 99, 'x'))}) +
            tar_part({"y", '0', ""});
    all.push_back({"100 MB of headers", "a.tar.zst",
                   ArchiveWriter({"raw", "zstd", ""})
                       .add({"x", headers + std::string(1024, '\0')})
                       .finish(),
                   too_much});
    all.push_back({"compressed twice", "a.tar.gz",
                   ArchiveWriter({"raw", "gzip", ""})
                       .add({"x", bomb(tar_gz, "face_sides.cpp", mb)})
                       .finish(),
                   "is compressed more than once"});
}

inline void add_floods(std::vector<HostileArchive>& all) {
    ArchiveWriter many(tar_zst), several(zip);
    for (int k = 0; k < 100'000; ++k) many.add({std::to_string(k), ""});
    for (int k = 0; k < 2500; ++k) several.add({std::to_string(k), ""});
    all.push_back({"100 000 entries", "a.tar.zst", many.finish(),
                   "has more than 20000 entries"});
    all.push_back({"2500 entries", "a.zip", several.finish(),
                   "at most 2000 files and folders are looked at, and a.zip "
                   "has more"});
    ZipBody body = zip_body({{"face_sides.cpp"}});
    body.end.entries = 60'000;
    all.push_back({"says 60 000 entries", "a.zip",
                   body.bytes + zip_end(body.end), "has 60000 entries"});
    const std::string inner = packed(zip, {{"face_sides.cpp"}});
    all.push_back({"archive in an archive", "a.zip",
                   packed(zip, {{"b.zip", packed(zip, {{"c.zip", inner}})}}),
                   "a.zip/b.zip: is an archive in an archive: not opened"});
}

// ---- zips that contradict themselves

inline void add_zip_lies(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    const std::string disagree =
        "directory and the entry's own header disagree";
    ZipPart other_name = {"harmless.txt"}, other_size = {name},
            other_flags = {name}, encrypted = {name}, bad_sum = {name},
            twice = {"b.zip"};
    other_name.local_name = name;
    other_size.local_size = 2;
    encrypted.flags = 1;
    bad_sum.crc = 1;
    twice.offset = 0;
    all.push_back({"two names", "a.zip", zip_of({other_name}), disagree});
    all.push_back({"two sizes", "a.zip", zip_of({other_size}), disagree});
    std::string flags = zip_of({other_flags});
    flags[6] = 1;
    all.push_back({"encrypted in one place", "a.zip", flags, disagree});
    all.push_back({"encrypted", "a.zip", zip_of({encrypted}),
                   "a.zip/face_sides.cpp: is encrypted: refused"});
    all.push_back({"wrong sum", "a.zip", zip_of({bad_sum}),
                   "a.zip: entry 1: ZIP bad CRC"});
    ZipPart first = {"b.zip"};
    all.push_back({"two entries, the same bytes", "a.zip",
                   zip_of({first, twice}), "shares bytes with another entry"});
    ZipPart around = {name, zip_local({"b.cpp"})}, within = {"b.cpp"};
    within.offset = 30 + name.size();
    all.push_back({"an entry in an entry", "a.zip", zip_of({around, within}),
                   "shares bytes with another entry"});
}

inline void add_zip_ends(std::vector<HostileArchive>& all) {
    const std::string good = zip_of({{"face_sides.cpp"}});
    all.push_back({"cut short", "a.zip", good.substr(0, good.size() - 30),
                   "it is no zip file or cut short"});
    all.push_back(
        {"begins too late", "a.zip", good.substr(20), "lies outside of it"});
    all.push_back({"something behind it", "a.zip", good + "x",
                   "does not end where it says"});
    ZipBody body = zip_body({{"face_sides.cpp"}});
    ZipEnd end = body.end;
    end.size = 0xfffffff0;
    all.push_back({"directory of 4 GB", "a.zip", body.bytes + zip_end(end),
                   "lies outside of it"});
    end = body.end;
    end.entries = 0;
    all.push_back({"says no entries", "a.zip", body.bytes + zip_end(end),
                   "is not empty, and says that it is"});
    ZipBody two = zip_body({{"face_sides.cpp"}, {"prev.cpp"}});
    two.end.entries = 1;
    all.push_back({"says one less", "a.zip", two.bytes + zip_end(two.end),
                   "has more than it says"});
    end.entries = 2;
    all.push_back(
        {"says one more", "a.zip", body.bytes + zip_end(end), "cut short"});
    end = body.end;
    end.comment = zip_end({0, 0, 0});
    all.push_back({"a second end in its comment", "a.zip",
                   body.bytes + zip_end(end), "nothing is taken from it"});
}

/// A zip64 record before the end, which says so of the directory.
inline std::string with_zip64(std::uint64_t entries, std::uint64_t size,
                              std::uint64_t offset) {
    ZipBody body = zip_body({{"face_sides.cpp"}});
    const std::uint64_t at = body.bytes.size();
    body.end.before = "PK\6\6" + little(44, 8) + little(45, 2) + little(45, 2) +
                      little(0, 8) + little(entries, 8) + little(entries, 8) +
                      little(size, 8) + little(offset, 8) + "PK\6\7" +
                      little(0, 4) + little(at, 8) + little(1, 4);
    body.end.entries = 0xffff;
    body.end.size = body.end.offset = 0xffffffff;
    return body.bytes + zip_end(body.end);
}

inline void add_zip64_lies(std::vector<HostileArchive>& all) {
    constexpr std::uint64_t huge = std::uint64_t{1} << 63;
    all.push_back({"zip64: directory of 2^63", "a.zip", with_zip64(1, huge, 0),
                   "lies outside of it"});
    all.push_back({"zip64: directory at 2^63", "a.zip", with_zip64(1, 60, huge),
                   "lies outside of it"});
    all.push_back({"zip64: 2^63 entries", "a.zip", with_zip64(huge, 60, 0),
                   "has 9223372036854775808 entries"});
    ZipPart part = {"face_sides.cpp"};
    part.size = 0xffffffff;
    part.extra =
        little(1, 2) + little(16, 2) + little(huge, 8) + little(huge, 8);
    all.push_back({"zip64: entry of 2^63", "a.zip", zip_of({part}),
                   "nothing is taken from it"});
    part.extra = little(1, 2) + little(4, 2) + little(7, 4);
    all.push_back({"zip64: field cut short", "a.zip", zip_of({part}),
                   "nothing is taken from it"});
}

// ---- tars that lie

inline void add_tar_lies(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    const std::string nothing = "nothing is taken from it";
    TarPart part = {name};
    part.size = "\x80" + std::string(3, '\0') + "\x80" + std::string(7, '\0');
    all.push_back({"size of 2^63", "a.tar", tar_of({part}), nothing});
    part.size = std::string(12, '\xff');
    all.push_back({"negative size", "a.tar", tar_of({part}), nothing});
    part.size = octal(std::uint64_t{1} << 32, 11);
    all.push_back({"size of 4 GB", "a.tar", tar_of({part}), nothing});
    all.push_back(
        {"sparse file of 1 TB", "a.tar",
         tar_part({"x", 'x',
                   pax_record("GNU.sparse.major", "0") +
                       pax_record("GNU.sparse.minor", "1") +
                       pax_record("GNU.sparse.size", "1099511627776") +
                       pax_record("GNU.sparse.map", "0,6") +
                       pax_record("GNU.sparse.numblocks", "1")}) +
             tar_of({{name}}),
         "a.tar/face_sides.cpp: is stored with holes: refused"});
}

inline void add_tar_headers(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    const std::string nothing = "nothing is taken from it";
    all.push_back(
        {"header of 100 MB", "a.tar.zst",
         ArchiveWriter({"raw", "zstd", ""})
             .add({"x", tar_part({"x", 'x', std::string(100u << 20, 'x')})})
             .finish(),
         nothing});
    all.push_back(
        {"long name of 10 MB", "a.tar",
         tar_part({"././@LongLink", 'L', std::string(10u << 20, 'n')}) +
             tar_of({{name}}),
         nothing});
    all.push_back({"long name that leads out", "a.tar",
                   tar_part({"././@LongLink", 'L', "../face_sides.cpp"}) +
                       tar_of({{name}}),
                   "a.tar/../face_sides.cpp: leads out of its folder"});
}

inline void add_cut_tars(std::vector<HostileArchive>& all) {
    const std::string name = "face_sides.cpp";
    const std::string nothing = "nothing is taken from it";
    all.push_back({"tar cut short between entries", "a.tar",
                   tar_part({name}) + tar_part({"prev.cpp"}),
                   "after entry 2 its end mark is missing"});
    std::string bad_sum = tar_of({{name}, {"prev.cpp"}});
    bad_sum[1024 + 5] ^= 1;
    all.push_back({"second header is broken", "a.tar", bad_sum, nothing});
    const std::string good = tar_of({{name, '0', std::string(5000, 'x')}});
    all.push_back({"tar cut short", "a.tar", good.substr(0, 3000), nothing});
    const std::string gz =
        packed(tar_gz, {{name, std::string(1000, 'x')}, {"prev.cpp"}});
    all.push_back(
        {"tar.gz cut short", "a.tar.gz", gz.substr(0, gz.size() / 2), nothing});
}

// ---- what is no zip and no tar

inline void add_impostors(std::vector<HostileArchive>& all) {
    using namespace std::string_literals;
    const std::string nothing = "nothing is taken from it";
    std::mt19937 random(1);
    std::string noise;
    for (int k = 0; k < 10'000; ++k) noise += static_cast<char>(random() & 255);
    const std::vector<std::pair<std::string, std::string>> files = {
        {"empty file", ""},
        {"noise", noise},
        {"text", "face_sides.cpp is in the mail\n"},
        {"rar", "Rar!\x1a\7\0"s + noise},
        {"7z", "7z\xbc\xaf\x27\x1c" + noise},
        {"cpio", packed({"newc", "", ""}, {{"face_sides.cpp"}})},
        {"7z by its writer", packed({"7zip", "", ""}, {{"face_sides.cpp"}})},
        {"ar", packed({"ar", "", ""}, {{"face_sides.cpp"}})},
        {"mtree", "#mtree\nface_sides.cpp type=file contents=/etc/passwd\n"},
        {"half a program", "#!/bin/sh\nrm -rf /\n"}};
    for (const auto& [what, bytes] : files)
        for (const char* name : {"a.zip", "a.tar", "a.tar.gz"})
            all.push_back({what + " as " + name, name, bytes, nothing});
    all.push_back(
        {"tar as zip", "a.zip", packed(tar, {{"face_sides.cpp"}}), nothing});
    all.push_back(
        {"zip as tar", "a.tar", packed(zip, {{"face_sides.cpp"}}), nothing});
}

inline std::vector<HostileArchive> hostile_archives() {
    std::vector<HostileArchive> all;
    for (const auto add :
         {add_names, add_odd_names, add_kinds, add_devices, add_large_files,
          add_bombs, add_long_headers, add_floods, add_zip_lies, add_zip_ends,
          add_zip64_lies, add_tar_lies, add_tar_headers, add_cut_tars,
          add_impostors})
        add(all);
    return all;
}

}  // namespace grader::tests

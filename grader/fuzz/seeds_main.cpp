// fuzz_seeds DIR: the first inputs of the fuzzers of binary data, a folder for
// each, written by the code that will read them.
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "course/mesh/zoo.h"
#include "course/runner/codec.h"
#include "course/runner/judge_stream.h"
#include "course/runner/protocol.h"
#include "grader/fuzz/types.h"

namespace {

using namespace course;
namespace fs = std::filesystem;

fs::path folder;

void write(const std::string& name, const std::string& bytes) {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        throw SystemError(file.string() + ": cannot be written");
}

// A value of each type that is not empty, where an empty one says little.
template <class T>
T sample() {
    return {};
}
template <>
HalfEdgeTable sample() {
    return zoo::triangle().he;
}
template <>
std::optional<int> sample() {
    return 3;
}
template <>
std::map<int, int> sample() {
    return {{-1, 0}, {4, 3}};
}
template <>
std::vector<int> sample() {
    return {1, -1, 7};
}
template <>
std::vector<std::vector<int>> sample() {
    return {{1, 2}, {}, {3}};
}
template <>
std::vector<Finding> sample() {
    return {{Fault::opp_is_itself, 4}};
}
template <>
std::vector<bool> sample() {
    return {true, false, true};
}
template <>
std::vector<CaseInfo> sample() {
    return {{"first", 2, Visibility::shown}, {"second", 3}};
}
template <>
std::vector<Failure> sample() {
    const Fixture triangle = zoo::triangle();
    return {{"f(he, 1)",
             "2",
             "3",
             "a note",
             {"triangle", triangle.he.rows(), triangle.mesh.positions},
             {{1, 12}, {4, 13}},
             2}};
}
template <>
CaseResult sample() {
    return {{"first", 2, Visibility::shown},
            Verdict::wrong_answer,
            sample<std::vector<Failure>>(),
            "a hint",
            "printed\n"};
}

std::string byte(std::size_t n) {
    return std::string(1, static_cast<char>(n));
}

void write_codec() {
    for (std::size_t k = 0; k < std::tuple_size_v<fuzz::AllTypes>; ++k)
        fuzz::with_type(std::type_identity<fuzz::AllTypes>(), k,
                        [&]<class T>(std::type_identity<T>) {
                            write("codec/" + std::to_string(k),
                                  byte(k) + encode(sample<T>()));
                        });
}

std::string frame(char kind, const std::string& body) {
    return encode(std::uint64_t{body.size()}) +
           encode(static_cast<std::uint64_t>(kind)) + body;
}

void write_judge_stream() {
    CaseResult passed;
    passed.info.name = "second";
    passed.verdict = Verdict::accepted;
    const std::string plan =
        frame('p', encode(sample<std::vector<CaseInfo>>()));
    const std::string first = frame('c', encode(sample<CaseResult>()));
    const std::string second = frame('c', encode(passed));
    const std::string end = frame('e', "");
    write("judge_stream/whole", plan + first + second + end);
    write("judge_stream/cut", plan + second);
    write("judge_stream/twice", plan + first + second + second + end);
    write("judge_stream/empty",
          frame('p', encode(std::vector<CaseInfo>())) + end);
}

std::string reply(CallStatus status, const std::string& body) {
    const FrameHead head{reply_magic, status, body.size(), 0};
    std::string bytes(sizeof head, '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes + body;
}

/// The begin of an input; the status is as of a process ended by signal 11.
std::string script(std::size_t type, std::size_t behaviour) {
    return byte(type) + byte(behaviour) + encode(std::int32_t{11});
}

std::string trace() {
    return encode(std::int64_t{2}) +
           encode(std::vector<std::int32_t>{1, 9, 4, 9});
}

/// Two right answers of each type.
void write_answers() {
    for (std::size_t k = 0; k < std::tuple_size_v<fuzz::ResultTypes>; ++k)
        fuzz::with_type(std::type_identity<fuzz::ResultTypes>(), k,
                        [&]<class T>(std::type_identity<T>) {
                            std::string bytes = script(k, 0);
                            for (int call = 0; call < 2; ++call)
                                bytes += reply(CallStatus::returned,
                                               trace() + encode(sample<T>()));
                            write("reply/type_" + std::to_string(k), bytes);
                        });
}

std::string text(const char* words) {
    return encode(std::string(words));
}

/// The body of each status, in their order.
std::vector<std::string> bodies() {
    Crash crash{};
    crash.signal = 11;
    crash.visit_count = 1;
    return {trace() + encode(3),
            trace() + text("std::out_of_range") + text("at: 5"),
            trace() + text("he[-1]"),
            trace() + text("too many"),
            trace(),
            text("not loaded"),
            {reinterpret_cast<const char*>(&crash), sizeof crash}};
}

void write_statuses() {
    const std::vector<std::string> all = bodies();
    for (std::size_t k = 0; k < all.size(); ++k)
        for (const std::size_t behaviour : {0u, 253u, 254u, 255u})
            write(fmt::format("reply/status_{}_{}", k, behaviour),
                  script(0, behaviour) +
                      reply(static_cast<CallStatus>(k), all[k]));
}

using SetFormat = int (*)(archive*);

void add_entry(archive* to, const char* path, unsigned type,
               std::string_view bytes) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, path);
    archive_entry_set_filetype(entry, type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
    if (type == AE_IFLNK) archive_entry_set_symlink(entry, "/etc/passwd");
    archive_write_header(to, entry);
    archive_write_data(to, bytes.data(), bytes.size());
    archive_entry_free(entry);
}

std::string archive_of(SetFormat format, SetFormat filter) {
    std::string bytes(1 << 16, '\0');
    std::size_t used = 0;
    archive* to = archive_write_new();
    format(to);
    filter(to);
    archive_write_set_bytes_in_last_block(to, 1);
    if (archive_write_open_memory(to, bytes.data(), bytes.size(), &used) !=
        ARCHIVE_OK)
        throw SystemError(archive_error_string(to));
    add_entry(to, "week1", AE_IFDIR, "");
    add_entry(to, "week1/prev.cpp", AE_IFREG, "int prev;\n");
    add_entry(to, "week1/notes.txt", AE_IFREG, std::string(3000, 'x'));
    add_entry(to, "link.cpp", AE_IFLNK, "");
    add_entry(to, "../tip.cpp", AE_IFREG, "int tip;\n");
    archive_write_close(to);
    archive_write_free(to);
    return bytes.substr(0, used);
}

void write_archives() {
    const auto stored = [](archive* to) {
        archive_write_set_format_zip(to);
        return archive_write_zip_set_compression_store(to);
    };
    const SetFormat none = archive_write_add_filter_none;
    const SetFormat pax = archive_write_set_format_pax;
    const auto zip = [](SetFormat format) {
        return byte(0) + archive_of(format, archive_write_add_filter_none);
    };
    const auto tar = [](SetFormat format, SetFormat filter) {
        return byte(1) + archive_of(format, filter);
    };
    write("archive/zip", zip(archive_write_set_format_zip));
    write("archive/stored_zip", zip(stored));
    write("archive/ustar", tar(archive_write_set_format_ustar, none));
    write("archive/gnutar", tar(archive_write_set_format_gnutar, none));
    write("archive/pax", tar(pax, none));
    write("archive/gzip", tar(pax, archive_write_add_filter_gzip));
    write("archive/bzip2", tar(pax, archive_write_add_filter_bzip2));
    write("archive/xz", tar(pax, archive_write_add_filter_xz));
    write("archive/zstd", tar(pax, archive_write_add_filter_zstd));
    write("archive/cpio", tar(archive_write_set_format_cpio, none));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::cerr << "usage: fuzz_seeds DIR\n";
        return 2;
    }
    folder = argv[1];
    write_codec();
    write_judge_stream();
    write_answers();
    write_statuses();
    write_archives();
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
}

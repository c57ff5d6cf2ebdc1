// Bytes that are kept on disk and not in memory.
#include "grader/pipeline/spool.h"

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <vector>

#include "course/runner/temporary_folder.h"
#include "grader/tests/golden.h"

using namespace grader;
using namespace grader::tests;

namespace {

/// The folder for temporary files is another one for a while.
class TemporaryFilesIn {
public:
    explicit TemporaryFilesIn(const std::filesystem::path& folder) {
        ::setenv("TMPDIR", folder.c_str(), 1);
    }
    TemporaryFilesIn(const TemporaryFilesIn&) = delete;
    TemporaryFilesIn& operator=(const TemporaryFilesIn&) = delete;
    ~TemporaryFilesIn() {
        if (before_.empty())
            ::unsetenv("TMPDIR");
        else
            ::setenv("TMPDIR", before_.c_str(), 1);
    }

private:
    std::string before_ =
        std::getenv("TMPDIR") == nullptr ? "" : std::getenv("TMPDIR");
};

/// No file may grow beyond so many bytes, as if the disk were full.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

/// What the error says.
template <typename Work>
std::string error_of(const Work& work) {
    try {
        work();
    } catch (const course::SystemError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("what is kept is read again, byte for byte and in any order") {
    const std::vector<std::string> all = {"int x;",
                                          "",
                                          std::string("\0\xff\r\n", 4),
                                          std::string(5u << 20, 'x'),
                                          "",
                                          "last"};
    Spool spool;
    std::vector<Stored> stored;
    for (const std::string& bytes : all) stored.push_back(spool.keep(bytes));
    for (std::size_t k = all.size(); k-- > 0;) {
        CHECK(stored[k].size == all[k].size());
        CHECK((spool.read(stored[k]) == all[k]));
    }
}

TEST_CASE("a spool has no name, so that none can stay behind") {
    const course::TemporaryFolder folder;
    const TemporaryFilesIn here(folder.path());
    Spool spool;
    const Stored stored = spool.keep("int x;");
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK(spool.read(stored) == "int x;");
}

TEST_CASE("several threads read at once") {
    Spool spool;
    std::vector<Stored> stored;
    for (int k = 0; k < 1000; ++k)
        stored.push_back(spool.keep(std::to_string(k)));
    std::vector<int> wrong(4);
    std::vector<std::thread> threads;
    for (int& count : wrong)
        threads.emplace_back([&] {
            for (std::size_t k = 0; k < stored.size(); ++k)
                count += spool.read(stored[k]) == std::to_string(k) ? 0 : 1;
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("a full disk is an error that says so, and the rest stays") {
    Spool spool;
    const Stored before = spool.keep("before");
    {
        const SmallDisk small(1000);
        CHECK(error_of([&] { spool.keep(std::string(2000, 'x')); }) ==
              "cannot write submitted files to the folder for temporary "
              "files: File too large");
    }
    const Stored after = spool.keep("after");
    CHECK(spool.read(before) == "before");
    CHECK(spool.read(after) == "after");
}

TEST_CASE("bytes that are gone are an error") {
    const Stored elsewhere{1000, 1};
    CHECK(error_of([&] { Spool().read(elsewhere); }) ==
          "cannot read submitted files again: there are fewer bytes");
}

TEST_CASE("without a folder for temporary files there is no spool") {
    const course::TemporaryFolder folder;
    const TemporaryFilesIn nowhere(folder / "none");
    CHECK_THAT(error_of([] { Spool(); }),
               Containing("cannot use the folder for temporary files (TMPDIR, "
                          "or /tmp): "));
}

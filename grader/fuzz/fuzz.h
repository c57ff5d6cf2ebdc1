// What the fuzzers have in common.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "course/runner/descriptors.h"

/// libFuzzer calls it with each input. What it throws is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Reports the input as a finding when a promise of the code is not kept.
inline void require(bool kept, const char* promise) {
    if (kept) return;
    std::fprintf(stderr, "not kept: %s\n", promise);
    std::abort();
}

/// A file without a place on the disk, for readers that want a path.
class InputFile {
public:
    InputFile() : file_(course::anonymous_file()) {}

    /// Its path, now that it holds `bytes`.
    std::filesystem::path with(std::string_view bytes) const {
        require(::ftruncate(file_.get(), 0) == 0 &&
                    ::pwrite(file_.get(), bytes.data(), bytes.size(), 0) ==
                        static_cast<ssize_t>(bytes.size()),
                "the input can be written");
        return "/proc/self/fd/" + std::to_string(file_.get());
    }

    /// Its descriptor, at the beginning of the file.
    int rewound() const {
        ::lseek(file_.get(), 0, SEEK_SET);
        return file_.get();
    }

private:
    course::Descriptor file_;
};

}  // namespace fuzz

// Tells when a file was saved.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "course/runner/descriptors.h"

namespace course {

/// Watches one file, also one that an editor replaces by another of its name.
/// On Linux the kernel tells (inotify). Elsewhere, where it refuses, and on
/// folders where it is not told of changes, as those of Windows under WSL, the
/// file is looked at now and then: a few microseconds each time.
class FileWatch {
public:
    explicit FileWatch(std::filesystem::path file);

    /// To be polled for input before has_changed is asked; -1: none.
    int descriptor() const { return notices_.get(); }

    /// After so long it is to be asked anyhow.
    std::chrono::milliseconds patience() const;

    /// Whether the file is another one than when last asked, or than in the
    /// beginning. False while there is none.
    bool has_changed();

private:
    struct Stamp {
        std::int64_t time = 0;
        std::uint64_t size = 0, node = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    Stamp stamp() const;

    std::filesystem::path file_;
    Descriptor notices_;
    Stamp last_;
};

}  // namespace course

// How a submission is compiled: one object from its file, linked with the
// exercise's entry into a shared object that a worker loads. No Catch2 in it.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/exercises.h"

namespace course {

/// How long a compiler may take, and how much of its messages is kept.
inline constexpr std::chrono::milliseconds compiler_patience{40'000};
inline constexpr std::size_t most_compiler_output = 65'536;

/// The compiler of this build.
std::string compiler();

/// Folder with the headers that a submission may include, and with the
/// precompiled preludes.
std::filesystem::path student_include();

/// What the worker calls, compiled already.
std::filesystem::path entry_object(const Exercise& exercise);

/// The same for the recorder of walks, in the traced build.
std::filesystem::path walk_entry_object(const Exercise& exercise);

/// The files that belong to a submission because it calls functions of earlier
/// exercises: those that the student wrote. None where the tree has solutions:
/// the references are in the entry.
std::vector<std::filesystem::path> own_sources_before(const Exercise& exercise);

/// What is compiled already when a submission begins: prelude.h,
/// prelude_text.h, prelude_streams.h or prelude_full.h.
enum class Prelude { lean, text, streams, full };

/// The first prelude that has all headers which this text and the contracts
/// that it includes need. Names may still be used that only `full` declares:
/// when compiling with another one fails (exit code 1), `full` has the last
/// word.
Prelude prelude_for(std::string_view source);

/// Arguments of the compile step: `source` to `object`, headers from
/// `include`. The lab and the sandbox differ in the paths only.
std::vector<std::string> compile_arguments(const std::string& source,
                                           const std::string& object,
                                           const std::string& include,
                                           Prelude prelude);

/// Whether a traced file's uses of the table are recorded, or only what changes
/// by them.
enum class Tracing { shown, silent };

/// Arguments of the compile step for the recorder of walks: traced build, with
/// what a debugger needs. `with` is another compiler; empty: that of this
/// build.
std::vector<std::string> traced_compile_arguments(const std::string& source,
                                                  const std::string& object,
                                                  Tracing tracing,
                                                  const std::string& with = "");

/// Arguments of the link step: a submission's object, its exercise's entry,
/// and what else belongs to it, to one shared object.
std::vector<std::string> link_arguments(std::vector<std::string> objects,
                                        const std::string& shared);

/// The compiler's messages without the names that students never wrote.
std::string for_students(std::string messages);

/// What the student should read when the worker could not load a submission:
/// from the loader's message about a missing symbol.
std::string load_error_text(const Exercise& exercise,
                            const std::string& loader_message);

}  // namespace course

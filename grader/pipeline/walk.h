// Walks through what a student handed in, folder by folder and archive by
// archive, and shows all of it to a collector.
#pragma once

#include <string>
#include <string_view>

#include "grader/pipeline/archive.h"
#include "grader/pipeline/collector.h"

namespace grader {

/// Walks through the folder `root` of a student, least deep folders first.
void walk_folder(int root, const IngestLimits& limits, Collector& to);

/// Looks at the file `name` in `folder`; its path in the submission is `path`,
/// which has the name that the student gave it.
void look_at_file(int folder, const std::string& name, const std::string& path,
                  const IngestLimits& limits, Collector& to);

/// Opens the student's archive `path` and takes all of it or nothing.
void open_archive(int file, ArchiveFormat format, const std::string& path,
                  const IngestLimits& limits, Collector& to);

/// The same for an archive that was found in the archive of the class.
void open_archive(const std::string& bytes, ArchiveFormat format,
                  const std::string& path, const IngestLimits& limits,
                  Collector& to);

/// The format that a student's file of that name is opened with; none for one
/// that an exercise asks for, and for "._homework.zip" and the like.
std::optional<ArchiveFormat> opened_as(std::string_view file_name,
                                       const Collector& to);

/// The note on an entry that was refused; its path continues `folder`.
std::string refusal_of(const ArchiveEntry& entry, const std::string& folder);

}  // namespace grader

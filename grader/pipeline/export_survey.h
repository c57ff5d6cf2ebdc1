// A first look at what an instructor downloaded: what lies on its top, and what
// the platform says beside it. Its bytes are hostile.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/pipeline/archive.h"
#include "grader/pipeline/export_layout.h"
#include "grader/pipeline/ingest.h"

namespace grader {

struct ExportSurvey {
    Platform platform = Platform::plain;
    /// The one folder that everything lies in ("assignment_1_export"); "" where
    /// there is none. Of plain folders always "".
    std::string root;
    std::vector<ExportEntry> entries;     ///< in the root
    std::optional<std::string> metadata;  ///< Gradescope's
    /// The last line of .git/logs/HEAD by entry.
    std::map<std::string, std::string> git_logs;
};

/// Looks at an unpacked export. `wanted`: the platform that it is, where the
/// instructor says so. Throws IngestError when nothing there is named as that
/// one names it.
ExportSurvey survey_folder(int dir, std::optional<Platform> wanted);

/// The same of an archive, which is read once for it. Throws ArchiveError, too.
ExportSurvey survey_archive(int file, ArchiveFormat format,
                            const IngestLimits& limits, unsigned cpu_seconds,
                            std::optional<Platform> wanted);

}  // namespace grader

#include "grader/pipeline/archive_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "course/mesh/ascii.h"
#include "grader/pipeline/archive.h"

namespace grader {

namespace {

constexpr std::size_t longest_component = 255;

constexpr std::array<std::pair<std::string_view, ArchiveFormat>, 7> endings = {{
    {".zip", ArchiveFormat::zip},
    {".tar", ArchiveFormat::tar},
    {".tgz", ArchiveFormat::tar},
    {".tar.gz", ArchiveFormat::tar},
    {".tar.bz2", ArchiveFormat::tar},
    {".tar.xz", ArchiveFormat::tar},
    {".tar.zst", ArchiveFormat::tar},
}};

/// A name must stand before the ending: ".zip" alone names no archive.
bool ends_in(std::string_view name, std::string_view ending) {
    return name.size() > ending.size() &&
           std::equal(
               ending.rbegin(), ending.rend(), name.rbegin(),
               [](char a, char b) { return a == course::ascii_lower(b); });
}

bool has_drive(std::string_view path) {
    const char letter = path.empty() ? '\0' : course::ascii_lower(path[0]);
    return path.size() > 1 && path[1] == ':' && letter >= 'a' && letter <= 'z';
}

std::string why_component_refused(std::string_view component) {
    if (component.empty()) return "has an empty folder name in its path";
    if (component == "..") return "leads out of its folder by \"..\"";
    if (component == ".") return "has \".\" in its path";
    if (component.size() > longest_component)
        return fmt::format("has a name of {} bytes, more than {}",
                           component.size(), longest_component);
    return {};
}

}  // namespace

std::optional<ArchiveFormat> archive_format(std::string_view file_name) {
    for (const auto& [ending, format] : endings)
        if (ends_in(file_name, ending)) return format;
    return std::nullopt;
}

std::string_view archive_stem(std::string_view file_name) {
    for (const auto& [ending, format] : endings)
        if (ends_in(file_name, ending))
            return file_name.substr(0, file_name.size() - ending.size());
    return file_name;
}

std::string_view folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == path.npos ? std::string_view() : path.substr(0, slash);
}

std::string_view name_in(std::string_view path) {
    return path.substr(path.rfind('/') + 1);  // npos + 1 is 0
}

std::string plain_path(std::string_view name) {
    if (name == "." || name == "./") return {};
    if (name.starts_with("./")) name.remove_prefix(2);
    if (name.size() > 1 && name.ends_with('/')) name.remove_suffix(1);
    return std::string(name);
}

std::string why_refused(std::string_view path) {
    if (path.size() > longest_path)
        return fmt::format("has a path of {} bytes, more than {}", path.size(),
                           longest_path);
    if (path.find('\0') != path.npos) return "has a NUL in its name";
    if (path.find('\\') != path.npos) return "has a backslash in its name";
    if (path.starts_with('/')) return "has an absolute path";
    if (has_drive(path)) return "begins with a drive letter";
    while (!path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        std::string why = why_component_refused(path.substr(0, slash));
        if (!why.empty()) return why;
        if (slash + 1 == path.size()) return why_component_refused("");
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return {};
}

}  // namespace grader

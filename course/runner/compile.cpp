#include "course/runner/compile.h"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>
#include <sstream>
#include <utility>

#include "course/runner/platform.h"

namespace course {

namespace {

namespace fs = std::filesystem;

constexpr const char* preludes[] = {
    "course/runner/prelude.h", "course/runner/prelude_text.h",
    "course/runner/prelude_streams.h", "course/runner/prelude_full.h"};

using Headers = std::set<std::string, std::less<>>;

/// "int face_sides(HalfEdgeTable const&, int)" from its symbol.
std::string plain_name(const std::string& symbol) {
    int status = 0;
    char* plain =
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status);
    std::string text = plain != nullptr ? plain : symbol;
    std::free(plain);
    return for_students(std::move(text));
}

/// What every compile step begins with.
std::vector<std::string> compiler_and_flags(const std::string& program) {
    std::vector<std::string> arguments = {program};
    std::istringstream flags(COURSE_STUDENT_FLAGS);
    for (std::string flag; flags >> flag;) arguments.push_back(flag);
    return arguments;
}

}  // namespace

std::string compiler() {
    return COURSE_COMPILER;
}

std::filesystem::path student_include() {
    return build_root() / "student" / "include";
}

std::filesystem::path entry_object(const Exercise& exercise) {
    return build_root() / "student" / "entries" / (exercise.name + ".o");
}

fs::path walk_entry_object(const Exercise& exercise) {
    return build_root() / "student" / "walks" / (exercise.name + ".o");
}

std::vector<fs::path> own_sources_before(const Exercise& exercise) {
    std::vector<fs::path> sources;
    if (has_solutions()) return sources;
    for (const Exercise& before : exercises_before(exercise))
        sources.push_back(before.skeleton());
    return sources;
}

Prelude prelude_for(std::string_view source) {
    const fs::path include = student_include();
    const auto headers_in = [&](Prelude prelude) {
        return standard_headers(
            read_file(include / preludes[static_cast<int>(prelude)]), include);
    };
    static const std::pair<Prelude, Headers> small[] = {
        {Prelude::lean, headers_in(Prelude::lean)},
        {Prelude::text, headers_in(Prelude::text)},
        {Prelude::streams, headers_in(Prelude::streams)}};
    const Headers used = standard_headers(source, include);
    for (const auto& [prelude, all] : small)
        if (std::includes(all.begin(), all.end(), used.begin(), used.end()))
            return prelude;
    return Prelude::full;
}

std::vector<std::string> compile_arguments(const std::string& source,
                                           const std::string& object,
                                           const std::string& include,
                                           Prelude prelude) {
    const std::string header = preludes[static_cast<int>(prelude)];
    std::vector<std::string> arguments = compiler_and_flags(compiler());
    for (const std::string& argument :
         {std::string("-I") + include, std::string("-include"),
          fmt::format("{}/{}", include, header), std::string("-c"), source,
          std::string("-o"), object})
        arguments.push_back(argument);
    return arguments;
}

std::vector<std::string> traced_compile_arguments(const std::string& source,
                                                  const std::string& object,
                                                  Tracing tracing,
                                                  const std::string& with) {
    std::vector<std::string> arguments =
        compiler_and_flags(with.empty() ? compiler() : with);
    const fs::path traced = build_root() / "student" / "traced";
    const std::string prelude = with.empty() ? "prelude.h" : "plain_prelude.h";
    for (const std::string& argument :
         {std::string("-g"), std::string("-gno-column-info"),
          std::string("-DCOURSE_TABLE=2"), "-I" + student_include().string(),
          std::string("-include"), (traced / prelude).string(),
          std::string("-c"), source, std::string("-o"), object})
        arguments.push_back(argument);
    if (tracing == Tracing::silent)
        arguments.push_back("-DCOURSE_TABLE_SILENT");
    return arguments;
}

std::vector<std::string> link_arguments(std::vector<std::string> objects,
                                        const std::string& shared) {
#if COURSE_LINUX
    // Bare: everything else is in the host that loads it.
    objects.insert(objects.begin(),
                   {"ld", "-shared", "--eh-frame-hdr", "-o", shared});
#else
    objects.insert(objects.begin(), {compiler(), "-shared",
#ifdef __APPLE__
                                     "-undefined", "dynamic_lookup",
#endif
                                     "-o", shared});
#endif
    return objects;
}

std::string for_students(std::string messages) {
    for (const std::string inner : {"checked_table::", "traced_table::"})
        for (auto at = messages.find(inner); at != std::string::npos;
             at = messages.find(inner, at))
            messages.erase(at, inner.size());
    return messages;
}

std::string load_error_text(const Exercise& exercise,
                            const std::string& loader_message) {
    const std::string key = "undefined symbol: ";
    const auto at = loader_message.find(key);
    if (at == std::string::npos) return loader_message;
    std::string symbol = loader_message.substr(at + key.size());
    symbol = symbol.substr(0, symbol.find_first_of(" ,\n"));
    return fmt::format(
        "the file does not define {}\nIs the function there, with exactly the "
        "parameters that {}.h declares?",
        plain_name(symbol), exercise.name);
}

}  // namespace course

# The packages that everybody needs: the system's where it has them, else the
# pinned release, checked by its hash.
include(FetchContent)

function(course_package name version target url hash)
    find_package(${name} QUIET)
    if(TARGET ${target})
        return()
    endif()
    message(STATUS "${name} is not installed: fetching ${version}")
    FetchContent_Declare(${name} URL ${url} URL_HASH SHA256=${hash}
                         DOWNLOAD_EXTRACT_TIMESTAMP ON SYSTEM)
    FetchContent_MakeAvailable(${name})
endfunction()

find_package(Threads REQUIRED)

course_package(
    Catch2 2.13.10 Catch2::Catch2
    https://github.com/catchorg/Catch2/archive/refs/tags/v2.13.10.tar.gz
    d54a712b7b1d7708bc7a819a8e6e47b2fde9536f487b89ccbca295072a7d9943)
course_package(
    fmt 9.1.0 fmt::fmt
    https://github.com/fmtlib/fmt/archive/refs/tags/9.1.0.tar.gz
    5dea48d1fcddc3ec571ce2058e13910a0d4a6bab4cc09a809d8b1dd1c88ae6f2)
course_package(
    CLI11 2.1.2 CLI11::CLI11
    https://github.com/CLIUtils/CLI11/archive/refs/tags/v2.1.2.tar.gz
    26291377e892ba0e5b4972cdfd4a2ab3bf53af8dac1f4ea8fe0d1376b625c8cb)
course_package(
    tinyobjloader 2.0.0rc13 tinyobjloader::tinyobjloader
    https://github.com/tinyobjloader/tinyobjloader/archive/refs/tags/v2.0.0rc13.tar.gz
    0feb92b838f8ce4aa6eb0ccc32dff30cb64a891e0ec3bde837fca49c78d44334)
if(NOT TARGET tinyobjloader::tinyobjloader)
    add_library(tinyobjloader::tinyobjloader ALIAS tinyobjloader)
endif()

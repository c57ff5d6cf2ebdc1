# Sourced by the three scripts: what a machine needs, and building once.
# Sets nothing but functions and `root`. POSIX shell.

student_debian="g++ make cmake ninja-build pkg-config catch2 libfmt-dev \
libtinyobjloader-dev libcli11-dev"
student_fedora="gcc-c++ cmake ninja-build pkgconf catch2-devel fmt-devel \
tinyobjloader-devel cli11-devel"
student_arch="gcc cmake ninja pkgconf catch2 fmt tinyobjloader cli11"
student_brew="cmake ninja pkg-config catch2 fmt tinyobjloader cli11"

grader_debian="libsqlitecpp-dev libsqlite3-dev nlohmann-json3-dev \
libtomlplusplus-dev libssl-dev libseccomp-dev libarchive-dev \
libhowardhinnant-date-dev libyaml-cpp-dev tzdata bubblewrap"
grader_fedora="sqlitecpp-devel sqlite-devel json-devel tomlplusplus-devel \
openssl-devel libseccomp-devel libarchive-devel date-devel yaml-cpp-devel \
tzdata bubblewrap"
grader_arch="sqlitecpp sqlite nlohmann-json tomlplusplus openssl libseccomp \
libarchive chrono-date yaml-cpp tzdata bubblewrap"

# Packages of the list that dpkg does not know as installed.
missing_debian() {
    for package in "$@"; do
        status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
        [ "$status" = "install ok installed" ] || printf '%s ' "$package"
    done
}

# Installs with apt; asks first when a person sits at the terminal.
install_debian() {
    missing=$(missing_debian "$@")
    [ -n "$missing" ] || return 0
    as_root=
    [ "$(id -u)" = 0 ] || as_root=sudo
    if [ -n "$as_root" ] && ! command -v sudo >/dev/null 2>&1; then
        echo "Missing packages. As root: apt-get install $missing" >&2
        exit 2
    fi
    echo "Missing packages: $missing" >&2
    if [ -t 0 ] && [ -t 2 ]; then
        printf 'Install them now with apt-get? [Y/n] ' >&2
        read -r answer
        case $answer in
            [Nn]*) exit 2 ;;
        esac
    fi
    log=$(mktemp)
    if ! { $as_root apt-get update &&
        $as_root env DEBIAN_FRONTEND=noninteractive \
            apt-get install -y --no-install-recommends $missing; } \
        >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        echo "apt-get failed; the whole log is in $log" >&2
        exit 2
    fi
    rm -f "$log"
}

# On other systems the package list is printed; what is already there is taken
# as the build finds it. $1: debian, $2: fedora, $3: arch, $4: brew
need_packages() {
    if command -v dpkg-query >/dev/null 2>&1; then
        install_debian $1
        return
    fi
    command -v cmake >/dev/null 2>&1 && command -v c++ >/dev/null 2>&1 &&
        return
    echo "This needs a C++20 compiler, CMake 3.25 and some packages:" >&2
    echo "  $(package_list "$2" "$3" "$4" "$1")" >&2
    exit 2
}

# For `lab doctor`: says what of the machine is ready, and installs nothing.
# $1 to $4 as for need_packages. False when something is missing.
tell_machine() {
    ready=true
    for tool in c++ cmake; do
        if command -v "$tool" >/dev/null 2>&1; then
            printf 'ok      %s\n' "$("$tool" --version | head -n 1)"
        else
            printf 'MISSING %s\n' "$tool"
            ready=false
        fi
    done
    if command -v dpkg-query >/dev/null 2>&1; then
        missing=$(missing_debian $1)
        if [ -n "$missing" ]; then
            printf 'MISSING packages. As root: apt-get install %s\n' "$missing"
            ready=false
        else
            echo "ok      packages"
        fi
    elif ! $ready; then
        echo "        needed here: $(package_list "$2" "$3" "$4" "$1")"
    fi
    $ready
}

# The command that installs what is needed on this system.
# $1: fedora, $2: arch, $3: brew, $4: debian
package_list() {
    if [ "$(uname)" = Darwin ]; then
        echo "xcode-select --install; brew install $3"
    elif command -v dnf >/dev/null 2>&1; then
        echo "sudo dnf install $1"
    elif command -v pacman >/dev/null 2>&1; then
        echo "sudo pacman -S $2"
    else
        echo "(Debian names) $4"
    fi
}

# Configures once and builds what is out of date. Quiet unless it fails or
# takes long. $@: targets
build() {
    log=$root/.build/build.log
    mkdir -p "$root/.build"
    if [ ! -f "$root/.build/CMakeCache.txt" ]; then
        echo "Building for the first time; this takes a few minutes ..." >&2
        generator=
        command -v ninja >/dev/null 2>&1 && generator="-G Ninja"
        cmake -S "$root" -B "$root/.build" $generator >"$log" 2>&1 ||
            build_failed
    fi
    cmake --build "$root/.build" --parallel "$(jobs_of_machine)" \
        --target "$@" >"$log" 2>&1 || build_failed
}

build_failed() {
    grep -E 'error|Error|CMake' "$log" | head -n 20 >&2
    echo "The build failed; the whole log is in $log" >&2
    exit 3
}

jobs_of_machine() {
    getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2
}

#!/bin/sh
# Installs what swTracer needs and this host lacks, with the host's own package manager.
#
#   sh external/setup.sh              what building, rendering and testing need
#   sh external/setup.sh --developer  also what .ci/run and the optional targets need
#
# On Windows: in a shell of MSYS2 or WSL. Visual Studio 2022 brings its own compiler, CMake and Ninja
# (winget install Microsoft.VisualStudio.2022.Community, then "Desktop development with C++"): leave
# this script out, and CMake downloads the libraries by git (winget install Git.Git).
#
# Does nothing where everything is there. Libraries that cannot be installed are named, and CMake
# downloads them at configure time; a missing compiler, CMake or Ninja is an error.
set -u

developer=no
case "${1-}" in
    "") ;;
    --developer) developer=yes ;;
    *) echo "usage: sh external/setup.sh [--developer]" >&2; exit 2 ;;
esac

CXX=${CXX:-c++}
here=$(dirname "$0")

hasCommand() { command -v "$1" >/dev/null 2>&1; }
hasHeader() { echo "#include <$1>" | "$CXX" -x c++ -std=c++17 -E - >/dev/null 2>&1; }
hasLibcxx() {
    hasCommand clang++ &&
        echo 'int main() {}' | clang++ -stdlib=libc++ -x c++ - -lc++abi -o /dev/null 2>/dev/null
}
# What -fsanitize=fuzzer links.
hasFuzzer() {
    hasCommand clang++ &&
        echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, decltype(sizeof 0)) { return 0; }' |
        clang++ -fsanitize=fuzzer,address,undefined -x c++ - -o /dev/null 2>/dev/null
}
# What .ci/page drives a browser with; not that of another Python that comes first in the path.
hasSelenium() { /usr/bin/python3 -c 'import selenium' 2>/dev/null; }
# CMake's presets file needs 3.25.
hasCmake() {
    hasCommand cmake && cmake --version |
        awk 'NR == 1 { split($3, v, "."); exit !(v[1] > 3 || (v[1] == 3 && v[2] >= 25)) }'
}

# Every item: is it there?
isThere() {
    case $1 in
        compiler) hasCommand "$CXX" ;;
        cmake) hasCmake ;;
        ninja) hasCommand ninja ;;
        glm) hasHeader glm/glm.hpp ;;
        stb)
            [ -s "$here/stb/stb_image_write.h" ] || hasHeader stb/stb_image_write.h ||
                hasHeader stb_image_write.h ;;
        catch2) hasHeader catch2/catch.hpp || hasHeader catch2/catch_all.hpp ;;
        cli11) hasHeader CLI/CLI.hpp ;;
        fast_float) hasHeader fast_float/fast_float.h ;;
        json) hasHeader nlohmann/json.hpp ;;
        clang) hasCommand clang++ ;;
        libc++) hasLibcxx ;;
        fuzzer) hasFuzzer ;;
        clang-format) hasCommand clang-format ;;
        ccache) hasCommand ccache ;;
        browser) hasCommand chromedriver && hasSelenium ;;
        benchmark) hasHeader benchmark/benchmark.h ;;
        embree) hasHeader embree3/rtcore.h || hasHeader embree4/rtcore.h ;;
        gnuplot) hasCommand gnuplot ;;
        povray) hasCommand povray ;;
        valgrind) hasCommand valgrind ;;
        venv) python3 -c 'import venv, ensurepip' 2>/dev/null ;;
        shlibdeps) hasCommand dpkg-shlibdeps ;;
        # What .ci/cross builds with, and runs that in.
        mingw) hasCommand x86_64-w64-mingw32-g++-posix || hasCommand x86_64-w64-mingw32-g++ ;;
        wine) hasCommand wine || hasCommand wine64 ;;
        aarch64) hasCommand aarch64-linux-gnu-g++ || [ "$(uname -m)" = aarch64 ] ;;
        qemu) hasCommand qemu-aarch64 || [ "$(uname -m)" = aarch64 ] ;;
        i686) hasCommand i686-linux-gnu-g++ ;;
        # What README renders strips on several machines with.
        parallel) hasCommand parallel ;;
        imagemagick) hasCommand magick || hasCommand convert ;;
    esac
}

# Item and package manager -> package names; nothing where the manager has no such package.
packages() {
    if [ "$manager" = msys ]; then  # tools and libraries for Windows, named after the shell's kind
        case $1 in
            compiler) echo "$MINGW_PACKAGE_PREFIX-gcc" ;;
            catch2) echo "$MINGW_PACKAGE_PREFIX-catch" ;;
            json) echo "$MINGW_PACKAGE_PREFIX-nlohmann-json" ;;
            cmake | ninja | glm | stb | cli11 | fast_float | ccache)
                echo "$MINGW_PACKAGE_PREFIX-$1" ;;
        esac
        return
    fi
    case $1:$manager in
        compiler:apt) echo g++ ;;              compiler:dnf) echo gcc-c++ ;;
        compiler:pacman) echo gcc ;;           compiler:brew) ;;
        cmake:*) echo cmake ;;
        ninja:apt | ninja:dnf) echo ninja-build ;;
        ninja:*) echo ninja ;;
        glm:apt) echo libglm-dev ;;            glm:dnf) echo glm-devel ;;
        glm:*) echo glm ;;
        stb:apt) echo libstb-dev ;;            stb:dnf) echo stb-devel ;;
        stb:pacman) echo stb ;;                stb:brew) ;;
        catch2:apt) echo catch2 ;;             catch2:dnf) echo catch-devel ;;
        catch2:*) echo catch2 ;;
        cli11:apt) echo libcli11-dev ;;        cli11:dnf) echo cli11-devel ;;
        cli11:*) echo cli11 ;;
        fast_float:apt) echo libfast-float-dev ;;
        fast_float:dnf) echo fast_float-devel ;;
        fast_float:pacman) echo fast_float ;;  fast_float:brew) echo fast_float ;;
        json:apt) echo nlohmann-json3-dev ;;   json:dnf) echo json-devel ;;
        json:*) echo nlohmann-json ;;
        clang:brew) echo llvm ;;               clang:*) echo clang ;;
        libc++:apt) echo libc++-dev libc++abi-dev ;;
        libc++:dnf) echo libcxx-devel libcxxabi-devel ;;
        libc++:pacman) echo libc++ ;;
        fuzzer:apt) echo libclang-rt-dev ;;    fuzzer:dnf) echo compiler-rt ;;
        fuzzer:pacman) echo compiler-rt ;;     fuzzer:brew) ;;
        clang-format:dnf) echo clang-tools-extra ;;
        clang-format:pacman) echo clang ;;     clang-format:*) echo clang-format ;;
        ccache:*) echo ccache ;;
        browser:apt) echo chromium chromium-driver python3-selenium ;;
        browser:dnf) echo chromium chromedriver python3-selenium ;;
        browser:pacman) echo chromium python-selenium ;;
        benchmark:apt) echo libbenchmark-dev ;;
        benchmark:dnf) echo google-benchmark-devel ;;
        benchmark:pacman) echo benchmark ;;    benchmark:brew) echo google-benchmark ;;
        embree:apt) echo libembree-dev ;;      embree:dnf) echo embree-devel ;;
        embree:*) echo embree ;;
        gnuplot:apt) echo gnuplot-nox ;;       gnuplot:*) echo gnuplot ;;
        povray:*) echo povray ;;
        valgrind:brew) ;;                      valgrind:*) echo valgrind ;;
        venv:apt) echo python3-venv ;;         shlibdeps:apt) echo dpkg-dev ;;
        mingw:apt) echo g++-mingw-w64-x86-64-posix ;;
        mingw:dnf) echo mingw64-gcc-c++ mingw64-winpthreads-static ;;
        mingw:pacman) echo mingw-w64-gcc ;;    mingw:brew) echo mingw-w64 ;;
        wine:apt) echo wine wine64 ;;          wine:dnf) echo wine-core ;;
        wine:pacman) echo wine ;;
        aarch64:apt) echo g++-aarch64-linux-gnu ;;
        aarch64:pacman) echo aarch64-linux-gnu-gcc ;;
        qemu:apt | qemu:dnf | qemu:pacman) echo qemu-user ;;
        i686:apt) echo g++-i686-linux-gnu ;;
        parallel:*) echo parallel ;;
        imagemagick:dnf) echo ImageMagick ;;   imagemagick:*) echo imagemagick ;;
    esac
}

install() {
    sudo=
    if [ "$manager" != brew ] && [ "$(id -u)" != 0 ]; then
        hasCommand sudo && sudo=sudo
    fi
    echo "setup: installing $* with $manager"
    case $manager in
        apt)
            $sudo apt-get update -q
            $sudo env DEBIAN_FRONTEND=noninteractive \
                apt-get install -q -y --no-install-recommends "$@" ;;
        dnf) $sudo dnf install -y "$@" ;;
        pacman | msys) $sudo pacman -S --needed --noconfirm "$@" ;;
        brew) brew install "$@" ;;
    esac
}

manager=none
if [ -n "${MINGW_PACKAGE_PREFIX-}" ] && hasCommand pacman; then manager=msys; fi
for candidate in apt:apt-get dnf:dnf pacman:pacman brew:brew; do
    if [ "$manager" = none ] && hasCommand "${candidate#*:}"; then manager=${candidate%%:*}; fi
done
# Homebrew's headers, which CMake finds, lie where the compiler does not look.
if [ "$manager" = brew ]; then
    CPATH=$(brew --prefix)/include${CPATH:+:$CPATH}
    export CPATH
fi

tools="compiler cmake ninja"
libraries="glm stb catch2 cli11 fast_float json"
extras=
[ $developer = no ] || extras="browser clang libc++ fuzzer clang-format ccache benchmark embree gnuplot
    povray valgrind venv shlibdeps mingw wine aarch64 qemu i686 parallel imagemagick"

wanted=
for item in $tools $libraries $extras; do
    isThere "$item" || wanted="$wanted $(packages "$item")"
done
# shellcheck disable=SC2086  # the list is split on purpose
set -- $wanted
if [ $# -gt 0 ]; then
    # One package that the host does not know must not keep the others out.
    install "$@" || for package in "$@"; do install "$package"; done
fi

status=0
for item in $tools; do
    isThere "$item" && continue
    echo "setup: $item is missing; please install it (CMake must be 3.25 or newer)" >&2
    status=1
done
for item in $libraries; do
    isThere "$item" || echo "setup: $item is not installed; CMake will download it" >&2
done
for item in $extras; do
    isThere "$item" || echo "setup: $item is not installed; its targets are left out" >&2
done
exit $status

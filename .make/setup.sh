#!/bin/sh
# setup.sh [--check|--all] SET... - make sure that this machine has everything that the sets need.
#
# Sets: run (build and render), test, lint, fuzz, book, web (the programs in a browser), browsers (to test them), windows
# (the cross build), wine (to test the cross build), student (the course for students), film, fresh (bare machines to test
# on).
#
# If nothing is missing, this script only looks for files and commands, and uses neither the network nor the package
# manager. As root, it installs whatever is missing. With a terminal, or where sudo needs no password, it says what it
# installs, and installs it with sudo, or with Homebrew or MSYS2, which need no special rights. Otherwise it prints one
# command and fails.
#   --check  install nothing
#   --all    also install packages that are useful but not required
# ShellCheck does not see that the functions has_... are called, because they are passed to need by name.
# shellcheck disable=SC2317
set -u
export LC_ALL=C

mode=install all=
case ${1-} in
--check) mode=check; shift ;;
--all) all=1; shift ;;
esac

# ---- What is missing ----

# The column of the package tables below that names this machine's packages.
manager=none column=1
for candidate in apt-get dnf pacman brew; do
    if command -v "$candidate" >/dev/null 2>&1; then
        manager=$candidate
        break
    fi
    column=$((column + 1))
done

# Without Apple's command line tools, the commands cc, make and git only open a dialogue.
if [ "$(uname)" = Darwin ]; then
    if ! xcode-select -p >/dev/null 2>&1; then
        printf "setup: Apple's command line tools are missing: xcode-select --install\n" >&2
        exit 1
    fi
    if ! command -v brew >/dev/null; then
        printf 'setup: Homebrew, which installs the libraries, is missing: see https://brew.sh\n' >&2
        exit 1
    fi
    # Homebrew has no package for stb, which is only a folder of headers.
    includes=$(brew --prefix)/include
    if [ ! -e "$includes/stb/stb_truetype.h" ]; then
        printf 'setup: stb_truetype (the text of the overlay) is missing: git clone --depth 1 %s %s\n' \
            https://github.com/nothings/stb "$includes/stb" >&2
        exit 1
    fi
fi

# Windows has MSYS2's pacman, whose packages differ from Arch's; each MSYS2 shell builds a different kind of program.
if [ "${OS-}" = Windows_NT ]; then
    column=5
    if [ "$manager" != pacman ] || [ "${MSYSTEM-}" != UCRT64 ]; then
        printf "setup: on Windows, build the course in the shell 'MSYS2 UCRT64' (https://www.msys2.org); this is %s: %s\n" \
            "${MSYSTEM:-another shell}" 'see docs/platforms.md' >&2
        exit 1
    fi
fi

packages='' purposes='' extra=''

# names_here APT|DNF|PACMAN|BREW|MSYS2: print the packages in this machine's column; '-', or no such column, means
# that there are none. The packages of MSYS2 contain programs and libraries for Windows, except those marked with '=',
# which belong to its shell.
names_here() {
    [ "$manager" = none ] && return
    for name in $(printf '%s' "$1" | cut -d '|' -f "$column"); do
        case $column$name in
        ?-) ;;
        5=*) printf ' %s' "${name#=}" ;;
        5*) printf ' mingw-w64-ucrt-x86_64-%s' "$name" ;;
        *) printf ' %s' "$name" ;;
        esac
    done
}

# need PURPOSE PACKAGES TEST...: if the test fails, record that the packages are missing, only once for each purpose.
need() {
    purpose=$1 names=$2
    shift 2
    case ", $purposes, " in
    *", $purpose, "*) return ;;
    esac
    "$@" >/dev/null 2>&1 && return
    # If the package manager has no such package, everything that needs the package is skipped later, with a message.
    found=$(names_here "$names")
    [ "$manager" != none ] && [ -z "$found" ] && return
    packages=$packages$found
    purposes="$purposes${purposes:+, }$purpose"
}

compiler=cc
[ "$column" != 5 ] || compiler=gcc
has_command() { command -v "$1"; }
has_library() { pkg-config --exists "$1"; }
has_header() { printf '#include <%s>\n' "$1" | "$compiler" -E - ; }
has_font() { fc-list ":family=$1" | grep -q . ; }
has_firefox() { command -v firefox-esr || command -v firefox; }
has_french() { [ -e /usr/share/i18n/locales/fr_FR ] || locale -a | grep -qi '^fr_FR[.]utf'; }
has_frames() { ls /usr/lib*/libdecor/plugins-1/* || ls /usr/lib/*/libdecor/plugins-1/*; }
has_sanitizers() {
    [ "$(uname)" = Darwin ] || [ -e "$("$compiler" -print-file-name=libasan.so)" ]
}
has_driver() {
    [ "$(uname)" != Darwin ] && [ "$column" != 5 ] || return 0
    for file in /usr/lib/*/dri/swrast_dri.so /usr/lib*/dri/swrast_dri.so \
        /usr/lib/*/libgallium-*.so /usr/lib*/libgallium-*.so; do
        [ -e "$file" ] && return
    done
    return 1
}

need_run() {
    need 'a C compiler' 'gcc libc6-dev|gcc glibc-devel|gcc|gcc|gcc' has_header stdio.h
    need 'pkg-config' 'pkg-config|pkgconf-pkg-config|pkgconf|pkg-config|pkgconf' has_command pkg-config
    need 'GLFW (opens windows)' 'libglfw3-dev|glfw-devel|glfw|glfw|glfw' has_library glfw3
    need 'EGL (renders without a window)' 'libegl-dev libegl1|libglvnd-devel mesa-libEGL|libglvnd mesa|-' \
        has_library egl
    need 'OpenGL headers' 'libgl-dev|libglvnd-devel|libglvnd|-' has_header GL/glcorearb.h
    need 'the Mesa software renderer' 'libgl1-mesa-dri|mesa-dri-drivers|mesa|-' has_driver
    need 'libpng' 'libpng-dev|libpng-devel|libpng|libpng|libpng' has_library libpng
    need 'cglm' 'libcglm-dev|cglm-devel|cglm|cglm|cglm' has_library cglm
    need 'cmp and diff' 'diffutils|diffutils|diffutils|-|=diffutils' has_command cmp
    need 'stb_truetype (the text of the overlay)' 'libstb-dev|stb_truetype-devel|stb|-|stb' \
        has_header stb/stb_truetype.h
    # Mesa 25.1 and later have no OSMesa; the programs do not require it.
    has_library osmesa >/dev/null 2>&1 ||
        extra=$(names_here 'libosmesa6-dev|mesa-libOSMesa-devel|-|-')
    # GNOME on Wayland leaves the title bar and the frame to the program; GLFW draws them with libdecor.
    [ -z "${WAYLAND_DISPLAY-}" ] || has_frames >/dev/null 2>&1 ||
        extra=$extra$(names_here 'libdecor-0-plugin-1-gtk|libdecor|libdecor|-')
}

need_test() {
    need_run
    need 'cmocka' 'libcmocka-dev|libcmocka-devel|cmocka|cmocka' has_library cmocka
    need 'git' 'git|git|git|git' has_command git
    need 'patch' 'patch|patch|patch|-' has_command patch
    need 'the sanitizers' '-|libasan libubsan|-|-' has_sanitizers
    need 'a French locale' 'locales|glibc-locale-source|glibc|-' has_french
    need 'a virtual display' 'xvfb|xorg-x11-server-Xvfb|xorg-server-xvfb|-' has_command Xvfb
    need 'real key and mouse events' 'xdotool|xdotool|xdotool|-' has_command xdotool
    need 'a window manager' 'openbox|openbox|openbox|-' has_command openbox
    need 'xprop' 'x11-utils|xprop|xorg-xprop|-' has_command xprop
    need 'wmctrl' 'wmctrl|wmctrl|wmctrl|-' has_command wmctrl
    need "the BSDs' awk" 'original-awk|-|-|-' has_command original-awk
    need 'busybox' 'busybox|busybox|busybox|-' has_command busybox
    need 'ImageMagick' 'imagemagick|ImageMagick|imagemagick|imagemagick' has_command import
}

need_lint() {
    need_run
    need 'cmocka' 'libcmocka-dev|libcmocka-devel|cmocka|cmocka' has_library cmocka
    need 'gcc' 'gcc|gcc|gcc|gcc' has_command gcc
    need 'clang' 'clang|clang|clang|llvm' has_command clang
    need 'clang-format' 'clang-format|clang-tools-extra|clang|clang-format' has_command clang-format
    need 'clang-tidy' 'clang-tidy|clang-tools-extra|clang|llvm' has_command clang-tidy
    need 'cppcheck' 'cppcheck|cppcheck|cppcheck|cppcheck' has_command cppcheck
    need 'ShellCheck' 'shellcheck|ShellCheck|shellcheck|shellcheck' has_command shellcheck
    need 'glslangValidator' 'glslang-tools|glslang|glslang|glslang' has_command glslangValidator
}

# The runtime of Debian's clang is a separate package, named after clang's version.
fuzzer_version() {
    { clang -dumpversion || apt-cache show clang | sed -n 's/^Version: [0-9]*:*\([0-9.]*\).*/\1/p'; } 2>/dev/null |
        sed -n '1s/\..*//p'
}
has_fuzzer() {
    echo 'int LLVMFuzzerTestOneInput(const char *bytes, unsigned long size) { return !bytes && size; }' |
        clang -x c -fsanitize=fuzzer,address -o /dev/null -
}

need_fuzz() {
    need_run
    version=$(fuzzer_version)
    need 'clang with libFuzzer' "clang libclang-rt-${version:-14}-dev|clang compiler-rt|clang compiler-rt|-" has_fuzzer
}

need_book() {
    need_run
    need 'pandoc' 'pandoc|pandoc|pandoc|pandoc' has_command pandoc
    need 'XeLaTeX' 'texlive-xetex texlive-latex-recommended|texlive-xetex texlive-collection-latexrecommended|-|-' \
        has_command xelatex
    need "the book's fonts" \
        'texlive-fonts-recommended lmodern fonts-texgyre fonts-dejavu-core fontconfig|texlive-tex-gyre texlive-lm dejavu-sans-mono-fonts dejavu-sans-fonts|-|-' \
        has_font 'TeX Gyre Pagella'
    need 'rsvg-convert (figures)' 'librsvg2-bin|librsvg2-tools|librsvg|librsvg' has_command rsvg-convert
    need 'pdfinfo (counts pages)' 'poppler-utils|poppler-utils|poppler|poppler' has_command pdfinfo
}

need_web() {
    need_run
    need 'Emscripten' 'emscripten|emscripten|emscripten|emscripten' has_command emcc
    need 'Node.js' 'nodejs|nodejs|nodejs|node' has_command node
    need 'npm' 'npm|nodejs-npm|npm|node' has_command npm
    need 'pandoc' 'pandoc|pandoc|pandoc|pandoc' has_command pandoc
    need 'the font of the pages' 'fonts-texgyre fontconfig|texlive-tex-gyre|-|-' has_font 'TeX Gyre Pagella'
    need 'the font of formulas' 'fonts-texgyre-math|texlive-tex-gyre-math|-|-' has_font 'TeX Gyre Pagella Math'
    need 'pyftsubset (makes fonts smaller)' 'fonttools python3-brotli|fonttools python3-brotli|python-fonttools python-brotli|fonttools' \
        has_command pyftsubset
    need 'cwebp (small pictures)' 'webp|libwebp-tools|libwebp|webp' has_command cwebp
    need 'zip' 'zip|zip|zip|zip' has_command zip
}

# The programs and the site are tested in browsers.
need_browsers() {
    need_web
    need 'Chromium' 'chromium|chromium|chromium|-' has_command chromium
    need 'Firefox' 'firefox-esr|firefox|firefox|-' has_firefox
    need 'a virtual display' 'xvfb xauth|xorg-x11-server-Xvfb|xorg-server-xvfb|-' has_command xvfb-run
}

# The cross build for Windows works only on Debian, because the libraries are built from its source packages.
need_windows() {
    need_run
    need 'a compiler for Windows' 'gcc-mingw-w64-x86-64-win32|-|-|-' has_command x86_64-w64-mingw32-gcc
    need "Debian's source packages" 'dpkg-dev|-|-|-' has_command dpkg-source
    need 'patch' 'patch|-|-|-' has_command patch
    need 'zip' 'zip|-|-|-' has_command zip
}

# The programs for Windows are tested with Wine.
need_wine() {
    need_windows
    need_test
    need 'Wine' 'wine64 wine|-|-|-' has_command wine
    need 'unzip' 'unzip|-|-|-' has_command unzip
}

# The course for students is packed from a git checkout.
need_student() {
    need_run
    need 'git' 'git|git|git|git' has_command git
    need 'patch' 'patch|patch|patch|-' has_command patch
    need 'pngquant (small pictures)' 'pngquant|pngquant|pngquant|pngquant' has_command pngquant
    need 'zip' 'zip|zip|zip|zip' has_command zip
}

need_film() {
    need_run
    need 'ffmpeg' 'ffmpeg|ffmpeg-free|ffmpeg|ffmpeg|ffmpeg' has_command ffmpeg
}

need_fresh() {
    need 'debootstrap' 'debootstrap|-|-|-' has_command debootstrap
    need 'git' 'git|git|git|git' has_command git
}

look() {
    packages='' purposes='' extra=''
    for set in "$@"; do
        case $set in
        run) need_run ;;
        test) need_test ;;
        lint) need_lint ;;
        fuzz) need_fuzz ;;
        book) need_book ;;
        film) need_film ;;
        fresh) need_fresh ;;
        student) need_student ;;
        web) need_web ;;
        browsers) need_browsers ;;
        windows) need_windows ;;
        wine) need_wine ;;
        *)
            printf 'setup.sh: %s: no such set: the sets are run, test, lint, fuzz, book, web, browsers, windows, wine, student, film and fresh\n' "$set" >&2
            exit 2
            ;;
        esac
    done
    # Two sets may need the same package.
    packages=$(echo "$packages" | tr ' ' '\n' | sort -u | tr '\n' ' ')
    packages=${packages# } packages=${packages% }
}

# ---- Installation ----

# Print those packages in extra that the package manager has.
available() {
    case $manager in
    apt-get) show='apt-cache show' ;;
    dnf) show='dnf -q info' ;;
    pacman) show='pacman -Si' ;;
    *) return ;;
    esac
    for name in $extra; do
        $show "$name" >/dev/null 2>&1 && printf ' %s' "$name"
    done
}

# Print the packages in extra for a command that first refreshes the lists of packages. Until then, apt does not know
# which packages exist, so each name is written as '?exact-name()', which may match nothing.
useful() {
    [ "$manager" = apt-get ] || { available; return; }
    for name in $extra; do printf " '?exact-name(%s)'" "$name"; done
}

refresh_command() {
    case $manager in
    apt-get) echo 'apt-get -q update' ;;
    pacman) echo 'pacman -Sy --noconfirm' ;;
    *) echo true ;;
    esac
}

install_command() {
    case $manager in
    apt-get) echo "env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=120 install --no-install-recommends" ;;
    dnf) echo 'dnf -y install' ;;
    pacman) echo 'pacman -S --needed --noconfirm' ;;
    brew) echo 'brew install' ;;
    esac
}

# Print the command that a person would type, or give to an administrator. Without sudo, it is a command for root.
one_command() {
    as=
    [ "$(id -u)" != 0 ] && command -v sudo >/dev/null && as='sudo '
    case $manager in
    apt-get) echo "${as}apt-get update && ${as}apt-get install -y --no-install-recommends $1" ;;
    dnf) echo "${as}dnf install $1" ;;
    pacman) echo "${as}pacman -Sy --needed $1" ;;
    brew) echo "brew install $1" ;;
    esac
}

# Run a command quietly; if it fails, show the end of its output and exit.
quietly() {
    sh -c "$1" >>build/setup.log 2>&1 && return
    tail -n 15 build/setup.log >&2
    printf 'setup: %s failed: see build/setup.log\n' "$manager" >&2
    exit 1
}

carry_out() { # AS: sudo or nothing
    mkdir -p build && : >build/setup.log || exit 1
    quietly "$1 $(refresh_command)"
    quietly "$1 $(install_command) $packages$(useful)"
}

look "$@"
if [ -n "$all" ] && [ -z "$packages" ] && [ -n "$(available)" ]; then
    purposes='useful packages that are not required'
    packages=$(available)
fi
[ -z "$purposes" ] && exit 0

if [ "$manager" = none ]; then
    printf 'setup: this machine lacks: %s. It has no apt-get, dnf, pacman or brew: install what is missing by hand.\n' \
        "$purposes" >&2
    exit 1
fi

# Homebrew and MSYS2 belong to the person who installed them, so they need no special rights.
is_own() { [ "$manager" = brew ] || [ "$column" = 5 ]; }
can_sudo() {
    command -v sudo >/dev/null || return
    if [ -t 0 ] && [ -t 2 ]; then return; fi
    sudo -n true 2>/dev/null
}

if [ "$mode" = install ] && ! is_own && [ "$(id -u)" = 0 ]; then
    printf 'setup: installing %s, which takes a minute or two (%s: %s)\n' "$purposes" "$manager" "$packages"
    carry_out ''
elif [ "$mode" = install ] && ! is_own && can_sudo; then
    printf 'setup: installing %s, which takes a minute or two (sudo %s: %s)\n' "$purposes" "$manager" "$packages"
    sudo -v || exit 1
    carry_out sudo
elif [ "$mode" = install ] && is_own && [ -t 0 ] && [ "$(id -u)" != 0 ]; then
    printf 'setup: installing %s, which takes a minute or two (%s: %s)\n' "$purposes" "$manager" "$packages"
    carry_out ''
else
    lacks=$purposes
    # A user who has to ask an administrator should ask only once, so the command also installs what `make test` needs.
    [ "$(id -u)" = 0 ] || [ "$column" = 5 ] || look "$@" test
    printf 'setup: this machine lacks: %s. To install them, type this, or give it to an administrator:\n  %s\n' "$lacks" \
        "$(one_command "$packages$(useful)")" >&2
    exit 1
fi

look "$@"
[ -z "$purposes" ] && exit 0
printf 'setup: still missing after the installation: %s\n' "$purposes" >&2
exit 1

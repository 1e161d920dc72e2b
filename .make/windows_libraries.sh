#!/bin/sh
# windows_libraries.sh - build, on Debian, the libraries that the cross build of the programs for Windows needs. zlib,
# libpng, GLFW and, for the tests, cmocka are compiled from Debian's source packages; cglm and stb consist only of
# headers. Everything is installed into build/windows/prefix, with the files for pkg-config and the licences.
#
# Environment: CC, the cross compiler with its flags. No special rights are needed, because the lists of the source
# packages are kept in build/windows/sources. The libraries are built once, and again if this script, the compiler or
# its flags change.
set -eu
export LC_ALL=C

folder=$PWD/build/windows
sources=$folder/sources prefix=$folder/prefix
compiler=${CC%% *}
archive=${compiler%gcc}ar

mkdir -p "$folder"
made=$(cat "$0" - <<END_OF_STATE | cksum
$CC
$PWD
$("$compiler" --version | head -n 1)
END_OF_STATE
)
[ "$(cat "$prefix/made" 2>/dev/null)" != "$made" ] || exit 0
echo 'windows: compiling zlib, libpng, GLFW and cmocka, which later builds reuse'
rm -rf "$prefix"
mkdir -p "$sources/lists/partial" "$sources/parts" "$prefix/lib/pkgconfig" "$prefix/include" "$prefix/licences"

# By default, Debian's compiler links the old C library, msvcrt, instead of the one of Windows 10.
"$compiler" -dumpspecs | sed 's/-lmsvcrt/-lucrt/g' >"$folder/ucrt.specs"

fail() {
    tail -n 5 "$sources/log" >&2
    printf 'make: windows: %s: see build/windows/sources/log\n' "$1" >&2
    exit 1
}

# ---- Debian's sources, with separate package lists ----

# source_lists: download lists of the source packages that this machine's package sources offer.
source_lists() {
    rm -f "$sources"/parts/*
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
        [ ! -e "$file" ] ||
            sed 's/^Types: .*/Types: deb-src/; s/^deb /deb-src /' "$file" >"$sources/parts/$(basename "$file")"
    done
    cat >"$sources/apt.conf" <<END_OF_CONFIGURATION
Dir::Etc::sourcelist "/dev/null";
Dir::Etc::sourceparts "$sources/parts";
Dir::State::lists "$sources/lists";
Dir::Cache::pkgcache "";
Dir::Cache::srcpkgcache "";
APT::Sandbox::User "";
END_OF_CONFIGURATION
    export APT_CONFIG="$sources/apt.conf"
    # An archive without source packages does not matter: the packages that are needed are requested below.
    apt-get -q update >"$sources/log" 2>&1 || true
}

# unpack PACKAGE: unpack the newest version that can be fetched into sources/PACKAGE/tree. An archive may list a version
# that it no longer has, or does not have yet.
unpack() {
    [ ! -e "$sources/$1/done" ] || return 0
    [ -n "${APT_CONFIG-}" ] || source_lists
    for version in $(apt-cache showsrc --only-source "$1" 2>>"$sources/log" | sed -n 's/^Version: //p' | sort -rVu); do
        rm -rf "${sources:?}/$1" && mkdir "$sources/$1"
        if (cd "$sources/$1" && apt-get -q source --download-only "$1=$version" &&
            dpkg-source --no-check -x ./*.dsc tree) >>"$sources/log" 2>&1; then
            touch "$sources/$1/done"
            return
        fi
    done
    fail "Debian's source package $1 cannot be fetched"
}

# ---- One library ----

# library NAME FLAGS FILE...: build lib/libNAME.a from these sources, which are compiled in parallel. The sources need
# only the lean part of <windows.h>, and no intrinsics, whose headers would be most of the code to compile.
library() {
    name=$1 flags=$2 compilers=
    shift 2
    rm -rf "$folder/objects" && mkdir "$folder/objects"
    for file in "$@"; do
        # shellcheck disable=SC2086 # the compiler and its flags are words
        $CC -O2 -w -DWIN32_LEAN_AND_MEAN -D_X86INTRIN_H_INCLUDED -I"$prefix/include" $flags \
            -c -o "$folder/objects/$(basename "$file" .c).o" "$file" >>"$sources/log" 2>&1 &
        compilers="$compilers $!"
    done
    for compiling in $compilers; do
        wait "$compiling" || fail "$name does not compile"
    done
    "$archive" rcsD "$prefix/lib/lib$name.a" "$folder"/objects/*.o
    rm -r "$folder/objects"
}

# describe NAME LIBRARIES: write the file for pkg-config.
describe() {
    printf 'Name: %s\nDescription: for Windows\nVersion: 0\nCflags: -I%s\nLibs: -L%s %s\n' \
        "$1" "$prefix/include" "$prefix/lib" "$2" >"$prefix/lib/pkgconfig/$1.pc"
}

for package in zlib libpng1.6 glfw3 cmocka; do
    unpack "$package"
done

z=$sources/zlib/tree
cp "$z/zlib.h" "$z/zconf.h" "$prefix/include"
library z '' "$z"/adler32.c "$z"/compress.c "$z"/crc32.c "$z"/deflate.c "$z"/inffast.c "$z"/inflate.c \
    "$z"/inftrees.c "$z"/trees.c "$z"/uncompr.c "$z"/zutil.c

png=$sources/libpng1.6/tree
cp "$png/png.h" "$png/pngconf.h" "$prefix/include"
cp "$png/scripts/pnglibconf.h.prebuilt" "$prefix/include/pnglibconf.h"
library png '' "$png"/png*.c
describe libpng '-lpng -lz'

glfw=$sources/glfw3/tree
cp -R "$glfw/include/GLFW" "$prefix/include"
set -- "$glfw"/src/context.c "$glfw"/src/init.c "$glfw"/src/input.c "$glfw"/src/monitor.c "$glfw"/src/vulkan.c \
    "$glfw"/src/window.c "$glfw"/src/win32_*.c "$glfw"/src/wgl_context.c "$glfw"/src/egl_context.c \
    "$glfw"/src/osmesa_context.c
# From GLFW 3.4 on, one library supports several platforms.
[ ! -e "$glfw/src/platform.c" ] || set -- "$@" "$glfw"/src/platform.c "$glfw"/src/null_*.c
library glfw3 '-D_GLFW_WIN32 -DUNICODE -D_UNICODE -DWINVER=0x0601 -D_WIN32_WINNT=0x0601' "$@"
describe glfw3 '-lglfw3 -lgdi32 -luser32 -lshell32'

cmocka=$sources/cmocka/tree
cp "$cmocka"/include/*.h "$prefix/include"
flags="-I$cmocka/include"
for header in STDARG STDDEF SETJMP STDLIB STRING STDIO STDINT INTTYPES IO MALLOC SIGNAL TIME STRINGS UNISTD SYS_STAT; do
    flags="$flags -DHAVE_${header}_H"
done
library cmocka "$flags -DHAVE_SNPRINTF -DHAVE_VSNPRINTF -DHAVE_STRSIGNAL" "$cmocka"/src/cmocka.c
describe cmocka -lcmocka

# Libraries that consist only of headers.
cp -R /usr/include/cglm "$prefix/include"
mkdir "$prefix/include/stb" && cp /usr/include/stb/stb_truetype.h "$prefix/include/stb"
describe cglm ''

# ---- Licences that must accompany the programs ----

licence() { # NAME FILE
    sed 's/[[:blank:]]*$//' "$2" >"$prefix/licences/$1.txt"
}
licence cglm /usr/share/doc/libcglm-dev/copyright
licence mingw-w64 /usr/share/doc/mingw-w64-common/copyright
licence libpng "$png/LICENSE"
licence glfw "$glfw/LICENSE.md"
licence stb_truetype /usr/share/doc/libstb-dev/copyright
sed -n '/^\/\* zlib.h/,/^\*\//p' "$z/zlib.h" | sed '/The data format/,$d; s/^\/\* //' >"$folder/zlib.txt"
licence zlib "$folder/zlib.txt"
rm "$folder/zlib.txt"
echo "$made" >"$prefix/made"

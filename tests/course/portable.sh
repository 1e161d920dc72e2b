#!/bin/bash
# portable.sh - tests that the commands that a reader types also run on a Mac, with bash 3.2, GNU make 3.81, and the
# awk, sed and grep of the BSDs. The suite searches the scripts for words that these tools lack. It also runs the
# commands with the BSDs' awk and with busybox instead of GNU's tools, and compares the results. It also tests line
# endings, a Mac's compiler, and the requests of setup.sh on a Mac and on Windows.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch

# ---- Words ----

# Patterns for words that only versions of bash after 3.2, or only GNU's tools, know.
cat >"$scratch/patterns" <<'END'
\$\{[a-zA-Z_]+(\^|,|@[A-Z])
(^|[ ;&(])(mapfile|readarray|coproc|nproc|tac|shuf|numfmt|realpath|md5sum|truncate) 
(declare|local|typeset) -[a-zA-Z]*[Agn]
\|&|&>>|;;?&( |$)|wait -n|printf '%\(|\$(EPOCH|BASHPID)|shopt -s (globstar|lastpipe)
mktemp -[pt]|date [^|]*%[0-9]*N|date -d|readlink -f|stat -(c|-)|sort -[a-zA-Z]*V
xargs (-d|-r|--)|(head|tail) -[nc] [-+]*-|grep -[a-zA-Z]*P|du -[a-z]*b|cp -[a-zA-Z]*[ad] 
sed -i( |$)|sed [^|]*\\[|+?]|find [^|]*-(printf|regex)
END

# words_in FILE...: prints the lines that match one of these patterns, except for comments.
words_in() {
    grep -HnE -f "$scratch/patterns" "$@" | grep -vE '^[^:]*:[0-9]*:[[:blank:]]*#'
}

# Each of these lines contains a word that a Mac lacks.
cat >"$scratch/newer" <<'END'
echo "${name^}"
declare -A table
mapfile -t lines <file
one |& two
date +%s%N
mktemp -p folder
readlink -f name
sort -V names
sed 's/a\|b/c/' file
sed -i 's/a/b/' file
grep -P 'a\d' file
find . -printf '%f'
head -n -1 file
END
: >"$scratch/missed"
while IFS= read -r line; do
    printf '%s\n' "$line" >"$scratch/one"
    words_in "$scratch/one" >/dev/null || printf '%s\n' "$line" >>"$scratch/missed"
done <"$scratch/newer"
check 'each word that a Mac lacks is detected' [ ! -s "$scratch/missed" ] || sed 's/^/# /' "$scratch/missed"
# fresh.sh makes bare Debian machines, and windows_libraries.sh builds libraries from Debian's source packages; both run
# only on Debian.
find .make -name '*.sh' ! -name fresh.sh ! -name windows_libraries.sh | sort | xargs grep -l . >"$scratch/scripts"
printf '%s\n' tests/run tests/lib/tap.sh tests/pictures/references.sh >>"$scratch/scripts"
while read -r file; do words_in "$file"; done <"$scratch/scripts" >"$scratch/words"
check 'no script that a reader runs contains a word that a Mac lacks' [ ! -s "$scratch/words" ] || sed 's/^/# /' "$scratch/words"

# GNU make 3.81 does not know private, undefine, !=, ::=, .ONESHELL, &:, $(file ...), $(intcmp ...) or $(let ...).
newer_make() { grep -nE '^(private|undefine) |^[A-Z_a-z]+ *(!=|::=)|^\.ONESHELL|&:|\$\((file|intcmp|let) ' "$@"; }
# shellcheck disable=SC2016 # the text is for make
printf '%s\n' 'X != date' 'X ::= a' 'undefine X' '.ONESHELL:' 'a b &: c' 'X = $(file >a,b)' >"$scratch/make"
check 'each word that make 3.81 lacks is detected' [ "$(newer_make "$scratch/make" | wc -l)" = 6 ]
newer_make Makefile >"$scratch/words"
check 'the Makefile contains no word that make 3.81 lacks' [ ! -s "$scratch/words" ] || sed 's/^/# /' "$scratch/words"

# ---- Line endings ----

# Clone the files with a git that is set to write carriage returns, as its installer for Windows proposes. `make` and
# the scripts would fail on carriage returns.
kept_by_git() {
    local git=(git -c core.autocrlf=true -c core.eol=crlf -c core.safecrlf=false -c user.name=t -c user.email=t@t)
    mkdir "$scratch/ours" && cp -R .gitattributes Makefile .make chapters tests/lib/tap.sh "$scratch/ours" &&
        mkdir -p "$scratch/ours/tests/corpus" && cp -R tests/corpus "$scratch/ours/tests" &&
        cp shaders/textures/noise.png docs/README.md common/picture/font/*.ttf "$scratch/ours" || return
    (cd "$scratch/ours" && "${git[@]}" init -q && "${git[@]}" add . && "${git[@]}" commit -q -m all) || return
    "${git[@]}" clone -q "$scratch/ours" "$scratch/theirs" && rm -rf "$scratch"/*/.git
}
if command -v git >/dev/null; then
    check "a git that writes Windows' line endings can clone the files" kept_by_git
    check 'the files of the clone have the same bytes' diff -rq "$scratch/ours" "$scratch/theirs"
else
    skip "a git that writes Windows' line endings can clone the files" 'this machine has no git'
fi

# ---- A Mac's compiler ----

# Compile the code for __APPLE__, with stand-ins for Apple's C library. Nothing else compiles this code here.
mkdir -p "$scratch/apple/mach-o"
printf '#include <stdint.h>\nint _NSGetExecutablePath(char *path, uint32_t *size);\n' >"$scratch/apple/mach-o/dyld.h"
apple() { # FILE...
    local file
    for file in "$@"; do
        clang -std=c11 -D_XOPEN_SOURCE=700 -D_DARWIN_C_SOURCE -D__APPLE__ -Dst_mtimespec=st_mtim -isystem "$scratch/apple" -Icommon \
            -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only "$file" || return
    done
}
# Build a whole program with a Mac's compiler and feature macros, and with GLFW, which is the only backend on a Mac. The
# program is not optimised, to save time.
mac_build() {
    env -u MAKEFLAGS CI=1 make -j2 MAC=Darwin CC=clang CFLAGS=-O0 BUILD=build/mac build/mac/03_shadows >"$scratch/mac" 2>&1 && return
    tail -n 20 "$scratch/mac" | sed 's/^/# /'
    return 1
}
mac_picture() ( # on a display that is closed afterwards
    open_display && build/mac/03_shadows -o "$scratch/mac.png" &&
        build/tests/compare tests/references/03_shadows.png "$scratch/mac.png" >"$scratch/numbers"
    status=$?
    close_display
    exit $status
)
if command -v clang >/dev/null; then
    check "the code of common/platform/ compiles for a Mac's C library" apple common/platform/posix*.c
    check "a program builds with clang, a Mac's macros and only GLFW" mac_build
    if command -v Xvfb >/dev/null; then
        check "a program built as on a Mac renders to a file with a hidden window" mac_picture
    else
        skip "a program built as on a Mac renders to a file with a hidden window" 'this machine has no Xvfb'
    fi
elif [ -n "${CI-}" ]; then
    not_ok "a Mac's compiler" 'this machine has no clang'
fi

# ---- Tools ----

if ! command -v original-awk >/dev/null || ! command -v busybox >/dev/null; then
    skip "the commands with tools other than GNU's" 'this machine has no original-awk or no busybox: make setup installs them'
    plan
    exit
fi
mkdir "$scratch/bsd" "$scratch/busybox"
ln -s "$(command -v original-awk)" "$scratch/bsd/awk"
for tool in awk basename cat cmp comm cp cut dirname grep head ls mkdir mktemp mv od paste rm sed seq sort tail tee tr \
    uniq wc xargs; do
    ln -s "$(command -v busybox)" "$scratch/busybox/$tool"
done

# answer TOOLS COMMAND...: prints the output and the status of a command. TOOLS is gnu, or bsd or busybox, whose tools
# the command then finds before GNU's.
answer() {
    local path=$PATH
    [ "$1" = gnu ] || path=$scratch/$1:$PATH
    shift
    PATH=$path "$@" 2>&1 </dev/null
    echo "status $?"
}
# same NAME COMMAND...: the answers with all three sets of tools must be the same.
same() {
    local name=$1
    shift
    answer gnu "$@" >"$scratch/gnu.said"
    for tools in bsd busybox; do
        answer $tools "$@" >"$scratch/said"
        check "$name: the output is the same with the tools of $tools" cmp -s "$scratch/gnu.said" "$scratch/said" || diff "$scratch/gnu.said" "$scratch/said" | head -n 5 | sed 's/^/# /'
    done
}

# make check judges a wrong answer, so that its output contains pixels, reasons and rays.
sed 's/0\.5/0.6/' chapters/solutions/01_normal_colouring_2.frag >"$scratch/wrong.frag"
export CHAPTER='' FILES='' NAME=''
checks() { EXERCISE=01_2 FILE=$scratch/wrong.frag .make/check.sh; }
lists() { ls -1 chapters/0[0-3]_*.c && (. .make/chapters.sh && stems); }
marks() { .make/listings.sh --check; }
same 'make help' make help
same 'make check' checks
same 'make docs' marks
same 'the list of chapters' lists
same 'the list of suites' tests/run --find no_such_suite
compares() { PICTURES='tests/references/01_normal_colouring.png tests/references/02_lighting.png' .make/compare.sh; }
same 'make compare' compares
# The numbers of make benchmark differ each time, so only the form of the table is checked.
measures() { ROUNDS=1 FRAMES=2 CHAPTER=00 .make/benchmark.sh; }
for tools in bsd busybox; do
    answer $tools measures >"$scratch/said"
    check "make benchmark prints its table with the tools of $tools" grep -q '^| 00_first_scene | [0-9.]* | [0-9.]* | [0-9.]* | [0-9]* | - |' "$scratch/said" ||
        sed 's/^/# /' "$scratch/said"
done
check 'with the tools of bsd, make check reports a pixel' grep -q 'your pixel' <(answer bsd checks)

# ---- What setup.sh requests on a Mac ----

# A Mac as setup.sh sees it. It has a compiler, but nothing else that the course needs.
mkdir -p "$scratch/macos" "$scratch/homebrew/include/stb"
for tool in sh cut printf tr sort; do ln -s "$(command -v $tool)" "$scratch/macos/$tool"; done
on_mac() { printf '#!/bin/sh\n%s\n' "$2" >"$scratch/macos/$1" && chmod +x "$scratch/macos/$1"; } # TOOL COMMAND
on_mac cc true
on_mac id 'echo 501'
on_mac uname 'echo Darwin'
on_mac xcode-select false
# asked_for PATTERN: setup.sh must fail, and its last line must match this pattern.
asked_for() {
    ! env -i PATH="$scratch/macos" "$scratch/macos/sh" .make/setup.sh run >"$scratch/lacks" 2>&1 </dev/null &&
        tail -n 1 "$scratch/lacks" | grep -q -e "$1" && return
    sed 's/^/# /' "$scratch/lacks"
    return 1
}
check "on a Mac, setup.sh asks for Apple's tools first" asked_for 'xcode-select --install$'
on_mac xcode-select true
check "on a Mac with Apple's tools, setup.sh asks for Homebrew" asked_for 'Homebrew.*https://brew.sh'
on_mac brew "echo '$scratch/homebrew'"
check 'on a Mac with Homebrew, setup.sh asks for the folder of stb' asked_for "git clone --depth 1 https://github.com/nothings/stb $scratch/homebrew/include/stb\$"
: >"$scratch/homebrew/include/stb/stb_truetype.h"
check "on a Mac with stb, setup.sh asks for Homebrew's packages, including those of the tests" asked_for '^  brew install cglm cmocka git glfw imagemagick libpng pkg-config$'

# ---- Windows ----

# A shell on Windows as setup.sh sees it. It is MSYS2's shell, with pacman but nothing else that the course needs.
mkdir "$scratch/windows"
for tool in sh cut printf uname tr sort; do ln -s "$(command -v $tool)" "$scratch/windows/$tool"; done
printf '#!/bin/sh\nexit 1\n' >"$scratch/windows/pacman" && chmod +x "$scratch/windows/pacman"
# shellcheck disable=SC2317 # called by name
lacks() { # MSYSTEM
    ! env -i OS=Windows_NT MSYSTEM="$1" PATH="$scratch/windows" sh .make/setup.sh run >"$scratch/lacks" 2>&1
}
names() { lacks UCRT64 && grep -qx "  pacman -Sy --needed diffutils$(printf ' mingw-w64-ucrt-x86_64-%s' cglm gcc glfw libpng pkgconf stb)" "$scratch/lacks"; }
check "setup.sh asks for MSYS2's packages, without EGL" names
other() { lacks MINGW64 && grep -q "shell 'MSYS2 UCRT64'.*MINGW64" "$scratch/lacks"; }
check 'setup.sh names the right shell in another shell of MSYS2' other
builds() { make -n OS=Windows_NT programs >"$scratch/builds" && grep -q 'build/00_first_scene\.exe .*/platform/windows_main\.o .*-municode' "$scratch/builds"; }
check 'on Windows, make builds programs for Windows' builds
check 'the programs for Windows contain no code for another system' [ "$(grep -cE 'platform/posix|context/(egl|osmesa)\.o' "$scratch/builds")" = 0 ]
plan

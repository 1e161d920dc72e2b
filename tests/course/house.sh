#!/bin/bash
# house.sh - tests the rules of docs/architecture.md: which folders of common/ may use which others, which files may
# depend on the system, and how many files may be directly in common/. It also tests that the modules of the textures
# form no cycle, that the shaders avoid functions whose results are undefined or inaccurate, and that a picture shows
# each view.
#
# The dependencies between the folders are checked in two independent ways: from the includes of the sources, and from
# the symbols that the objects need from each other.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch

# The folders from bottom to top. A folder may use only itself and the folders below it.
rooms='ground context shader dialects picture window command top browser'

# room_of, in awk: the folder of a path in common/. Files directly in common/ are 'ground', except for chapter.c and
# chapter.h, which use all folders and are 'top'; platform/ is part of the ground.
room_of='
function room_of(path) {
    sub(/^common\//, "", path)
    if (path ~ /\// && path !~ /^platform\//)
        return substr(path, 1, index(path, "/") - 1)
    return path ~ /^chapter(\.|$)/ ? "top" : "ground"
}'

# Print the lines "FROM TO" of standard input in which TO is in a higher folder than FROM, or either folder is unknown.
upwards() {
    awk -v rooms="$rooms" "$room_of"'
        BEGIN { n = split(rooms, name, " "); for (i = 1; i <= n; i++) rank[name[i]] = i }
        !(room_of($1) in rank) || !(room_of($2) in rank) || rank[room_of($2)] > rank[room_of($1)]'
}

# check_empty NAME FILE: the file lists violations and must be empty.
check_empty() {
    check "$1" [ ! -s "$2" ] || sed 's/^/# /' "$2"
}

# ---- By includes ----

find common -name '*.[ch]' | sort >"$scratch/files"
# includes_of FOLDER: prints the lines "FROM TO" of the includes in the files on standard input; TO begins with FOLDER.
includes_of() {
    # shellcheck disable=SC2016 # $0 is awk's
    xargs awk -v folder="$1" '/^#include "/ { split($0, part, "\""); print FILENAME, folder part[2] }'
}

includes_of common/ <"$scratch/files" >"$scratch/includes"
check 'the includes between the sources of common/ are found' [ "$(wc -l <"$scratch/includes")" -gt 50 ]
while read -r from to; do
    [ -e "$to" ] || echo "$from includes $to"
done <"$scratch/includes" >"$scratch/lost"
check_empty 'each include in common/ gives the path from common/' "$scratch/lost"
upwards <"$scratch/includes" >"$scratch/up"
check_empty 'no file includes a header from a higher folder' "$scratch/up"

# A module is a header and the sources that include it first. The includes of the modules must not form a cycle.
check_modules() { # NAME, with lines of includes_of on standard input
    awk '
        !($1 in module) { module[$1] = $1 ~ /\.h$/ ? $1 : $2 }
        { from[NR] = $1; to[NR] = $2 }
        END {
            for (i = 1; i <= NR; i++) {
                a = module[from[i]]
                if (a != to[i])
                    print a, to[i]
            }
        }' | sort -u | tsort 2>"$scratch/circle" >/dev/null
    check_empty "$1" "$scratch/circle"
}

check_modules 'the includes of the modules form no cycle' <"$scratch/includes"
for header in shaders/textures/*.h; do
    echo "$header" "${header%.h}.c" # without the programs, which no file includes
done | includes_of shaders/textures/ >"$scratch/painted"
check 'the includes between the modules of the textures are found' [ "$(wc -l <"$scratch/painted")" -gt 20 ]
check_modules 'the includes of the modules of the textures form no cycle' <"$scratch/painted"

# ---- By symbols ----

# List the pairs of objects in which the first needs a symbol that the second defines. nm -P prints the name and the
# kind of each symbol first; on macOS, each name begins with an underscore. Objects without a source, left over from an
# earlier build, are not read. A source may have no object, because it is for another system or for a library that this
# machine lacks. One symbol is left out: 'dialects', the struct of functions through which shader/ calls the folder
# dialects/ above it, and which a program may define as an empty struct instead (tests/command/dialects.sh does so).
grep '\.c$' "$scratch/files" | while read -r file; do
    [ ! -e "$BUILD/${file%.c}.o" ] || nm -P -g "$BUILD/${file%.c}.o" | awk -v module="${file%.c}" '{ print $2, $1, module }'
done | awk '
    $1 == "U" { asks[++n] = $2 " " $3 }
    $1 != "U" { home[$2] = $3 }
    END {
        for (i = 1; i <= n; i++) {
            split(asks[i], ask, " ")
            if (ask[1] !~ /^_?dialects$/ && ask[1] in home && home[ask[1]] != ask[2])
                print ask[2], home[ask[1]]
        }
    }' | sort -u >"$scratch/calls"
check 'the calls between the objects of common/ are found' [ "$(wc -l <"$scratch/calls")" -gt 50 ]
upwards <"$scratch/calls" >"$scratch/up"
check_empty 'no object needs a symbol from a higher folder' "$scratch/up"
tsort "$scratch/calls" >/dev/null 2>"$scratch/circle"
check_empty 'the calls between the objects form no cycle' "$scratch/circle"

# How far a module reaches: the objects that a program which calls it must link, itself included.
reach_of() {
    awk -v first="common/$1" '
        { calls[$1] = calls[$1] " " $2 }
        END {
            list[n = 1] = first
            seen[first] = 1
            for (i = 1; i <= n; i++)
                for (k = split(calls[list[i]], to, " "); k > 0; k--)
                    if (!seen[to[k]]++)
                        list[++n] = to[k]
            for (i = 1; i <= n; i++)
                print list[i]
        }' "$2"
}

# check_reach MODULE OBJECTS: links at most so many.
check_reach() {
    reach_of "$1" "$scratch/calls" >"$scratch/reach"
    check "$1 needs at most $2 objects" [ "$(wc -l <"$scratch/reach")" -le "$2" ] || sed 's/^/# /' "$scratch/reach"
}

printf 'common/%s common/%s\n' a b b c b a d a >"$scratch/few"
check 'the objects that a module needs are counted' [ "$(reach_of a "$scratch/few" | wc -l)" = 3 ]
check_reach picture/target 6
check_reach picture/overlay 9

# ---- Systems ----

# Code for one operating system is in common/platform/. There is one exception: the backend osmesa includes <dlfcn.h>.
platform='^common/platform/[a-z0-9_]*\.c:'

# systems_in FILE...: prints the lines that test for an operating system.
systems_in() {
    grep -HnE '^[[:blank:]]*#.*\<(_WIN(32|64)|__(APPLE|MACH|linux|unix|FreeBSD|MINGW32|MINGW64|CYGWIN)__|__unix)\>' "$@"
}

# headers_in FILE...: prints the lines that include a system header that is not part of C11.
headers_in() {
    grep -HnE '^[[:blank:]]*#[[:blank:]]*include <(sys/|mach|unistd|fcntl|signal|pthread|dirent|dlfcn|ftw|libgen|poll|pwd|spawn|strings|termios|windows|io\.|GL/)' "$@"
}

printf '#if defined(__APPLE__) || 0\n#ifdef _WIN32\n#  ifndef __linux__\n// #ifdef\n' >"$scratch/asks.c"
check 'a test for an operating system is detected' [ "$(systems_in "$scratch/asks.c" | wc -l)" = 3 ]
# shellcheck disable=SC2046 # no name of a source has a blank
systems_in $(find common chapters docs shaders tests -name '*.[ch]' | sort) | grep -v "$platform" >"$scratch/systems"
check_empty 'only files in common/platform/ test for an operating system' "$scratch/systems"
# shellcheck disable=SC2046 # no name of a source has a blank
headers_in $(<"$scratch/files") | grep -v "$platform" |
    grep -v '^common/context/osmesa\.c:[0-9]*:#include <dlfcn\.h>$' >"$scratch/headers"
check_empty "only common/platform/ and the backend osmesa include system headers" "$scratch/headers"
check 'system headers are detected' [ "$(headers_in common/platform/posix.c | wc -l)" -gt 2 ]

# The compiler reports a type, a constant or a function that is declared differently in Khronos' header.
agrees() {
    printf '#define GL_GLEXT_PROTOTYPES\n#include <GL/glcorearb.h>\n#include "context/gl.h"\n%s\n%s\n%s\n' \
        '#define DECLARE(type, name, arguments) type gl##name arguments;' \
        'GL_FUNCTIONS(DECLARE)' 'GL_TIMER_FUNCTIONS(DECLARE)' >"$scratch/both.c"
    cc -std=c11 -pedantic-errors -Werror -Icommon -fsyntax-only "$scratch/both.c"
}
check "our types, constants and functions of OpenGL agree with Khronos'" agrees

# ---- Shaders ----

# GLSL leaves smoothstep undefined if its first edge is not below the second.
falling() {
    grep -HnoE 'smoothstep\((-?[0-9.]+), (-?[0-9.]+),' "$@" | awk -F '[(,]' '$2 + 0 >= $3 + 0'
}

printf 'a = smoothstep(1.0, 0.5, x) + smoothstep(-0.5, 0.5, x);\n' >"$scratch/falls.glsl"
check 'a smoothstep with falling edges is detected' [ "$(falling "$scratch/falls.glsl" | wc -l)" = 1 ]
# shellcheck disable=SC2046 # no name of a shader has a blank
falling $(find shaders chapters -name '*.glsl' -o -name '*.frag' | sort) >"$scratch/falling"
check_empty 'no shader calls smoothstep with falling edges' "$scratch/falling"

# In Mesa 22.3, asin and acos have an error of up to 0.0004 (build/tests/shaders/precision prints the error of this
# machine's driver), and no specification of GLSL bounds their error. atan(y, x), which finds the same angles from two
# lengths, has an error of only 3e-6 in Mesa 22.3.
find shaders chapters \( -name '*.glsl' -o -name '*.frag' \) -exec grep -nE '^[^/]*[^a-zA-Z]a(sin|cos)\(' {} + >"$scratch/arcs"
check_empty 'no shader relies on asin or acos' "$scratch/arcs"

# Other functions are undefined for some arguments. Each library function that calls one of them must be tried with its
# extreme arguments on the graphics processor, in tests/shaders/edges.frag. Functions that read a picture, or draw a
# view or a figure, are left out, because the references check them.
edgy() {
    awk 'FNR == 1 { name = "" }
        /^[A-Za-z][A-Za-z0-9]* [a-z][A-Za-z0-9]*\(/ { name = /sampler2D/ ? "" : $2; sub(/\(.*/, "", name) }
        { sub(/\/\/.*/, "") }
        /^}/ { name = "" }
        name != "" && /(^|[^a-zA-Z])(atan|pow|asin|acos|log2?|inversesqrt|normalize)\(/ && !seen[name]++ { print name }' "$@"
}

printf 'float bare(float x)\n{\n    return log(x);\n}\n// log(x)\nfloat even(float x)\n{\n    return exp(x);\n}\n' >"$scratch/edgy.glsl"
check 'a function that calls log is detected' [ "$(edgy "$scratch/edgy.glsl")" = bare ]
# shellcheck disable=SC2046 # no name of a shader has a blank
edgy $(find shaders -name '*.glsl' | grep -vE '/(coarse|figure|plot|projection|signs|slice|views).glsl$' | sort) | while read -r name; do
    grep -q "[^A-Za-z]$name(" tests/shaders/edges.frag || echo "$name"
done >"$scratch/untried"
check_empty 'every library function that calls a function with undefined results is in tests/shaders/edges.frag' "$scratch/untried"

# The references check the views, so each view has one.
sed -n 's/^ *ROW([A-Z]*, OF_[A-Z]*, [0-9], "\([a-z]*\)").*/\1/p' common/shader/view.h >"$scratch/views"
check 'the views are found' [ "$(wc -l <"$scratch/views")" -gt 5 ]
grep -vx picture "$scratch/views" | while read -r view; do
    grep -v '^#' tests/pictures/images.txt | grep -qE -e "-v $view( |$)" || echo "$view"
done >"$scratch/undrawn"
check_empty 'a picture in tests/pictures/images.txt shows each view' "$scratch/undrawn"

# ---- Size ----

find common -maxdepth 1 -type f >"$scratch/flat"
check 'at most 14 files are directly in common/' [ "$(wc -l <"$scratch/flat")" -le 14 ]
plan

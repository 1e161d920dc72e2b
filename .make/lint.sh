#!/bin/bash
# lint.sh - `make lint`: check every source with every checker that knows its language. make calls it after the programs
# are built. CFLAGS contains the options for the language, the warnings and this machine's libraries.
#
# A source that passes gets a stamp, and is not checked again until a file that its checkers read has changed. A stamp
# is a file whose name contains the language, the source's name, and checksums of the checkers' settings and of the
# source. It lists the checksum of every file that was read.
set -u
export LC_ALL=C

scratch=build/lint
stamps=${XDG_CACHE_HOME:-$HOME/.cache}/ray-marching/lint
read -r -a flags <<<"${CFLAGS-}"
# In a function with many paths, clang's analyzer needs seconds for the last of them, so the number of its states is
# limited. ALL=1 raises the limit.
states=${ALL:+225000}
states=${states:-50000}
windows=(-std=c11 -D_WIN32_WINNT=0x0A00 -Icommon -Ishaders -Itests -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)

# clang looks for the headers for Windows beside the compiler in PATH, which must not be a link to ccache.
PATH=${PATH//\/usr\/lib\/ccache:/}

# ---- The checkers: one process for several sources costs less than one for each ----

check_c() { compile gcc '' "${flags[@]}"; }
check_windows() { compile x86_64-w64-mingw32-gcc --target=x86_64-w64-mingw32 -D_UCRT "${windows[@]}"; }

# gcc finds some mistakes only when it optimises, and lists the headers. clang-tidy reports clang's warnings too. It
# needs a process for each source: after the first one, its analyzer no longer recognises va_start.
compile() { # COMPILER TARGET FLAG...
    for file in "${sources[@]}"; do
        "$1" "${@:3}" -O2 -c -o /dev/null -MD -MF "$scratch/$$.d" "$file" || failed=1
        sed 's/^[^ ]*: //; s/\\$//' "$scratch/$$.d" | xargs sha256sum >"$(list_of "$file")" || failed=1
        clang-tidy --quiet "$file" -- ${2:+"$2"} "${@:3}" -Xclang -analyzer-config -Xclang "max-nodes=$states" || failed=1
    done
    check_cppcheck
}

# Two of cppcheck's checks are suppressed: it reads no system headers, so it would take functions of unknown type to
# return integers; and it does not follow realloc as clang's analyzer does.
check_cppcheck() {
    cppcheck --quiet --error-exitcode=1 --inline-suppr --std=c11 \
        --enable=warning,performance,portability --suppress=missingIncludeSystem \
        --suppress=CastIntegerToAddressAtReturn --suppress=memleak \
        -Icommon -Ishaders -Itests -DHAVE_GLFW -DHAVE_EGL -DHAVE_OSMESA "${sources[@]}" || failed=1
}

check_shell() {
    shellcheck -x "${sources[@]}" || failed=1
    for file in "${sources[@]}"; do # a stamp also lists the scripts that a script sources
        awk '!/^ *#/ { for (i = 1; i < NF; i++) if ($i == "." && $(i + 1) ~ /[.]sh$/) print $(i + 1) }' "$file" | xargs sha256sum "$file" >"$(list_of "$file")"
    done
}

# Check expanded shaders as desktop OpenGL and, if they must run in a browser, as ES: once for each view, or once in all
# if the shader does not distinguish the views. In the course's own dialect, line 1 is #version, and the names of all
# views and VIEW, which is one of them, follow.
check_glsl() {
    local es variants=()
    for file in "${sources[@]}"; do
        # The chapters must run in a browser; experiments, solutions and the shaders of the engine need not.
        case $file in */experiments-* | */solutions-* | */first_steps-engine_*) es=0 ;; *) es=1 ;; esac
        read -r -a variants <<<"${variants[*]-} $(awk -v name="${file%.frag}" -v es=$es '
            { line[NR] = $0 }
            NR == names + 2 && /^#define VIEW_[A-Z]+ [0-9]+$/ { view_name[names++] = $2; next }
            NR == names + 2 && $2 == "VIEW" { own = NR; next }
            !/^#define VIEW/ && /VIEW/ { distinguishes = 1 }
            END {
                for (view = 0; view < (own && distinguishes ? names : 1); view++)
                    for (dialect = 0; dialect <= es; dialect++) {
                        if (own)
                            line[own] = "#define VIEW " view_name[view]
                        out = name "." view (dialect ? ".es" : ".330") ".frag"
                        if (dialect)
                            print "#version 300 es\nprecision highp float;\nprecision highp int;\n" \
                                "precision highp sampler2D;\nprecision highp sampler3D;\n" \
                                "precision highp usampler2D;" >out
                        for (i = 1 + dialect; i <= NR; i++)
                            print line[i] >out
                        close(out)
                        printf "%s ", out
                    }
            }' "$file")"
    done
    # The validator prints the name of every file; only those with a message matter.
    glslangValidator -S frag "${variants[@]}" >"$scratch/$$.log" || failed=1
    grep -B1 '^[A-Z]*:' "$scratch/$$.log"
    rm -f "${variants[@]}"
}

# Expand a shader and print the name of the result; no OpenGL is needed. A library file is included
# in a stub, because it must compile without other files.
expand() { # SHADER
    local name=${1#chapters/} shader=$1
    name=$scratch/${name//\//-}
    if [ "${1##*.}" = glsl ]; then
        shader=$name.stub.frag
        printf '#include "%s"\n' "${1##*/}" >"$shader"
        if grep -q '^uniform usampler2D' "$1"; then # only the course's dialect, that of main.glsl, has tables
            printf '#include "main.glsl"\n' >>"$shader"
        elif ! grep -qE 'void main\(\)|include "main.glsl"' "$1"; then
            printf 'void main() {}\n' >>"$shader"
        fi
    fi
    build/00_first_scene --shader "$shader" --print-shader >"$name.frag" || return
    # A shader with a main of its own is not the course's, so the names of the views are missing.
    if ! grep -q '^#define VIEW ' "$name.frag"; then
        build/01_normal_colouring --print-shader | sed -n 's/^#define VIEW.*/&/p' >"$name.views"
        sed -i.old "1r $name.views" "$name.frag"
    fi
    printf '%s\n' "$name.frag"
}

# Print the name of the list of the files that the checkers read for a source, with their checksums.
list_of() { # FILE
    printf '%s/%s.read' "$scratch" "${1//\//-}"
}

# ---- Some sources of one language ----

check() { # LANGUAGE SETTINGS FILE...
    local language=$1 settings=$2 failed=0 files=() sources=() names=() current=() sums hash file i
    shift 2
    for file in "$@"; do
        [ "$language" != glsl ] || file=$(expand "$file") || { failed=1; continue; }
        files+=("$file")
    done
    [ ${#files[@]} != 0 ] && sums=$(sha256sum -- "${files[@]}") || return 1
    while read -r hash file; do
        name=$stamps/$language-$settings-${file//\//-}-$hash
        if sha256sum --status --check "$name" 2>/dev/null; then
            current+=("$name")
        else
            sources+=("$file")
            names+=("$name")
            printf '%s  %s\n' "$hash" "$file" >"$(list_of "$file")"
        fi
    done <<<"$sums"
    [ ${#current[@]} = 0 ] || touch "${current[@]}"
    [ ${#sources[@]} != 0 ] || return $failed
    "check_$language"
    [ $failed = 0 ] || return 1
    for i in "${!sources[@]}"; do
        cp "$(list_of "${sources[i]}")" "${names[i]}.$$" && mv "${names[i]}.$$" "${names[i]}"
    done
}

if [ $# != 0 ]; then
    output=$(check "$@" 2>&1) || { printf '%s\nlint: faults in some of %s\n' "$output" "${*:3}"; exit 1; }
    exit 0
fi

# ---- All sources ----

shopt -s nullglob
rm -rf "$scratch"
mkdir -p "$scratch" "$stamps"
find "$stamps" -type f -mtime +30 -exec rm -f {} +
jobs=$(getconf _NPROCESSORS_ONLN) failed=0

# The settings are the contents of files, the flags and the versions of programs.
lint() { # LANGUAGE SETTINGS FILE...
    local language=$1 setting settings
    settings=$(for setting in .make/lint.sh $2; do
        if [ -f "$setting" ]; then cat "$setting"; else printf '%s\n' "${CFLAGS-}" "$states" && "$setting" --version; fi
    done | sha256sum | cut -c 1-16)
    shift 2
    printf '%s\n' "$@" | xargs -P "$jobs" -n 8 .make/lint.sh "$language" "$settings" || { failed=1; return 1; }
}

here=() elsewhere=()
for file in $(find common chapters shaders tests docs -name '*.c' | sort); do
    case $file in */platform/windows*.c | *_windows.c) elsewhere+=("$file") ;; *) here+=("$file") ;; esac
done
# The check of the layout uses no stamps, because computing the checksums would take as long as the check itself.
find common chapters shaders tests docs -name '*.[ch]' -print0 |
    xargs -0 -P "$jobs" -n 100 clang-format --dry-run --Werror || failed=1
ci=.ci/run
[ -e $ci ] || ci= # the course for students has none
lint shell shellcheck .make/*.sh tests/run tests/*/*.sh ${ci:+"$ci"}
{ echo '#version 330 core' && cat shaders/screen.vert; } >"$scratch/screen.vert"
glslangValidator -S vert "$scratch/screen.vert" || failed=1
# Expanding every shader takes longer than computing the checksums of all files that the shaders depend on, so a single
# stamp covers them all.
whole() {
    { glslangValidator --version && find build/00_first_scene .make/lint.sh shaders chapters -type f -print0 |
        sort -z | xargs -0 sha256sum; } | sha256sum | cut -c 1-64
}
before=$(whole)
touch -c "$stamps/glsl-$before"
if [ ! -f "$stamps/glsl-$before" ]; then
    # The harness refuses engine_5.frag, a shader of docs/engine.md, because of its uniform `picture`.
    # tests/course/first_steps.sh draws with it.
    drawn=()
    for shader in chapters/*/*.frag; do
        case $shader in */engine_5.frag) ;; *) drawn+=("$shader") ;; esac
    done
    lint glsl glslangValidator shaders/*.glsl chapters/*.glsl chapters/*.frag "${drawn[@]}" &&
        [ "$before" = "$(whole)" ] && : >"$stamps/glsl-$before"
fi
if command -v x86_64-w64-mingw32-gcc >/dev/null; then
    lint windows '.clang-tidy x86_64-w64-mingw32-gcc clang-tidy cppcheck' "${elsewhere[@]}"
else
    lint cppcheck cppcheck "${elsewhere[@]}"
fi
lint c '.clang-tidy gcc clang-tidy cppcheck' "${here[@]}"

[ $failed = 0 ] || { echo 'lint: failed' >&2; exit 1; }
echo "lint: no faults found"

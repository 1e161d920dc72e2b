#!/bin/bash
# lint.sh - `make lint`: every source against every checker that knows its language. Called by make
# after the programs are built; CFLAGS holds the language, the warnings and what this machine has.
set -u
export LC_ALL=C

glsl_folder=build/lint
read -r -a flags <<<"${CFLAGS-}"
windows=(-std=c11 -D_WIN32_WINNT=0x0A00 -Icommon -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)

# ---- GLSL ----

# validate FILE NAME: an expanded fragment shader, as desktop OpenGL and as ES. Its line 1 is #version.
validate() {
    local desktop=$glsl_folder/$2.330.frag es=$glsl_folder/$2.es.frag failed=0
    cp "$1" "$desktop"
    {
        printf '#version 300 es\n'
        printf 'precision highp %s;\n' float int sampler2D sampler3D
        tail -n +2 "$1"
    } >"$es"
    glslangValidator -S frag "$desktop" || failed=1
    # The chapters must run in a browser; a reader's little example need not.
    case $2 in
    experiments-* | solutions-*) ;;
    *) glslangValidator -S frag "$es" || failed=1 ;;
    esac
    return $failed
}

# Expand a shader into FILE; no OpenGL is needed for it.
expand() { # SHADER FILE
    build/00_first_scene --shader "$1" --print-shader >"$2"
}

# A library file in a stub of its own: it must stand alone.
check_library() {
    local name stub
    name=library-$(basename "$1" .glsl)
    stub=$glsl_folder/$name.stub.frag
    printf '#include "%s"\n' "$(basename "$1")" >"$stub"
    grep -q 'void main()' "$1" || printf 'void main() {}\n' >>"$stub"
    expand "$stub" "$glsl_folder/$name.frag" && check_views "$glsl_folder/$name.frag" "$name"
}

check_shader() {
    local name
    name=$(echo "${1#chapters/}" | tr / -)
    name=${name%.frag}
    expand "$1" "$glsl_folder/$name.frag" && check_views "$glsl_folder/$name.frag" "$name"
}

# The course's own form is compiled once for each view.
check_views() { # EXPANDED NAME
    local view failed=0
    if ! sed -n 2p "$1" | grep -q '^#define VIEW '; then
        validate "$1" "$2"
        return
    fi
    for view in 0 1 2 3 4 5 6 7 8 9; do
        sed "2s/.*/#define VIEW $view/" "$1" >"$glsl_folder/$2.$view.frag"
        validate "$glsl_folder/$2.$view.frag" "$2.$view" || failed=1
    done
    return $failed
}

check_vertex() {
    cp "$1" "$glsl_folder/vertex.vert"
    grep -q '^#version' "$1" || { echo '#version 330 core'; cat "$1"; } >"$glsl_folder/vertex.vert"
    glslangValidator -S vert "$glsl_folder/vertex.vert"
}

# ---- One check ----

one() { # CHECK [FILE]
    case $1 in
    gcc) gcc "${flags[@]}" -O2 -c -o /dev/null "$2" ;; # it sees some mistakes only as it optimises
    clang) clang "${flags[@]}" -fsyntax-only "$2" ;;
    format) clang-format --dry-run --Werror "$2" ;;
    tidy) clang-tidy --quiet "$2" -- "${flags[@]}" ;;
    windows) x86_64-w64-mingw32-gcc -D_UCRT "${windows[@]}" -O2 -c -o /dev/null "$2" ;;
    windows_tidy) clang-tidy --quiet "$2" -- --target=x86_64-w64-mingw32 "${windows[@]}" ;;
    cppcheck)
        # It reads no system header: a function of unknown type is no integer, and clang's analyzer
        # follows realloc where it does not.
        cppcheck --quiet --error-exitcode=1 --inline-suppr --std=c11 \
            --enable=warning,performance,portability --suppress=missingIncludeSystem \
            --suppress=CastIntegerToAddressAtReturn --suppress=memleak \
            -Icommon -DHAVE_GLFW -DHAVE_EGL -DHAVE_OSMESA "$2"
        ;;
    shellcheck) shellcheck -x "$2" ;;
    library) check_library "$2" ;;
    shader) check_shader "$2" ;;
    vertex) check_vertex "$2" ;;
    esac
}

if [ $# != 0 ]; then
    if ! output=$(one "$@" 2>&1); then
        printf '%s\n' "$output" "lint: $1 finds fault with ${2-the sources}"
        exit 1
    fi
    exit 0
fi

# ---- All of them ----

shopt -s nullglob
rm -rf "$glsl_folder"
mkdir -p "$glsl_folder"

list() {
    local file
    for file in $(find common chapters shaders tests docs -name '*.c' | sort); do
        # What is for Windows is read as such, where its headers are.
        case $file in */platform/windows*.c | *_windows.c)
            printf '%s\n' "cppcheck $file" "format $file"
            ! command -v x86_64-w64-mingw32-gcc >/dev/null || printf '%s\n' "windows $file" "windows_tidy $file"
            continue
            ;;
        esac
        printf '%s\n' "tidy $file" "gcc $file" "clang $file" "cppcheck $file" "format $file"
    done
    for file in $(find common shaders tests docs -name '*.h' | sort); do
        echo "format $file"
    done
    for file in shaders/*.glsl chapters/*.glsl; do
        echo "library $file"
    done
    for file in chapters/*.frag chapters/*/*.frag; do
        echo "shader $file"
    done
    echo 'vertex shaders/screen.vert'
    for file in .make/*.sh tests/*.sh .ci/run; do
        echo "shellcheck $file"
    done
}

list | xargs -P "$(getconf _NPROCESSORS_ONLN)" -L 1 .make/lint.sh || { echo 'lint: failed' >&2; exit 1; }
echo "lint: $(list | wc -l) checks, no fault found"

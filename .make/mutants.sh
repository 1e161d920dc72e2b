#!/bin/bash
# mutants.sh - `make mutants`: check that the tests notice mistakes. It makes random mutations of C and GLSL sources,
# runs the tests that cover each, and prints those that no test catches. A mutation that does not compile is replaced
# by another.
#
# Environment: FILES, the sources to mutate, by default all of common/**/*.c and shaders/*.glsl; COUNT, the number of
# mutations, 60 by default, half of them in each language; SEED, the seed of the random choice, 1 by default; PICTURES,
# the maximum number of pictures drawn for a mutation, 6 by default. Exit status: 0 if at least 95 % were caught; 1
# otherwise; 2 for wrong arguments.
set -u
export LP_NUM_THREADS=1
unset MAKEFLAGS MAKELEVEL
cd "$(dirname "$0")/.." || exit 1
. .make/names.sh
count=${COUNT:-60} seed=${SEED:-1}
project=$PWD
cpu_seconds=60 # for one run of a test; this also catches endless loops
separator=$'\037'

case $count in '' | *[!0-9]* | 0* | ?????*) fail 2 "COUNT=$count: must be a whole number from 1 to 9999" ;; esac
case $seed in *[!0-9]* | ?????????*) fail 2 "SEED=$seed: must be a whole number from 0 to 99999999" ;; esac
shader_files=() c_files=()
# shellcheck disable=SC2046,SC2086 # a list of words
set -- ${FILES:-$(find common -name '*.c' | sort) shaders/*.glsl}
for file; do
    [ -f "$file" ] || fail 2 "$file: no such file"
    case $file in
    shaders/*.glsl) shader_files+=("$file") ;;
    common/*.c) # a source that is not built on this system cannot be judged
        if [ -e "build/${file%.c}.o" ]; then
            c_files+=("$file")
        elif [ -n "${FILES:-}" ]; then
            fail 2 "$file: is not built on this system"
        fi ;;
    *) fail 2 "$file: must be a file common/**/*.c or shaders/*.glsl" ;;
    esac
done

scratch=$(mktemp -d "$PWD/build/mutants.XXXXXX") || exit 1
chmod 711 "$scratch" # some tests run as another user
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
copy=$scratch/copy

# Copy the project as hard links, and replace a line of one file. That file is first removed from the copy, because
# writing to a hard link would change the original.
open_copy() { # FILE LINE NEW
    rm -rf "$copy"
    mkdir -p "$copy/tests" "$copy/build/tests"
    cp -Rl Makefile chapters common shaders "$copy" && cp -Rl tests/* "$copy/tests" || exit 1
    rm "$copy/$1"
    LINE=$3 awk -v number="$2" 'NR == number { $0 = ENVIRON["LINE"] } { print }' "$1" >"$copy/$1"
}

# Run a test in ROOT, within the time limit.
limited() { # ROOT COMMAND...
    (
        cd "$1" && ulimit -S -t "$cpu_seconds"
        PROJECT_ROOT=$1 BUILD=$project/build TMPDIR=$scratch "${@:2}" </dev/null
    ) >"$scratch/log" 2>&1
}

# Determine once for each build of a test whether it passes without a mutation, and how long it takes.
mkdir -p build/mutants
usable() { # PROGRAM
    local times=build/mutants/${1//\//_} before after
    if [ ! "$times" -nt "build/tests/$1" ]; then
        before=${EPOCHREALTIME/./}
        if limited "$PWD" "$PWD/build/tests/$1"; then
            after=${EPOCHREALTIME/./}
            echo "$((after - before)) $1" >"$times"
        else
            echo "failed $1" >"$times"
            echo "make mutants: the suite $1 fails without a mutation, and is left out" >&2
        fi
    fi
    ! grep -q failed "$times"
}
cheapest_first() { # sort the usable programs on standard input by their times
    local program
    while read -r program; do
        usable "$program" && cat "build/mutants/${program//\//_}"
    done | sort -n | cut -d ' ' -f 2
}

# ---- Which tests cover a file ----

# Write a line 'FILE INCLUDED' for each shader and each file that it includes, directly or indirectly.
awk '/^ *#include "/ { split($0, word, "\""); n = split(word[2], part, "/"); includes[FILENAME] = includes[FILENAME] " " part[n] }
    FNR == 1 { n = split(FILENAME, part, "/"); if (!(part[n] in path)) path[part[n]] = FILENAME; files[++total] = FILENAME }
    function visit(top, file,    list, i, n) {
        n = split(includes[file], list, " ")
        for (i = 1; i <= n; i++)
            if (!seen[top, list[i]]++) {
                print top, path[list[i]]
                visit(top, path[list[i]])
            }
    }
    END { for (f = 1; f <= total; f++) visit(files[f], files[f]) }' \
    shaders/*.glsl chapters/*.frag chapters/*/*.frag tests/shaders/*.glsl tests/shaders/*.frag >"$scratch/includes"

# Choose pictures that use the shader: half from the chapter that introduced it, the rest spread over the others.
# For a file that draws a view, choose pictures of that view.
pictures_of() { # FILE
    awk -v file="$1" -v most="${PICTURES:-6}" 'NR == FNR { if ($2 == file) uses[$1]; next }
        /^#/ || NF < 2 { next }
        {
            shader = "chapters/" $1 ".frag"
            shows = 0
            for (i = 3; i < NF; i++) {
                if ($i == "-f") shader = $(i + 1)
                if ($i == "-v") shows = file ~ /(views|ramp|signs)[.]glsl$/ || file == "shaders/" $(i + 1) ".glsl"
            }
            if (!(shader in uses)) next
            if (first == "") first = $1
            name = $1 ($2 == "-" ? "" : "-" $2)
            if (shows) view[++views] = name; else if ($1 == first) near[++nears] = name; else far[++fars] = name
        }
        function spread(list, size, wanted,    i) {
            for (i = 0; i < wanted && i < size; i++) print list[int(i * size / (wanted < size ? wanted : size)) + 1]
        }
        END {
            if (views) { spread(view, views, most); exit }
            half = int((most + 1) / 2)
            close_by = fars < most - half ? most - fars : half
            if (close_by > nears) close_by = nears
            spread(near, nears, close_by); spread(far, fars, most - close_by)
        }' "$scratch/includes" tests/pictures/images.txt
}

shader_suites_of() { # FILE
    local suite
    # A suite names a shader by its path, or a chapter's shader by the chapter's stem.
    awk -v file="$1" '$2 == file && /^tests/ { print $1 }
        $2 == file && sub(/\.frag$/, "", $1) && sub(/^chapters\//, "", $1) && $1 !~ /\// { print "\"" $1 "\"" }' \
        "$scratch/includes" >"$scratch/frags"
    printf '\\"%s\\"\n' "${1##*/}" >>"$scratch/frags" # a suite may contain its shader as a string
    grep -l -F -f "$scratch/frags" tests/*/*.c | sed 's,^tests/lib/,tests/shaders/,' | sort -u | while read -r suite; do
        suite=${suite#tests/}
        [ ! -x "build/tests/${suite%.c}" ] || echo "${suite%.c}"
    done | cheapest_first
}

# Print the tests that include the module's header, and, for a module of common/window, the tests of the window. If no
# test includes that header, print those that include a header of the module's folder, or, if there are none, all.
c_suites_of() { # FILE
    local programs pattern
    programs=$(find build/tests -mindepth 2 -name '*.d' | while read -r d; do [ ! -x "${d%.d}" ] || echo "$d"; done)
    case $1 in common/window/*) printf '%s\n' build/tests/window/*.d ;; esac | sed 's,^build/tests/,,; s,\.d$,,' | cheapest_first
    for pattern in "${1%.c}.h" "${1%/*}/[a-z_]*.h" .; do
        # shellcheck disable=SC2086 # a list of words
        grep -l "[ /]*$pattern" $programs && break
    done | sed 's,^build/tests/,,; s,\.d$,,' | cheapest_first
}

# ---- Judge one mutation: prints caught, survived or refused ----

draw_judges() { # PROGRAM PICTURE...: judge by drawing the pictures in the copy
    local word
    printf "%s $copy\n" "${@:2}" >"$scratch/names"
    (ulimit -S -t $((cpu_seconds * 4)); "$1" <"$scratch/names" 2>"$scratch/log") | sed -E '/^(other|none)/q' >"$scratch/drawn"
    word=$(tail -n 1 "$scratch/drawn")
    case ${word%% *} in
    none) grep -qi 'error\|:[0-9]*:' "$scratch/log" && echo refused || echo caught ;;
    same) [ "$(grep -c . "$scratch/drawn")" -lt $(($# - 1)) ] && echo caught || echo survived ;;
    *) echo caught ;;
    esac
}

judge_shader() { # FILE
    local names verdict=survived suite
    read -r -d '' -a names < <(pictures_of "$1")
    [ ${#names[@]} = 0 ] || verdict=$(draw_judges build/tests/draw "${names[@]}")
    [ "$verdict" = survived ] || { echo "$verdict"; return; }
    for suite in $(shader_suites_of "$1"); do
        limited "$copy" "$PWD/build/tests/$suite" || { echo caught; return; }
    done
    echo survived
}

link_with() { # OBJECT PROGRAM: link the suite, with the mutated object before the archive that contains the original
    local words window=()
    read -r -a words <"$scratch/link"
    words=("${words[@]//unit\/camera/$2}")
    case $2 in window/*) window=(build/tests/lib/session.o build/tests/lib/user.o) ;; esac
    mkdir -p "$copy/build/tests/$(dirname "$2")"
    "${words[0]}" "$1" ${window[@]+"${window[@]}"} "${words[@]:1}" -o "$copy/build/tests/$2" >"$scratch/log" 2>&1
}

judge_c() { # FILE
    local words suite names
    read -r -a words <build/flags
    (cd "$copy" && "${words[@]}" -w -O0 -g0 -c -o "$scratch/mutant.o" "$1" >"$scratch/log" 2>&1) || { echo refused; return; }
    for suite in $(c_suites_of "$1"); do
        link_with "$scratch/mutant.o" "$suite" || { cp "$scratch/log" build/mutants/link.log; echo refused; return; }
        limited "$copy" "$copy/build/tests/$suite" || { echo caught; return; }
    done
    # The harness also draws the views, so compare some pictures of them.
    read -r -d '' -a names < <(pictures_of shaders/views.glsl)
    link_with "$scratch/mutant.o" tools/draw || { echo refused; return; }
    draw_judges "$copy/build/tests/tools/draw" "${names[@]}"
}

# ---- All mutations ----

make --no-print-directory -n V=1 -W build/tests/unit/camera.o build/tests/unit/camera | tail -n 1 >"$scratch/link"
caught=0 judged=0
judge_all() { # JUDGE COUNT FILE...
    local judge=$1 left=$2 file number old new verdict
    shift 2
    while [ "$left" -gt 0 ] && IFS=$separator read -r -u 3 file number old new; do
        open_copy "$file" "$number" "$new"
        verdict=$($judge "$file")
        [ "$verdict" != refused ] || continue
        left=$((left - 1)) judged=$((judged + 1))
        if [ "$verdict" = caught ]; then
            caught=$((caught + 1))
        else
            echo "$file:$number: survived"
            printf '    %s\n -> %s\n' "${old#"${old%%[! ]*}"}" "${new#"${new%%[! ]*}"}"
        fi
    done 3< <(awk -v seed="$seed" -v count=$((left * 10)) -f .make/mutate.awk "$@")
}
in_shaders=$((count / 2))
[ ${#c_files[@]} -gt 0 ] || in_shaders=$count
[ ${#shader_files[@]} -gt 0 ] || in_shaders=0
[ "$in_shaders" = 0 ] || judge_all judge_shader "$in_shaders" "${shader_files[@]}"
[ "$in_shaders" = "$count" ] || judge_all judge_c $((count - in_shaders)) "${c_files[@]}"
echo "$caught of $judged mutations caught"
[ "$judged" -gt 0 ] && [ $((caught * 100)) -ge $((judged * 95)) ]

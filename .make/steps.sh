#!/bin/sh
# steps.sh - `make benchmark STEPS=1`: for each chapter that marches its scene with march or marchCone, measure the
# scene with the methods of chapter 16, one by one and together. The table has the evaluations per pixel, march / bound
# (defined in docs/benchmark.md), and the time of a frame relative to the chapter itself. If there is an experiment
# 16_frame_NN, its frame is measured too.
#
# Environment: CHAPTER, a single chapter to measure; ROUNDS, the number of measurements, and FRAMES, the number of
# frames in each; WRITE=1, to write the table of all chapters to docs/benchmark.md.
set -u
. .make/write.sh
. .make/chapters.sh

rounds=${ROUNDS:-3}
frames=${FRAMES:-9}
means=chapters/experiments/16_means.glsl
scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-benchmark.XXXXXX") || exit 1

# Print the largest threshold of the first march as a GLSL expression, or nothing for a chapter that does not march its
# scene with march or marchCone.
margin() {
    case $1 in
    01* | 02* | 03* | 04* | 05* | 08*) echo hitThreshold ;;
    06*) echo 'hitThreshold + footprint * pixelSpread() * t' ;;
    07*) echo 'hitThreshold + 0.25 * pixelSpread() * t' ;;
    09*) echo 'hitThreshold + 0.5 * footprint * pixelSpread() * t' ;;
    11* | 12* | 13*) echo 'hitThreshold + pixelSpread() * t' ;;
    esac
}

# Print the name of a file that draws the chapter's scene with the methods of chapter 16: the experiment 16_scene_NN if
# there is one, otherwise a new file.
scene() { # STEM
    own=chapters/experiments/16_scene_${1%%_*}.frag
    if [ -e "$own" ]; then
        echo "$own"
        return
    fi
    {
        echo '#include "main.glsl"'
        cat "$means"
        printf '#include "%s.frag"\nfloat coarseMargin(float t)\n{\n    return %s;\n}\n' "$1" "$(margin "$1")"
    } >"$scratch/means_$1.frag"
    echo "$scratch/means_$1.frag"
}

# Print the name of a file that draws the scene of FILE without the longer steps of marchRelaxed, using the loop of
# marchCone, which computes less in each step.
plain() { # STEM FILE
    case $2 in "$scratch"/*) included=${2##*/} ;; *) included=${2#chapters/} ;; esac
    {
        printf '#include "main.glsl"\n#include "cone.glsl"\n#include "relaxed.glsl"\n'
        echo '#define marchRelaxed(ray, from, to, threshold, spread, omega, steps) marchCone(ray, from, to, threshold, spread, steps)'
        printf '#include "%s"\n' "$included"
    } >"$scratch/plain_$1.frag"
    echo "$scratch/plain_$1.frag"
}

value() { sed -n "s/^  \"$1\": \"\{0,1\}\(.*[^\",]\)\"\{0,1\},\{0,1\}\$/\1/p"; }
middle() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

measure() { # NAME PROGRAM OPTION...
    name=$1
    shift
    "$@" --benchmark "$frames" --benchmark=json -s 640x360 -t 1 >"$scratch/$name" || exit 1
}

# Measure a chapter as it is and then with some of the methods, so that whatever slows down the machine affects both
# measurements.
compared() { # STEM KIND FILE OPTION...
    stem=$1 kind=$2 file=$3
    shift 3
    if [ "$stem" = 16_fewer_steps ]; then
        measure "$stem.was" "build/$stem" -p divider=1 -p coarsePass=false
        measure "$stem.$kind" "build/$stem" -p divider=0 "$@"
    else
        measure "$stem.was" "build/$stem"
        measure "$stem.$kind" "build/$stem" -f "$file" "$@"
    fi
    awk "BEGIN { print $(value frame_minimum_cpu_ms <"$scratch/$stem.$kind") / $(value frame_minimum_cpu_ms <"$scratch/$stem.was") }" \
        >>"$scratch/$stem.$kind.share"
}

if [ -n "${CHAPTER-}" ]; then list=$(stem_of "$CHAPTER") || exit 1; else list=$(stems); fi
marched=
for stem in $list; do
    if [ "$stem" = 16_fewer_steps ] || [ -n "$(margin "$stem")" ]; then marched="$marched $stem"; fi
done
[ -n "$marched" ] || fail 1 "STEPS=1: the chapter $list does not use march or marchCone"
for round in $(seq "$rounds"); do
    for stem in $marched; do
        [ -t 2 ] && printf '%s, round %d of %d        \r' "$stem" "$round" "$rounds" >&2
        all=
        plain=
        rest=
        frame=chapters/experiments/16_frame_${stem%%_*}.frag
        [ "$stem" = 16_fewer_steps ] || { all=$(scene "$stem") && plain=$(plain "$stem" "$all"); }
        case $stem in
        16*) rest='-p boxes=false -p along=false -p footprint=0 -p omega=1' ;;
        *) [ -z "$all" ] || grep -q 'uniform bool own;' "$all" && rest='-p own=false' ;;
        esac
        # shellcheck disable=SC2086
        compared "$stem" relaxed "$all" -p coarsePass=false ${rest% -p omega=1}
        # shellcheck disable=SC2086
        compared "$stem" coarse "$plain" $rest
        compared "$stem" all "$all"
        [ ! -e "$frame" ] || compared "$stem" frame "$frame"
    done
done
[ -t 2 ] && printf '%40s\r' '' >&2

cell() { # STEM KIND
    [ -e "$scratch/$1.$2" ] || { printf -- '-'; return; }
    share=1
    [ "$2" = was ] || share=$(middle <"$scratch/$1.$2.share" | awk '{ printf "%.2f", $1 }')
    printf '%s, %s, %s' "$(value evaluations_mean <"$scratch/$1.$2" | awk '{ printf "%.1f", $1 }')" \
        "$(value march_over_bound <"$scratch/$1.$2" | awk '{ printf "%.2f", $1 }')" \
        "$share"
}
{
    echo "$(value backend <"$scratch/${marched##* }.was"); 640x360, $rounds rounds of $frames frames"
    echo
    echo '| chapter | as it is | relaxed | coarse pass | all | frame |'
    echo '| --- | --- | --- | --- | --- | --- |'
    for stem in $marched; do
        echo "| $stem | $(cell "$stem" was) | $(cell "$stem" relaxed) | $(cell "$stem" coarse) | $(cell "$stem" all) | $(cell "$stem" frame) |"
    done
} >"$scratch/table"
cat "$scratch/table"

if [ "${WRITE:-0}" != 0 ] && [ -z "${CHAPTER-}" ]; then
    write_table steps "$scratch/table"
fi

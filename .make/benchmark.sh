#!/bin/sh
# benchmark.sh - `make benchmark`: print the cost of each chapter at 640x360, in milliseconds and relative to
# tests/pictures/reference_scene.frag, and compare it with the table in docs/benchmark.md.
#
# Environment: CHAPTER, a single chapter to measure; ROUNDS, the number of measurements, and FRAMES, the number of
# frames in each; WRITE=1, to write the table to docs/benchmark.md. With STEPS=1, steps.sh prints its table instead;
# with MARCHES=1, marches.sh does.
set -u
. .make/write.sh
. .make/chapters.sh

[ -z "${STEPS-}" ] || exec .make/steps.sh
[ -z "${MARCHES-}" ] || exec .make/marches.sh
page=docs/benchmark.md
rounds=${ROUNDS:-3}
case $rounds in '' | *[!0-9]* | 0*) fail 2 "ROUNDS=$rounds: must be a whole number of at least 1" ;; esac
frames=${FRAMES:-15}
if [ -n "${CHAPTER-}" ] && [ "${WRITE:-0}" != 0 ]; then
    fail 1 'WRITE=1 writes the table of all chapters and cannot be combined with CHAPTER'
fi
if [ -n "${CHAPTER-}" ]; then stems=$(stem_of "$CHAPTER") || exit 1; else stems=$(stems); fi
scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-benchmark.XXXXXX") || exit 1

# Print the value of a name in the JSON on standard input.
value() { sed -n "s/^  \"$1\": \"\{0,1\}\(.*[^\",]\)\"\{0,1\},\{0,1\}\$/\1/p"; }
# Print the median of the numbers on standard input.
middle() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

measure() { # FILE PROGRAM OPTION...
    to=$1
    shift
    "$@" --benchmark "$frames" --benchmark=json -s 640x360 -t 1 >"$to" || exit 1
}

# In every round the reference scene is measured before each chapter, so that whatever slows down the machine affects
# both.
for round in $(seq "$rounds"); do
    for stem in $stems; do
        [ -t 2 ] && printf '%s, round %d of %d        \r' "$stem" "$round" "$rounds" >&2
        measure "$scratch/unit" build/00_first_scene --shader tests/pictures/reference_scene.frag
        measure "$scratch/$stem.$round" "build/$stem"
        # Use the graphics card's own clock if there is one, otherwise the processor time.
        clock=gpu
        [ "$(value frame_median_gpu_ms <"$scratch/unit")" = null ] && clock=cpu
        unit=$(value frame_median_${clock}_ms <"$scratch/unit")
        frame=$(value frame_median_${clock}_ms <"$scratch/$stem.$round")
        awk "BEGIN { print $frame / $unit }" >>"$scratch/$stem.ratio"
        echo "$frame" >>"$scratch/$stem.frame"
        value frame_median_wall_ms <"$scratch/$stem.$round" >>"$scratch/$stem.wall"
        awk "BEGIN { print $(value compile_cpu_ms <"$scratch/$stem.$round") + $(value first_frame_cpu_ms <"$scratch/$stem.$round") }" \
            >>"$scratch/$stem.cold"
        value backend <"$scratch/unit" >"$scratch/backend"
    done
done
[ -t 2 ] && printf '%40s\r' '' >&2

# ---- The table ----

whole() { sed 's/^null$/-/' | awk '{ print ($1 == "-" ? "-" : sprintf("%.0f", $1)) }'; }
tenth() { sed 's/^null$/-/' | awk '{ print ($1 == "-" ? "-" : sprintf("%.1f", $1)) }'; }
hundredth() { sed 's/^null$/-/' | awk '{ print ($1 == "-" ? "-" : sprintf("%.2f", $1)) }'; }
{
    echo "$(cat "$scratch/backend"); 640x360, $rounds rounds of $frames frames"
    echo
    echo '| chapter | frame, units | frame, ms | frame, wall ms | cold start, ms | evaluations, mean | 99 % | most | march / bound |'
    echo '| --- | --- | --- | --- | --- | --- | --- | --- | --- |'
    for stem in $stems; do
        last=$scratch/$stem.$rounds
        printf '| %s | %.2f | %.1f | %.1f | %.0f | %s | %s | %s | %s |\n' "$stem" \
            "$(middle <"$scratch/$stem.ratio")" "$(middle <"$scratch/$stem.frame")" \
            "$(middle <"$scratch/$stem.wall")" "$(middle <"$scratch/$stem.cold")" \
            "$(value evaluations_mean <"$last" | tenth)" "$(value evaluations_p99 <"$last" | whole)" \
            "$(value evaluations_maximum <"$last" | whole)" "$(value march_over_bound <"$last" | hundredth)"
    done
} >"$scratch/table"
cat "$scratch/table"
echo

# ---- Compare with the last table ----

# The table in the page is between two markers.
awk '/^<!-- \/benchmark -->/ { p = 0 } p { print } /^<!-- benchmark -->/ { p = 1 }' "$page" >"$scratch/old"
old_backend=$(sed -n '/;/ { s/;.*//; p; q; }' "$scratch/old")
if [ -z "$old_backend" ]; then
    echo "$page has no table yet: WRITE=1 writes one."
elif [ "$old_backend" != "$(cat "$scratch/backend")" ]; then
    echo "The table in $page was measured with another renderer ($old_backend), so it is not compared with this one."
else
    for stem in $stems; do
        before=$(sed -n "s/^| $stem | \([0-9.]*\) .*/\1/p" "$scratch/old")
        now=$(middle <"$scratch/$stem.ratio")
        awk -v stem="$stem" -v before="$before" -v now="$now" -v page="$page" 'BEGIN {
            if (before == "") printf "%-28s %6.2f units, not in %s yet\n", stem, now, page
            else printf "%-28s %6.2f units, %6.2f in %s: %+.0f %%\n", stem, now, before, page, 100 * (now / before - 1) }'
    done
fi

if [ "${WRITE:-0}" != 0 ]; then
    write_table benchmark "$scratch/table"
fi

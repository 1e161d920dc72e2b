#!/bin/bash
# benchmark.sh - tests that the figures of --benchmark are consistent with each other, and that it counts the same
# evaluations as --probe. It also tests make benchmark and the tables of docs/benchmark.md.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/03_shadows

run() { "$program" "$@" >"$scratch/out" 2>"$scratch/err"; }
value() { sed -n "s/^  \"$1\": \(.*[^,]\),\{0,1\}\$/\1/p" "$scratch/out"; }
# holds EXPRESSION: true if this awk expression is true.
holds() { awk "BEGIN { exit !($1) }" || { echo "# false: $1"; return 1; }; }

text() { run --benchmark 5 -s 64x36 -t 2 && [ ! -s "$scratch/err" ] && grep -q '^picture  *64x36, time 2 s.* frames: 5$' "$scratch/out"; }
check 'a benchmark prints aligned text' text # tests/unit/numbers.c tests the lines of this text
json() { run --benchmark 7 --benchmark=json -s 48x27 && [ ! -s "$scratch/err" ] && [ "$(value frames)" = 7 ] && [ "$(value frame_median_gpu_ms)" = null ]; }
check 'the JSON output gives the number of frames' json
if command -v python3 >/dev/null; then
    valid() { python3 -c 'import json, sys; json.load(sys.stdin)' <"$scratch/out"; }
    check 'the output of --benchmark=json is valid JSON' valid
fi
ordered() {
    local clock
    for clock in cpu wall; do
        holds "$(value frame_minimum_${clock}_ms) > 0 && $(value frame_minimum_${clock}_ms) <= $(value frame_median_${clock}_ms) && $(value frame_median_${clock}_ms) <= $(value frame_maximum_${clock}_ms)" || return 1
    done
}
check 'the minimum, median and maximum of the frame times are in order' ordered
cold() { holds "$(value compile_cpu_ms) > 1 && $(value first_frame_cpu_ms) > 3 * $(value frame_median_cpu_ms)"; }
check 'compilation takes more than 1 ms, and the first frame takes longer than three median frames' cold
caches() { find "$scratch/cache" -type f -size +0 2>/dev/null | grep -q .; }
uncached() {
    mkdir "$scratch/cache" && MESA_SHADER_CACHE_DIR=$scratch/cache run --benchmark 1 -s 48x27 && ! caches
}
check "the driver's shader cache is off for a benchmark" uncached
cached() { MESA_SHADER_CACHE_DIR=$scratch/cache run -s 48x27 -o "$scratch/x.png" && caches; }
check "the driver's shader cache is on for a picture" cached

# Benchmark a small picture, and probe each of its pixels.
counted() {
    local x y
    run --benchmark=json -s 6x4 || return 1
    for x in 0 1 2 3 4 5; do
        for y in 0 1 2 3; do
            "$program" -s 6x4 --probe $x,$y | sed -n 's/.*evaluations of the scene: \([0-9]*\).*/\1/p'
        done
    done | sort -n >"$scratch/probes"
    [ "$(wc -l <"$scratch/probes")" = 24 ] && holds "$(value evaluations_maximum) == $(tail -n 1 "$scratch/probes")" &&
        holds "$(value evaluations_p99) == $(sed -n 24p "$scratch/probes")" &&
        holds "($(value evaluations_mean) - $(awk '{ s += $1 } END { print s / NR }' "$scratch/probes")) ^ 2 < 1e-4"
}
check 'the mean, the 99th percentile and the maximum of the evaluations are those of the probes' counted
# A shader whose pixels evaluate the distance 0, 1, 2, ..., 199 times.
cat >"$scratch/count.frag" <<'GLSL'
#include "main.glsl"
Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, 1.0)); }
float sceneDistance(vec3 p) { return 1.0; }
vec3 rayColour(Ray ray)
{
    int count = int(gl_FragCoord.x) + 20 * int(gl_FragCoord.y);
    float sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += distanceAt(ray.origin);
    return vec3(sum);
}
GLSL
percent() {
    run --benchmark=json -s 20x10 -f "$scratch/count.frag" && [ "$(value evaluations_mean)" = 99.5000 ] &&
        [ "$(value evaluations_p99)" = 197 ] && [ "$(value evaluations_maximum)" = 199 ]
}
check 'the mean, the 99th percentile and the maximum of known counts are right' percent
# ---- Marches compared with the fewest evaluations that would be enough ----

bound() {
    run --benchmark 1 --benchmark=json -s 320x180 && holds "$(value march_rays) > 100 && $(value march_rays) < 576" &&
        holds "$(value march_over_bound_minimum) >= 1 && $(value march_over_bound) > 1.3" &&
        holds "($(value march_evaluations) / $(value march_bound) - $(value march_over_bound)) ^ 2 < 1e-6"
}
check 'no march takes fewer evaluations than the bound' bound
# The rays leave a plane perpendicularly, and start 1 above it. Of the 576 rays that are examined, the 288 in the left
# half take steps of 1, 2, 4 and 8 to the end at 15, 144 take one step of 1 to the end at 1, and 144 do not march. One
# evaluation would be enough, because t - d is -1 everywhere on a ray, where d is the distance at t.
cat >"$scratch/leave.frag" <<'GLSL'
#include "main.glsl"
#include "march.glsl"
Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 1.0), vec3(0.0, 0.0, 1.0)); }
float sceneDistance(vec3 p) { return p.z; }
vec3 rayColour(Ray ray)
{
    float x = ray.origin.x;
    return vec3(march(ray, 0.0, x < 0.0 ? 15.0 : x < 0.9 ? 1.0 : 0.0, 0.001, 99).t + distanceAt(ray.origin));
}
GLSL
known() {
    run --benchmark 1 --benchmark=json -s 64x36 -f "$scratch/leave.frag" && [ "$(value march_rays)" = 432 ] &&
        [ "$(value march_evaluations)" = 3.0000 ] && [ "$(value march_bound)" = 1.0000 ] &&
        [ "$(value march_over_bound_minimum)" = 1.0000 ]
}
check 'a known march is counted, and rays that do not march are left out' known
# Parallel rays meet a plane perpendicularly at a distance of 10, so a march takes 2 evaluations. The picture has two
# blocks of pixels, and the march of each block's cylinder also takes 2. These 4 evaluations are shared among 128
# pixels, in the mean and in the evaluations of the march. The bound is that of single rays.
cat >"$scratch/shared.frag" <<'GLSL'
#include "main.glsl"
#include "march.glsl"
#include "coarse.glsl"
Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 10.0), vec3(0.0, 0.0, -1.0)); }
float sceneDistance(vec3 p) { return p.z; }
float coarseMargin(float t) { return 0.001; }
vec3 rayColour(Ray ray) { return vec3(march(ray, coarseStart(ray), 20.0, 0.001, 99).t); }
GLSL
shared() {
    run --benchmark 1 --benchmark=json -s 16x8 -f "$scratch/shared.frag" && [ "$(value evaluations_mean)" = 2.0312 ] &&
        [ "$(value evaluations_maximum)" = 2 ] && [ "$(value march_evaluations)" = 2.0312 ] && [ "$(value march_bound)" = 2.0000 ] &&
        run --benchmark 1 --benchmark=json -s 16x8 -f "$scratch/shared.frag" -p coarsePass=false && [ "$(value evaluations_mean)" = 2.0000 ] &&
        [ "$(value march_evaluations)" = 2.0000 ]
}
check "the cost of the coarse pass is shared among the pixels" shared
unmarched() {
    run --benchmark 1 --benchmark=json -s 20x10 -f "$scratch/count.frag" && [ "$(value march_rays)" = 0 ] && [ "$(value march_over_bound)" = null ] &&
        run --benchmark 1 -s 20x10 -f "$scratch/count.frag" && ! grep -q '^march' "$scratch/out"
}
check 'without a march there is no bound' unmarched
whole() { run --benchmark 2 -f tests/pictures/reference_scene.frag -s 32x18 && grep -q "counted only in the course's dialect" "$scratch/out" &&
    run --benchmark 2 --benchmark=json -f tests/pictures/reference_scene.frag -s 32x18 && [ "$(value evaluations_mean)" = null ] &&
    [ "$(value march_over_bound)" = null ]; }
check 'no evaluations are counted in a file with its own main' whole
set_ones() { run --benchmark=json -s 32x18 -p maxSteps=3 && holds "$(value evaluations_maximum) < 30"; }
check 'parameters take effect in a benchmark' set_ones

# ---- make benchmark ----

table() {
    ROUNDS=1 FRAMES=2 CHAPTER=00 .make/benchmark.sh >"$scratch/out" 2>"$scratch/err" && [ ! -s "$scratch/err" ] &&
        grep -qE '^\| 00_first_scene \| [0-9]\.[0-9]{2} \| [0-9.]+ \| [0-9.]+ \| [0-9]+ \| - \| - \| - \| - \|$' "$scratch/out" &&
        grep -qE '^00_first_scene .*units|not compared' "$scratch/out"
}
check 'make benchmark prints a table and a comparison' table
committed() {
    local stem
    for stem in chapters/[0-9][0-9]_*.c; do
        grep -qE "^\| $(basename "$stem" .c)( \| [0-9.]+){4}( \| [0-9.]+| \| -){4} \|$" docs/benchmark.md || { echo "# a row is missing: run make benchmark WRITE=1"; return 1; }
    done
}
check 'docs/benchmark.md has a row for every chapter' committed
marched() {
    local scene cell='[0-9.]+, ([0-9.]+|-), [0-9.]+' errors='[0-9.]+, [0-9]+, [0-9]+'
    for scene in 03 06 07 09 16 21 22 torus plane 'hollow cube' plates; do
        if ! grep -qE "^\| $scene \|( $cell \|| - \|){7}$" docs/benchmark.md ||
            ! grep -qE "^\| $scene \|( $errors \|| - \|){7}$" docs/benchmark.md; then
            echo "# the rows of $scene are missing: run make benchmark MARCHES=1 WRITE=1"
            return 1
        fi
    done
}
check 'docs/benchmark.md has both rows of every scene that is marched' marched
refused() { # without WRITE, so that a failure harms no page
    local rounds
    for rounds in 0 -1 x nan; do
        ROUNDS=$rounds CHAPTER=00 .make/benchmark.sh >"$scratch/out" 2>"$scratch/err"
        [ $? = 2 ] && [ ! -s "$scratch/out" ] && [ "$(grep -c '' "$scratch/err")" = 1 ] && grep -q "ROUNDS=$rounds: must be" "$scratch/err" || return
    done
}
check 'make benchmark of no rounds is refused, in one line' refused

plan

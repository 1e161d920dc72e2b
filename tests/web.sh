#!/bin/bash
# web.sh [PART [PATTERN]] - `make test-web`: the tests of the programs and of the site in browsers, tests/web_PART.mjs, in
# Chromium and in Firefox, without a screen. PATTERN picks pictures of tests/images.txt, pages, chapters or mistakes. A
# part also says what time of processors it took, which says more where other programs run.
set -u
export LC_ALL=C
cd "$(dirname "$0")/.." || exit 1
export MESA_SHADER_CACHE_DIR=$PWD/build/shader-cache LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
results=build/web-test
mkdir -p "$results"

# Firefox gives WebGL only where there is a display.
run_part() {
    local with=()
    [ "$1" != firefox ] || with=(xvfb-run -a -s '-screen 0 1000x800x24 -noreset')
    "${with[@]}" node "tests/web_$1.mjs" "$2" >"$results/$1.tap" 2>"$results/$1.err"
}

passed=0 failed=0
for part in ${1:-teeth program pictures firefox swiftshader speed pages look live chapter play checks twice}; do
    begun=$SECONDS
    pattern=${2-}
    # Two more sites take as long as building two: that is left to continuous integration. To plant every mistake takes
    # a quarter of an hour of a processor, so here, and there, each only has to find its place: who changes what runs in
    # the browser, or tests it, names the part.
    [ "$part" != twice ] || [ -n "${1-}${CI-}" ] || continue
    [ "$part" != teeth ] || [ -n "${1-}" ] || pattern='find'
    run_part "$part" "$pattern"
    status=$?
    right=$(grep -c '^ok ' "$results/$part.tap")
    wrong=$(grep -c '^not ok ' "$results/$part.tap")
    # Without its plan a part has died on the way.
    if [ "$wrong" = 0 ] && { [ "$status" != 0 ] || ! grep -q "^1\\.\\.$right\$" "$results/$part.tap"; }; then
        wrong=1
    fi
    echo "web_$part: $right passed, $wrong failed, $((SECONDS - begun)) s"
    grep '^#' "$results/$part.tap" | sed 's/^/    /'
    [ "$wrong" = 0 ] || { grep '^not ok ' "$results/$part.tap"; head -n 20 "$results/$part.err"; } | sed 's/^/    /'
    passed=$((passed + right)) failed=$((failed + wrong))
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]

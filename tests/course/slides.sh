#!/bin/bash
# slides.sh - tests `make slides` and `make handouts`: the number of their pages, and the text on them.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

for tool in pandoc xelatex pdfinfo pdftotext; do
    if ! command -v $tool >/dev/null; then
        skip 'slides and handouts' "this machine has no $tool: make slides installs it"
        plan
        exit
    fi
done
open_scratch

pages() { pdfinfo "build/$1.pdf" | awk '/^Pages/ { print $2 }'; }
text() { pdftotext -layout "build/$1.pdf" - | tr -s ' \n\f' ' '; }
has() { text "$1" | grep -qF -e "$2"; }

# ---- Slides ----

typeset() { LIST=$1 .make/slides.sh >"$scratch/out" 2>"$scratch/err"; }
# shellcheck disable=SC2016 # special characters
printf '== A_part & more\n01 --set focalLength=3\n   100 %% of $x_1$ * [y](z) \\n #1 ~ <b>\n' >"$scratch/signs.txt"
check 'a sentence with special characters is typeset' typeset "$scratch/signs.txt"
# shellcheck disable=SC2016 # special characters
check 'all special characters are printed unchanged' has slides '100 % of $x_1$ * [y](z) \n #1 ~ <b>'
refused() {
    printf '01\n33\n' >"$scratch/bad.txt"
    ! typeset "$scratch/bad.txt" && [ "$(cat "$scratch/err")" = "$(build/lecture "$scratch/bad.txt" 2>&1)" ]
}
check 'a bad list is refused with the message of make lecture' refused

check 'the slides are typeset' typeset docs/lecture.txt || sed 's/^/# /' "$scratch/err"
scenes=$(grep -c '^[0-9]' docs/lecture.txt)
check 'each scene has a slide, after the title slide' [ "$(pages slides)" = $((scenes + 1)) ]
check 'there are 15 to 20 slides' [ $((scenes + 1)) -ge 15 -a $((scenes + 1)) -le 20 ]
sentences() { # true if each sentence of the list is unchanged on the slides
    local missing
    [ "$(build/lecture --print docs/lecture.txt | wc -l)" = "$scenes" ] || return
    missing=$(build/lecture --print docs/lecture.txt | cut -d "$(printf '\037')" -f 5 | while read -r sentence; do
        has slides "$sentence" || echo "$sentence"
    done)
    [ -z "$missing" ] || { echo "# ${missing//$'\n'/; }" && return 1; }
}
check 'every sentence is on a slide' sentences

# ---- Handouts ----

check 'the handouts are typeset' eval ".make/handouts.sh >'$scratch/out' 2>'$scratch/err'" || sed 's/^/# /' "$scratch/err"
labs=$(grep -cE '^### (Lab [0-9]+|A lab in C):' docs/teaching.md)
check 'the guide for teachers has at least 19 labs' [ "$labs" -ge 19 ]
check 'each lab has two pages in the handouts' [ "$(pages handouts)" = $((2 * labs)) ]
check 'each lab has a page with its answers' [ "$(pages handouts-answers)" = "$labs" ]
apart() { # true if the handouts have a question of each kind, and only the answer sheets have the answers
    has handouts 'How many reflections draw 4,096 tetrahedra?' && has handouts-answers 'three for each of six levels' &&
        ! has handouts 'three for each of six levels' && has handouts 'Does the ball cast a shadow on the wall?' &&
        has handouts-answers 'it hits the ball behind the lamp' && ! has handouts 'it hits the ball behind the lamp'
}
check 'the answers are on separate sheets' apart
check 'an exercise has a command that checks the answer' has handouts 'make check EXERCISE=03_2 FILE=my.frag'
plan

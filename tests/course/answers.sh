#!/bin/bash
# answers.sh [EXERCISE...] - tests that `make check` cannot be fooled. The check must refuse each wrong answer in
# tests/course/answers.txt because the answer differs, and accept each right one and the solution itself. It must also
# refuse the unsolved chapter or engine, for whatever reason. With arguments, such as 03_2, only those exercises are
# tested.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

# field LINE N: prints the Nth field, without surrounding blanks.
field() {
    printf '%s\n' "$1" | awk -F ' +[|] +' -v n="$2" '{ print $n }'
}

# Write the answers to one exercise as files in a folder, check them all together, and print a line for each: 'ok NAME'
# or 'not ok NAME'.
judge() { # EXERCISE
    local folder=$scratch/$1 solution number=0 line verdict what file table type=frag
    [[ $1 == [0-9]* ]] || type=c
    mkdir "$folder"
    solution=$folder/solution.$type
    if [ $type = c ]; then
        patch -s -o "$solution" chapters/first_steps/engine_6.c "chapters/solutions/$1.diff"
        cp chapters/first_steps/engine_6.c "$folder/unsolved.c"
    else
        cp chapters/solutions/"${1%_*}"_*_"${1#*_}".frag "$solution"
        cp chapters/"${1%_*}"_*.frag "$folder/unsolved.frag"
    fi
    printf '%s\n' "right|the solution itself|solution.$type" "wrong|the unsolved chapter|unsolved.$type" >"$folder/list"
    grep "^$1 " "$scratch/answers" | while read -r line; do
        number=$((number + 1))
        sed "${line#*|*|*| }" "$solution" >"$folder/$number.$type"
        ! cmp -s "$solution" "$folder/$number.$type" || echo 'changes nothing' >"$folder/$number.why"
        printf '%s|%s|%s\n' "$(field "$line" 2)" "$(field "$line" 3)" "$number.$type" >>"$folder/list"
    done
    CHECK_FOLDER=$folder/check EXERCISE=$1 FILE='' FILES="$folder/*.$type" .make/check.sh >"$folder/table" 2>&1
    while IFS='|' read -r verdict what file; do
        table=$(grep "/$file " "$folder/table" | sed "s/[.]$type  */.$type /")
        [ ! -e "$folder/${file%.*}.why" ] || table="the edit changes nothing in $solution"
        case $file,$table in
        unsolved.*,wrong*) echo "ok $1: $what is refused: ${table#*."$type" }" && continue ;;
        *'does not run'* | *'does not compile'*) ;;
        "$file,$verdict "*) echo "ok $1: $what: ${table#*."$type" }" && continue ;;
        esac
        echo "not ok $1: $what is not judged to be $verdict: ${table:-$(head -n 1 "$folder/table")}"
    done <"$folder/list"
    [ "$(grep -c '^wrong|' "$folder/list")" -ge 3 ] || echo "not ok $1: needs at least two wrong answers, apart from the unsolved chapter"
}

if [ "${1-}" = --exercise ]; then # called by xargs below
    scratch=$2
    judge "$3"
    exit 0
fi

open_scratch
sed 's/[[:space:]]*$//' tests/course/answers.txt | grep -v '^\(#\|$\)' >"$scratch/answers"
for file in chapters/solutions/*.{frag,diff}; do
    name=${file##*/}
    number=${name##*_}
    echo "${name%%_*}_${number%.*}"
done | while read -r exercise; do
    for wanted in "${@:-$exercise}"; do
        [ "$wanted" != "$exercise" ] || echo "$exercise"
    done
done >"$scratch/exercises"
cut -d ' ' -f 1 "$scratch/answers" | sort -u | comm -23 - <(cut -d ' ' -f 1 "$scratch/exercises" | sort) >"$scratch/unknown"
[ $# != 0 ] || check 'tests/course/answers.txt names only exercises that have a solution' [ ! -s "$scratch/unknown" ]
while read -r line; do
    case $line in
    ok*) ok "${line#ok }" ;;
    *) not_ok "${line#not ok }" ;;
    esac
done < <(LP_NUM_THREADS=1 xargs -P 2 -n 1 "$0" --exercise "$scratch" <"$scratch/exercises")
check 'at least one exercise is tested' [ "$tap_count" -gt 1 ]
plan

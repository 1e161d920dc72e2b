# shellcheck shell=bash
# support_teeth.sh - planted mistakes, for the suites that ask whether the tests would notice. Sourced
# behind support.sh, by a script that plants mistakes number N... when it is called as --plant SCRATCH N...

# field LINE N: the Nth field, without the blanks around it.
field() {
    printf '%s\n' "$1" | awk -F ' +[|] +' -v n="$2" '{ print $n }'
}

# The lines of a list, without comments.
mistakes_of() { # FILE
    sed 's/[[:space:]]*$//' "$1" | grep -v '^\(#\|$\)'
}

# places LIST: the suite of a run of all suites, which leaves the planting to CI: a mistake that no longer finds its
# place is seen at once.
left_to_ci() { [ -n "${ALL_SUITES-}" ] && [ -z "${CI-}" ]; }
places() {
    mistakes_of "$1" >"$scratch/all"
    check 'each planted mistake finds its place' each_finds
    plan
}
each_finds() {
    local line rest file found=0
    while read -r line; do
        rest=${line#* | } rest=${rest#* | } # FILES | EDIT
        for file in ${rest%% | *}; do
            if [ ! -e "$file" ] || sed "${rest#* | }" "$file" | cmp -s - "$file"; then
                echo "# ${line%% | *}: '${rest#* | }' changes nothing in $file"
                found=1
            fi
        done
    done <"$scratch/all"
    return "$found"
}

# A copy of $scratch/right with the mistake in it; prints why there is none. The copy is one of links: a
# file is taken out of it before it is written.
edit_copy() { # COPY FILES EDIT
    local file
    mkdir "$1" && { cp -Rl "$scratch/right/." "$1" 2>/dev/null || cp -Rp "$scratch/right/." "$1"; } || return
    for file in $2; do
        if [ ! -e "$file" ]; then
            echo "there is no $file"
            continue
        fi
        rm "$1/$file"
        if ! sed "$3" "$file" >"$1/$file" || cmp -s "$file" "$1/$file"; then
            echo "'$3' changes nothing in $file"
        fi
    done
}

# Run the test 'PROGRAM [TEST]' of FOLDER on the copy; the program need not go on when it has failed. What it leaves
# goes with the copy. Prints 'fails in NAMES', 'ends with status N', 'passes' or 'is no test'.
try_test() { # 'PROGRAM [TEST]' COPY FOLDER
    local program=${1%% *} only=()
    [ "$program" = "$1" ] || only=("ONE_TEST=${1#* }")
    (
        ulimit -S -t 120 # a mistake may hang it: seconds of the processor, which a busy machine does not shorten
        env ${only[@]+"${only[@]}"} PROJECT_ROOT="$2" TMPDIR="$2" CMOCKA_MESSAGE_OUTPUT=TAP "$3/$program" 2>&1 </dev/null ||
            echo "status $?" 2>/dev/null
    ) | sed '/^not ok [0-9]* - /q' >"$2/tap"
    if grep -q '^not ok [0-9]* - ' "$2/tap"; then
        echo "fails in $(sed -n 's/^not ok [0-9]* - //p' "$2/tap")"
    elif grep -q '^status' "$2/tap"; then
        sed -n 's/^status/ends with status/p' "$2/tap"
    elif grep -q '^ok [0-9]' "$2/tap"; then
        echo passes
    else
        echo 'is no test'
    fi
}

# The test in C must see the mistake.
judge_test() { # WHAT 'PROGRAM [TEST]' COPY FOLDER
    local outcome
    outcome=$(try_test "$2" "$3" "$4")
    case $outcome in
    fails* | ends*) echo "ok $1: ${2%% *} $outcome" ;;
    passes) echo "not ok $1: $2 does not see it" ;;
    *) echo "not ok $1: $2 $outcome" ;;
    esac
}

# Plant each line of $scratch/mistakes, two at a time, and print a TAP line as each is done: plant LINE COPY
# says in one line 'ok WHAT ...', 'not ok WHAT: WHY' or 'skip WHAT'.
plant_all() {
    local count done=0 line
    count=$(grep -c . "$scratch/mistakes")
    while read -r line; do
        done=$((done + 1))
        case $line in
        ok*) ok "${line#ok }" ;;
        skip*) skip "${line#skip }" 'this machine has not what it is built with' ;;
        *) not_ok "${line#not ok }" ;;
        esac
    done < <(seq "$count" | LP_NUM_THREADS=1 xargs -P 2 -n 12 "$0" --plant "$scratch")
    check "each of the $count has a result" [ "$done" = "$count" ]
}

# What xargs calls.
if [ "${1-}" = --plant ]; then
    set -f
    scratch=$2
    for number in "${@:3}"; do
        plant "$(sed -n "${number}p" "$scratch/mistakes")" "$scratch/$number.copy"
        rm -rf "$scratch/$number.copy"
    done
    exit 0
fi

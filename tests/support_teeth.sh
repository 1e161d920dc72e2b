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

#!/bin/bash
# marks.sh - `make marks FILES='hand-in/*/*.frag' EXERCISES='03_1 03_2' CSV=marks.csv`: mark a class. check.sh judges
# each file, and likeness.awk finds those with almost the same text as the published solution or as another student's;
# the mark does not depend on this. Each file is read as if it lay alone beside the course. The table has a row for each
# student; build/marks/index.html shows each picture beside the right one, and build/marks/wrong.txt lists the wrong
# pictures as scenes for `make lecture`.
#
# Each folder belongs to one student, and is named after the student. If all files are in one folder, the part of a
# file's name before the exercise names the student. With several exercises, the name of each file contains its
# exercise, such as 03_1 in "lamp 03_1.frag".
#
# A wrong answer gets points if more comparisons of check.sh hold than for the unsolved exercise. build/marks/feedback/
# has a page for each student, and build/marks/summary.txt says which comparisons fail most often.
#
# Environment: FILES; EXERCISES; CSV, a file for the table, by default build/marks/marks.csv, which may replace an older
# table but no other file; CSV_STYLE, words as in marks.awk; STUDENTS, a list of students as in list.awk, and IDENTIFIER,
# the title of one of its columns; WEIGHTS, a file whose lines have an exercise and the points of a right answer, by
# default 1; CHECK_LIMIT, the seconds of processor time for one picture, by default 20. Exit status: 0 if the table could
# be written, 2 if not. A file that is not marked because of its name is only reported. Everything is written at the end;
# other tables in build/marks/ stay.
set -u
export CHECK_LIMIT=${CHECK_LIMIT:-20}

. .make/write.sh
# shellcheck source=.make/exercises.sh
. .make/exercises.sh

# Print the exercise that a file answers, or nothing if its name contains none. If there is only one exercise, every
# file answers it.
exercise_of() { # FILE
    local name=${1##*/} exercise
    for exercise in "${exercises[@]}"; do
        [[ ${#exercises[@]} -gt 1 && ! "$name.end" =~ ${exercise/_/[-_]}[^0-9] ]] || { printf '%s\n' "$exercise"; return; }
    done
}

# True if the folder of a file contains the files of several students.
is_shared() { # FILE
    local name=${1#./}
    [ "$folders" = 1 ] || [ "${name%"${name##*/}"}" = "$common" ]
}

# Print the name of the student: the file's folder or, if that contains the files of several students, the part of the
# file's name before the exercise.
student_of() { # FILE
    local name=${1%/*}
    if is_shared "$1"; then
        name=$(sed -E 's/[-_ .]*([0-9][0-9]|engine)[-_][0-9]+.*//; s/[.](frag|c)$//' <<<"${1##*/}")
        [ -n "$name" ] || name=${1%/*} name=${name##*/}
    fi
    name=${name#./}
    plain "${name#"$common"}"
}

is_readable() { [ -f "$1" ] && [ -r "$1" ]; }

# Print the longest prefix that all lines share and that ends in '/'.
common_folder() {
    awk 'NR == 1 { common = $0 }
        { while (substr($0, 1, length(common)) != common) common = substr(common, 1, length(common) - 1) }
        END { sub(/[^\/]*$/, "", common); print common }'
}

read -r -a exercises <<<"$(tr -s '[:space:]' '\n' <<<"${EXERCISES-}" | awk 'NF && !seen[$0]++' | paste -s -d ' ' -)" # each once
[ ${#exercises[@]} -gt 0 ] || fail 2 "which exercises? For example: make marks FILES='hand-in/*/*.frag' EXERCISES='03_1 03_2' CSV=marks.csv"
for exercise in "${exercises[@]}"; do
    all_exercises | grep -qxF -e "$exercise" || fail 2 "EXERCISES: $exercise: no solution to compare with; these exercises have one: $(all_exercises | paste -s -d ' ' -)"
done
files=()
[ -z "${FILES-}" ] || FILE='' find_files
[ ${#files[@]} -gt 0 ] || fail 2 "which files? For example: make marks FILES='hand-in/*/*.frag' EXERCISES='${exercises[*]}'"

folder=build/marks table=${CSV:-build/marks/marks.csv}
[[ $table != -* ]] || table=./$table
for file in "${files[@]}"; do
    ! is_in "$folder" "$file" || fail 2 "$file: make marks writes the folder $folder anew: copy the file to another place"
    ! [ "$file" -ef "$table" ] || fail 2 "CSV=$table: this is the file $file, which was handed in: choose another name"
done
if [ -n "${CSV-}" ]; then
    target "$table" || exit 2
    [ ! -s "$table" ] || head -n 1 "$table" | tr -d '\357\273\277"' | grep -q '^student[,;[:blank:]]' ||
        fail 2 "CSV=$CSV: this file is not a table of marks: choose another name, or delete the file"
fi

for word in ${CSV_STYLE-}; do
    [[ $word =~ ^(comma|semicolon|tab|excel)$ ]] || fail 2 "CSV_STYLE=$CSV_STYLE: must be comma, semicolon or tab, or excel, alone or with one of these"
done
weights=
if [ -n "${WEIGHTS-}" ]; then
    is_readable "$WEIGHTS" || fail 2 "WEIGHTS=$WEIGHTS: cannot be read: it must be a file with lines such as '03_1 5'"
    number=0
    while read -r exercise points rest || [ -n "$exercise" ]; do
        number=$((number + 1)) points=${points%$'\r'}
        [[ $exercise != \#* && -n ${exercise%$'\r'} ]] || continue
        [[ -z $rest && $exercise =~ ^([0-9][0-9]|engine)_[0-9]+$ && $points =~ ^[0-9]+([.][0-9]+)?$ ]] ||
            fail 2 "WEIGHTS=$WEIGHTS: line $number: must be an exercise and its points, such as '03_1 5'"
        weights+="$exercise=$points "
    done <"$WEIGHTS"
fi
if [ -n "${STUDENTS-}" ]; then
    is_readable "$STUDENTS" || fail 2 "STUDENTS=$STUDENTS: cannot be read: it must be a CSV file with titles, such as 'First name,Last name,Email address'"
    ! [ "$STUDENTS" -ef "$table" ] || fail 2 "CSV=$table: this is the list of students: choose another name"
    students=$(wanted=${IDENTIFIER-} awk -f .make/table.awk -f .make/list.awk <"$STUDENTS")
    [[ $students != $'\t'* ]] || fail 2 "STUDENTS=$STUDENTS: which column identifies a student? Set IDENTIFIER to one of these titles: ${students#$'\t'}"
    [ -n "$students" ] || fail 2 "STUDENTS=$STUDENTS: the file is empty: it must be a CSV file with titles, such as 'First name,Last name,Email address'"
fi

kept=() unnamed=()
for file in "${files[@]}"; do
    if [[ "$file" == *[$'\t\n']* ]]; then
        report "$file: the name has a tab or a line break, so the file is not marked: rename it"
    elif [ -z "$(exercise_of "$file")" ]; then
        unnamed+=("$file")
    else
        kept+=("$file")
    fi
done
[ ${#kept[@]} -gt 0 ] || fail 2 "FILES='$FILES': none of these names contains one of the exercises ${exercises[*]}, as in '${exercises[0]}.frag': rename the files"
files=("${kept[@]}")
folders=$(for file in "${files[@]}"; do dirname "$file"; done | sort -u | grep -c '')
common=
[ "$folders" = 1 ] || common=$(for file in "${files[@]}"; do file=${file#./} && printf '%s\n' "${file%"${file##*/}"}"; done | common_folder)

begin build || exit 2
mkdir -p "$new/marks/feedback" || exit 2
: >"$new/judged"
for file in "${files[@]}"; do
    is_shared "$file" || dirname "$file"
done | sort -u >"$new/folders" || exit 2
for exercise in "${exercises[@]}"; do
    answers=()
    for file in "${files[@]}"; do
        [ "$(exercise_of "$file")" != "$exercise" ] || answers+=("$file")
    done
    [ ${#answers[@]} != 0 ] || continue
    # In the background, so that a signal that ends this script also ends the check, after its current picture at the
    # latest. A process in the background would ignore Ctrl+C.
    (
        trap - INT
        FILE='' FILES='' EXERCISE=$exercise CHECK_FOLDER=$folder/pictures CHECK_WORK=$new/marks/pictures MARKS=$new/judged FOLDERS=$new/folders \
            exec .make/check.sh "${answers[@]}"
    ) &
    child=$!
    wait "$child" || [ $? = 1 ] || exit 2
    child=
done
for file in ${unnamed[@]+"${unnamed[@]}"}; do
    report "$file: its name contains none of ${exercises[*]}, so the file is not marked"
done

# Print a text for likeness.awk. Only the first 64 KiB of a file are read. The text of an answer contains the files in the
# student's folder that it includes.
text() { # WHAT EXERCISE STUDENT FILE
    local parts=("$4") i name
    printf '\001%s\t%s\t%s\n' "$1" "$2" "$3"
    for ((i = 0; i < ${#parts[@]} && i < 32; i++)); do
        [ -f "${parts[i]}" ] || continue
        head -c 65536 "${parts[i]}" 2>/dev/null | tr -d '\000\001' >"$new/part"
        cat "$new/part" && echo
        if [ "$1" != answer ] || is_shared "$4"; then continue; fi
        while IFS= read -r name; do
            name=${parts[i]%/*}/$name
            [[ $name == */../* ]] || grep -qxF -e "$name" <<<"$(printf '%s\n' "${parts[@]}")" || parts+=("$name")
        done < <(sed -nE 's/^[[:blank:]]*#[[:blank:]]*include[[:blank:]]*"([^"]+)".*/\1/p' "$new/part")
    done
}

# Write the lines for marks.awk: those of the unsolved exercises, and then the answers, with the student instead of the
# file.
number=0
while IFS=$'\t' read -r exercise file mark verdict picture right difference results flags; do
    if [ "$mark" = unsolved ]; then
        printf '%s\t\t%s\t%s\t-\t-\t%s\n' "$exercise" "$mark" "$verdict" "$results" >>"$new/rows"
        continue
    fi
    if [ "$picture" != - ]; then
        number=$((number + 1))
        mv "$picture" "$new/marks/$number.png" && mv "$right" "$new/marks/$number.right.png" || exit 2
        [ "$difference" = - ] || { mv "$difference" "$new/marks/$number.difference.png" && difference=$number; } || exit 2
        picture=$number
    fi
    student=$(student_of "$file")
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$exercise" "$student" "$mark" "$verdict" "$picture" "$difference" "$results" "$flags" >>"$new/named"
    text answer "$exercise" "$student" "$file" >>"$new/texts"
done <"$new/judged" || exit 2
{
    awk 'FNR == 1 { print "\001course" } { print }' \
        chapters/[0-9]*.frag chapters/*.glsl chapters/{experiments,figures,first_steps}/*.frag chapters/first_steps/*.c shaders/*.glsl /dev/null
    for exercise in "${exercises[@]}"; do
        unsolved=$(echo chapters/"${exercise%_*}"_*.frag) solution=$(echo chapters/solutions/"${exercise%_*}"_*_"${exercise#*_}".frag) what=chapter
        if [[ $exercise == engine_* ]]; then
            unsolved=chapters/first_steps/engine_6.c solution=$new/solution.c what=engine
            patch -s -o "$solution" "$unsolved" "chapters/solutions/$exercise.diff" || exit 2
        fi
        text chapter "$exercise" "the $what, unchanged" "$unsolved"
        text solution "$exercise" '' "$solution"
    done
    cat "$new/texts"
} | awk -f .make/likeness.awk | paste "$new/named" - >"$new/like" || exit 2
for exercise in "${exercises[@]}"; do
    list=$new/marks/pictures/$exercise/wrong.txt
    [ ! -e "$list" ] || { echo "== $exercise" && cat "$list" && rm "$list"; } >>"$new/marks/wrong.txt" || exit 2
done
rm -rf "$new/marks/pictures"

sort -t $'\t' -k 2,2 -k 1,1 "$new/like" >>"$new/rows" || exit 2
[ -z "${STUDENTS-}" ] || printf '%s\n' "$students" >"$new/list" || exit 2
marks() {
    awk -F '\t' -v csv="$new/table" -v page="$new/marks/index.html" -v summary="$new/marks/summary.txt" -v folder="$new/marks" \
        -v exercises="${exercises[*]}" -v weights="$weights" -v style="${CSV_STYLE-}" -v list="${STUDENTS:+$new/list}" -v unknown="$new/unknown" \
        -f .make/table.awk -f .make/marks.awk -f .make/summary.awk -f .make/feedback.awk "$new/rows"
}
write "$new/said" marks || exit 2
for old in "$folder"/*.csv; do
    [ ! -f "$old" ] || cp -p "$old" "$new/marks" || exit 2
done
keep marks && write "$table" cat "$new/table" || exit 2
cat "$new/said"
if [ -s "$new/unknown" ]; then
    report "STUDENTS=$STUDENTS: not in the list, or not alone with this name: $(paste -s -d , "$new/unknown" | sed 's/,/, /g'): correct the list or the names, because a platform may refuse the whole table"
fi
printf '%s\n' "The table is $(plain "$table"); the pictures are in $folder/index.html." \
    "For you: $folder/summary.txt; for each student: $folder/feedback/."
[ ! -e "$folder/wrong.txt" ] || beside "$folder/wrong.txt"

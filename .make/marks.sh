#!/bin/bash
# marks.sh - `make marks FILES='hand-in/*/*.frag' EXERCISES='03_1 03_2' CSV=marks.csv`: mark a class. check.sh judges
# each file. A file whose text is the published solution, or another student's, is marked as copied; blanks and comments
# do not count. The table has a row for each student; build/marks/index.html shows each picture beside the right one,
# and build/marks/wrong.txt lists the wrong pictures as scenes for `make lecture`.
#
# Each folder belongs to one student, and is named after the student. If all files are in one folder, the part of a
# file's name before the exercise names the student. With several exercises, the name of each file contains its
# exercise, such as 03_1 in "lamp 03_1.frag".
#
# Environment: FILES; EXERCISES; CSV, a file for the table, by default build/marks/marks.csv; CHECK_LIMIT, the seconds
# of processor time for one picture, by default 20. Exit status: 0 if the table could be written, 2 if not. A file that
# is not marked because of its name is only reported.
set -u
export LC_ALL=C CHECK_LIMIT=${CHECK_LIMIT:-20}

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 2
}
# shellcheck source=.make/exercises.sh
. .make/exercises.sh

# Print the exercise that a file answers, or nothing if its name contains none. If there is only one exercise, every
# file answers it.
exercise_of() { # FILE
    local name=${1##*/} exercise
    for exercise in "${exercises[@]}"; do
        [[ ${#exercises[@]} -gt 1 && ! "$name.end" =~ ${exercise/_/[-_]}[^0-9] ]] || { echo "$exercise"; return; }
    done
}

student_of() { # FILE
    local name=${1%/*}
    if [ "$folders" = 1 ]; then
        name=${1##*/}
        name=$(sed -E 's/[-_ .]*[0-9][0-9][-_][0-9]+.*//; s/[.]frag$//' <<<"$name")
    fi
    echo "${name#"$common"}"
}

# Print the longest prefix that all lines share and that ends in '/'.
common_folder() {
    awk 'NR == 1 { common = $0 }
        { while (substr($0, 1, length(common)) != common) common = substr(common, 1, length(common) - 1) }
        END { sub(/[^\/]*$/, "", common); print common }'
}

read -r -a exercises <<<"${EXERCISES-}"
[ ${#exercises[@]} -gt 0 ] || fail "which exercises? For example: make marks FILES='hand-in/*/*.frag' EXERCISES='03_1 03_2' CSV=marks.csv"
for exercise in "${exercises[@]}"; do
    exercises | grep -qxF -e "$exercise" || fail "EXERCISES: $exercise: no solution to compare with; these exercises have one: $(exercises | paste -s -d ' ' -)"
done
files=()
[ -z "${FILES-}" ] || FILE='' find_files
[ ${#files[@]} -gt 0 ] || fail "which files? For example: make marks FILES='hand-in/*/*.frag' EXERCISES='${exercises[*]}'"
kept=()
for file in "${files[@]}"; do
    if [[ "$file" == *[$'\t\n']* ]]; then
        printf '%q: the name has a tab or a line break, so the file is not marked: rename it\n' "$file" >&2
    else
        kept+=("$file")
    fi
done
[ ${#kept[@]} -gt 0 ] || fail "FILES='$FILES': none of these files can be marked"
files=("${kept[@]}")
folders=$(for file in "${files[@]}"; do dirname "$file"; done | sort -u | wc -l)
common=
[ "$folders" = 1 ] || common=$(for file in "${files[@]}"; do echo "${file%/*}/"; done | common_folder)

folder=build/marks table=${CSV:-build/marks/marks.csv}
rm -rf "$folder" && mkdir -p "$folder" || exit 2
{ : >"$table"; } 2>/dev/null || fail "CSV=$table: cannot be written"

# A check in the background does not receive this script's signals. A signal that ends the script also ends the check,
# after its current picture.
judge=
trap '[ -z "$judge" ] || kill "$judge" 2>/dev/null; exit 2' HUP INT TERM
# Write a line for each file: exercise, file, mark, verdict, picture, right picture.
for exercise in "${exercises[@]}"; do
    answers=()
    for file in "${files[@]}"; do
        [ "$(exercise_of "$file")" != "$exercise" ] || answers+=("$file")
    done
    [ ${#answers[@]} != 0 ] || continue
    FILE='' FILES='' EXERCISE=$exercise CHECK_FOLDER=$folder/pictures MARKS=$folder/judged .make/check.sh "${answers[@]}" &
    judge=$!
    wait "$judge" || [ $? = 1 ] || exit 2
done
for file in "${files[@]}"; do
    [ -n "$(exercise_of "$file")" ] || echo "$file: its name contains none of ${exercises[*]}, so the file is not marked" >&2
done

# Write the same lines with the student and a checksum of the text added, and copies of the published solution marked.
# An empty file and the chapter's own shader are nobody's work, so two such files do not count as copies: the file's
# name replaces the checksum.
number=0
while IFS=$'\t' read -r exercise file mark verdict picture right; do
    [[ $verdict != 'the published solution; '* ]] || mark=copied
    text=$(text_of "$file")
    [[ $text != "$(text_of /dev/null)" && $text != "$(text_of "$(echo chapters/"${exercise%_*}"_*.frag)")" ]] || text=$file
    if [ "$picture" != - ]; then
        number=$((number + 1))
        mv "$picture" "$folder/$number.png" && mv "$right" "$folder/$number.right.png" || exit 2
        picture=$number
    fi
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$exercise" "$(student_of "$file")" "$mark" "$verdict" "$picture" "$text" "$file" || exit 2
done <"$folder/judged" >"$folder/named"
sort -t $'\t' -k 2,2 -k 1,1 "$folder/named" | CSV=$table awk -F '\t' -v page="$folder/index.html" -v exercises="${exercises[*]}" '
    function cell(s) { if (s ~ /^[-=+@]/) s = "\047" s; gsub(/"/, "\"\"", s); return "\"" s "\"" } # a spreadsheet must not take the text for a formula
    function html(s) { gsub(/&/, "\\&amp;", s); gsub(/</, "\\&lt;", s); gsub(/>/, "\\&gt;", s); return s }
    { line[NR] = $0 }
    !(($1, $6, $2) in had) { had[$1, $6, $2]; who[$1, $6] = who[$1, $6] (who[$1, $6] == "" ? "" : ", ") $2; count[$1, $6]++ }
    END {
        csv = ENVIRON["CSV"] # -v would interpret the backslashes of the path
        wanted = split(exercises, exercise, " ")
        printf "student" >csv
        for (e = 1; e <= wanted; e++) printf ",%s,%s", exercise[e], cell(exercise[e] " remark") >csv
        print "" >csv
        print "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Marks</title>" >page
        print "<style>body{font-family:sans-serif}table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.4em;vertical-align:top;text-align:left}img{width:20em;display:block}.wrong{background:#fdd}.copied{background:#ffd}</style>" >page
        print "<table><tr><th>student<th>exercise<th>mark<th>handed in<th>right" >page
        for (i = 1; i <= NR; i++) {
            split(line[i], f, "\t")
            if (count[f[1], f[6]] > 1 && f[3] != "copied") { f[3] = "copied"; f[4] = "the same text: " who[f[1], f[6]] "; " f[4] }
            if (!(f[2] in seen)) { seen[f[2]] = 1; student[++students] = f[2] }
            twice = (f[2], f[1]) in mark
            mark[f[2], f[1]] = twice ? mark[f[2], f[1]] " " f[3] : f[3]
            remark[f[2], f[1]] = (twice ? remark[f[2], f[1]] " | " : "") f[4]
            total[f[3]]++
            pictures = f[5] == "-" ? "<td><td>" : sprintf("<td><img src=\"%d.png\" alt=\"handed in\"><td><img src=\"%d.right.png\" alt=\"right\">", f[5], f[5])
            printf "<tr class=\"%s\"><td>%s<td>%s<td>%s: %s%s\n", f[3], html(f[2]), f[1], f[3], html(f[4]), pictures >page
        }
        for (s = 1; s <= students; s++) {
            printf "%s", cell(student[s]) >csv
            text = ""
            for (e = 1; e <= wanted; e++) {
                key = student[s] SUBSEP exercise[e]
                m = key in mark ? mark[key] : "missing"
                printf ",%s,%s", m, cell(remark[key]) >csv
                text = text sprintf("  %-8s", m)
            }
            print "" >csv
            printf "%-24s%s\n", student[s], text
        }
        printf "%d students; answers: %d right, %d wrong, %d copied\n", students, total["right"], total["wrong"], total["copied"]
    }' 2>/dev/null || fail "$table or $folder/index.html: cannot be written: is the disk full?"
for exercise in "${exercises[@]}"; do
    list=$folder/pictures/$exercise/wrong.txt
    [ ! -e "$list" ] || { echo "== $exercise" && cat "$list" && rm "$list"; } >>"$folder/wrong.txt" || exit 2
done
rm -rf "$folder/named" "$folder/judged"
find "$folder/pictures" -depth -type d -empty -delete
echo "The table is $table; the pictures are in $folder/index.html."
[ ! -e "$folder/wrong.txt" ] || beside "$folder/wrong.txt"

#!/bin/bash
# marks.sh - tests `make marks`: the table of a class whose folder names contain blanks, accents and quotes, whose texts
# it finds to be the same, and the requests that it refuses. check.sh tests the verdict on a single file.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
class="$scratch/hand in"
hand_in() { # STUDENT FILE: writes the file from standard input
    mkdir -p "$class/$1"
    cat >"$class/$1/$2"
}
right=chapters/solutions/00_first_scene_2.frag
{ cat $right; echo '#define MINE'; } | hand_in "Zoë \"O'Neil\"" '00-2 <my> ball.frag'
{ cat chapters/solutions/00_first_scene_3.frag; echo '#define MINE'; } | hand_in "Zoë \"O'Neil\"" 00_3.frag
hand_in '=cmd()' 00_2.frag <chapters/00_first_scene.frag
{ echo '/* all mine * */'; sed 's/; *$/ ; \/\/ mine/' $right; } | hand_in copy 00_2.frag
echo '#include "solutions/00_first_scene_2.frag"' | hand_in include 00_2.frag
fault=$(seq -s ' + ' 60)
echo "float one = $fault" | hand_in twin 00_2.frag
echo "float /* */ other=${fault// /} // here" | hand_in 'the other twin' 00_2.frag
echo 'one fault' | tee >(hand_in idle 00_3.frag) | hand_in copy 00_3.frag
hand_in nameless ball.frag <$right
hand_in idle 00_2.frag <chapters/00_first_scene.frag
for name in '00-2 first' '00-2 last'; do echo "again, $fault" | tr + - | hand_in again "$name.frag"; done
mkdir -p "$class/pipe" && mkfifo "$class/pipe/00_2.frag"
hand_in odd $'00_2\n.frag' <$right

marks() { FILES=$1 EXERCISES=$2 CSV=${3-$scratch/marks.csv} .make/marks.sh >"$scratch/said" 2>&1; }
# has STUDENT EXERCISE MARK [POINTS [SAME [LOOK [REMARK]]]]: the table says so; all but EXERCISE are patterns for a whole
# cell.
has() {
    local -A found
    local what wanted
    while IFS=$'\t' read -r what wanted; do found[$what]=$wanted; done < <(student=$1 awk -f .make/table.awk -f <(cat <<'END'
        BEGIN { student = ENVIRON["student"] }
        NR == 1 { n = fields($0, ",", title) }
        NR > 1 && fields($0, ",", cell_of) == n && cell_of[1] == student { for (i = 2; i <= n; i++) print title[i] "\t" cell_of[i] }
END
    ) "$scratch/marks.csv")
    for what in "$2" "$2 points" "$2 same as" "$2 look at" "$2 remark"; do
        [ $# -gt 2 ] || return 0
        grep -qxE -e "$3" <<<"${found[$what]-none}" || { echo "# $1: $what: ${found[$what]-none}" && return 1; }
        set -- "$1" "$2" "${@:4}"
    done
}
check 'a class is marked' marks "$class/*/*.frag" '00_2 00_3'
check 'a row has a mark, points, whose text is the same, what to look at and a remark for each exercise' has "Zoë \"O'Neil\"" 00_2 right 1 '' '' 'matches the solution.*'
check 'for the other exercise too' has "Zoë \"O'Neil\"" 00_3 right 1 '' '' 'matches the solution.*'
check 'a wrong solution is marked, and a folder name that a spreadsheet would read as a formula is escaped' has "'=cmd()" 00_2 wrong 0 '' 'the chapter, unchanged' '.* differ .*'
check 'an answer that is missing has no grade' has "'=cmd()" 00_3 missing - '' '' ''
check 'a file that includes the published solution is the same as that' has include 00_2 wrong 0 'the published solution' '' 'does not run: .*#version in an included file.*'
check 'the same text from two students is recognised, whatever its names, blanks and comments' has twin 00_2 wrong 0 'the other twin' '' 'does not run: .*'
check 'a few words are nobody'"'"'s' has idle 00_3 wrong 0 '' '' 'does not run: .*'
check 'two files of one student are not compared' has again 00_2 'wrong wrong' 0 '' '' 'does not run.* [|] does not run.*'
check 'a pipe is refused without waiting for it' has pipe 00_2 wrong 0 '' '' 'not a regular file'
check 'a file whose name contains a line break is reported, and the others are marked' grep -q 'odd/00_2.*the name has a tab or a line break' "$scratch/said"
check 'the table has no other rows' [ "$(wc -l <"$scratch/marks.csv")" = 10 ]
check 'a file whose name contains no exercise is reported' grep -q 'nameless/ball.frag: its name contains none of 00_2 00_3, so the file is not marked' "$scratch/said"
check 'the marks are counted' grep -q '^9 students; answers: 3 right, 10 wrong; 3 almost the same as another, 2 to look at$' "$scratch/said"
pictures() {
    grep -q '<td>00_3<td>right' build/marks/index.html &&
        grep -o 'src="[^"]*' build/marks/index.html >"$scratch/pictures" &&
        while read -r picture; do [ -s "build/marks/${picture#src=?}" ] || { echo "# no $picture"; return 1; }; done <"$scratch/pictures"
}
check 'every picture on the page exists' pictures
# The wrong files that have a picture become scenes for make lecture, which must find each file, whatever its name.
{ cat chapters/00_first_scene.frag; echo '#define THEIRS'; } | hand_in "O'Neil \"the\" wrong" 00_2.frag
beside() {
    marks "$class/*/00_2.frag" 00_2 && grep -q 'N for the next: make lecture LIST=build/marks/wrong.txt$' "$scratch/said" &&
        build/lecture --print build/marks/wrong.txt >"$scratch/scenes" && [ "$(wc -l <"$scratch/scenes")" = 3 ] &&
        [ "$(grep -c "frag. --compare chapters/solutions/00_first_scene_2.frag --labels 'an answer,the solution' --divider 0[.][0-9]* --time 1.with --time 1, .* differ " "$scratch/scenes")" = 3 ]
}
check 'the wrong pictures are listed as scenes for make lecture' beside || sed 's/^/# /' "$scratch/said" "$scratch/scenes"
head -c 1048576 /dev/zero >"$scratch/full"
to_full() { ! within_kib 1024 build/lecture --print build/marks/wrong.txt 2>"$scratch/said" >>"$scratch/full" && grep -q '^standard output: cannot be written' "$scratch/said"; }
check 'scenes that cannot be printed are reported' to_full
# The judge, a child of marks.sh, must end with marks.sh; otherwise, it would judge all remaining files. A process that
# has ended has no folder in /proc. tests/course/kept.sh interrupts every command.
interrupted() {
    local marks judge new
    cp -R build/marks "$scratch/old"
    FILES="$class/*/00_2.frag" EXERCISES=00_2 .make/marks.sh >"$scratch/said" 2>&1 &
    marks=$! new=build/.ray-marching.$!.new
    until [ -d "$new/marks/pictures/00_2" ] || ! kill -0 "$marks"; do sleep 0.1; done
    judge=$(cat "/proc/$marks/task/$marks/children")
    kill "$marks"
    wait "$marks"
    [ $? = 143 ] && [ -n "$judge" ] && [ ! -e "/proc/${judge// /}" ] && [ ! -e "$new" ] && diff -r "$scratch/old" build/marks
}
[ ! -r "/proc/$$/task/$$/children" ] || check 'the judge ends with marks.sh, and the old marks stay' interrupted
one_folder() { cp "$class/copy/00_2.frag" "$scratch/ada_00_2.frag" && marks "$scratch/*.frag" 00_2 && has ada 00_2 right; }
check "in a single folder, the student's name is taken from the name of the file" one_folder

# ---- Whose text is the same ----

# like TEXT...: prints what likeness.awk says of the answers of as many students, 'a' to 'z', separated by '|'. $course
# and $solution are texts of the course.
course='' solution='a solution'
like() {
    local text student=({a..z}) number=0
    {
        printf '\001course\n%s\001chapter\t00_2\tthe chapter, unchanged\nint mine; #define mine\n\001solution\t00_2\t\n%s' "$course" "$solution"
        for text; do printf '\001answer\t00_2\t%s\n%s' "${student[number]}" "$text" && number=$((number + 1)); done
    } | awk -f .make/likeness.awk | cut -f "${column:-1}" | paste -s -d '|' -
}
are() { # WANTED TEXT...
    local found
    found=$(like "${@:2}")
    [ "$found" = "$1" ] || { echo "# $found"; return 1; }
}
mine='float far(vec3 p, float size) { vec3 q = abs(p) - size, r = max(q, 0.0); float inside = min(max(q.x, q.z), 0.0); return length(r) + inside; }'
mine+=$'\n#define near far\nvoid main() { vec3 d = vec3(near(d, 1.5), 2.5, 3.5); gl_FragColor = vec4(sin(d.x) * d, cos(d.y) + exp(d.z)); }'
theirs=$(sed 's/far/f1/g; s/near/g1/; s/near/g1/; s/\<p\>/a/g; s/size/b/g; s/\<q\>/c/g; s/\<r\>/e/g; s/inside/f/g; s/\<d\>/dd/g' <<<"$mine")
check 'a copy with other names is found, in both directions' are 'b|a|' "$mine" "$theirs" 'float other = 1.0;'
check 'so is a copy without blanks, with comments, and with its functions in another order' are 'b|a' "$mine" "$(tail -n 1 <<<"$theirs" | sed 's/;/; \/* a\n*b *\/ /g; s/$/ \/\/ c/')
$(head -n 2 <<<"$theirs" | sed 's/ = /=/g; s/, /,/g')"
check 'so is a copy in which a number is changed' are 'b|a' "$mine; float a = 1.0, b = 2.0 + a, c = 3.0 + a * b;" "$theirs; float a = 1.0, b = 2.0 + a, c = 4.0 + a * b;"
check 'a text with other operations is not' are '|' "$mine" "$(tr '+-' '*/' <<<"${mine//min/max}")"
course=$mine check 'what the course contains does not count' are '|' "$mine" "$theirs"
course=${mine//2.5/4.5} check 'a changed number alone accuses nobody' are '|' "$mine" "$mine"
check 'what two of three students have is the same' are 'b|a|' "$mine" "$theirs" 'int x;'
check 'what five have, a quarter of the class and more, does not count' are '||||' "$mine" "$theirs" "$mine" "$theirs" "$mine"
given=$mine$'\n'
own=$(sed 's/sin/tan/g; s/max/pow/g; s/min/mod/g; s/abs/sqrt/g; s/[+]/-/g; s/5/7/g' <<<"$mine")
check 'then only the rest is compared' are '||||f|e|' "$given int a;" "$given int b = 2;" "$given" "$given int c = 4;" "$given $own" "$theirs${own//inside/g}" 'int x;'
solution=$theirs check 'a text that is the published solution is found' are 'the published solution|' "$mine" 'int x;'
solution=$theirs check 'even if half of the class hands it in' are 'the published solution|the published solution||' "$mine" "$mine" 'int x;' 'int y;'
check 'a published solution that is included is found' are 'the published solution' $'int x;\n # include "../solutions/00.frag" // mine'
check 'in a comment it is not' are '' $'int x;\n// #include "../solutions/00.frag"'
column=2 check 'an answer that is the chapter, with other names, is recognised' are 'the chapter, unchanged||the chapter, unchanged' $'int  b; #define b\n' 'int b;' $'#include "../00_first.frag" // mine'
column=2 check 'an answer without any text is not the chapter' are '||' '' '// mine' '#include "00_2.frag"'
check 'answers to other exercises are not compared' eval "[ \"\$({ printf '\\001answer\\t00_1\\ta\\n%s' \"\$mine\"; printf '\\001answer\\t00_2\\tb\\n%s' \"\$mine\"; } | awk -f .make/likeness.awk | tr -d '\\t\\n')\" = '' ]"
hostile() { # one line of 64 KiB, a comment that is never closed, bytes that are no text
    local long
    long=$(head -c 65536 /dev/zero | tr '\0' '/') && are '||' "${long//\//1+}" "/*$long" "$(head -c 60000 build/00_first_scene | tr -d '\0\001')"
}
check 'long lines, open comments and texts that are none are read in a moment' hostile

# ---- What an answer reads, and what it does when nobody looks ----

outer=$class class=$scratch/alone
hand_in ada 00_2.frag <$right
echo '#include "../ada/00_2.frag"' | hand_in ben 00_2.frag
echo '#include "part.glsl"' | hand_in cleo 00_2.frag
ln -s ../ada/00_2.frag "$class/cleo/part.glsl"
printf '#version 330 core\n#include "parts/part.glsl"\n' | hand_in dan 00_2.frag
mkdir "$class/dan/parts" && sed 1d $right >"$class/dan/parts/part.glsl"
{ cat chapters/solutions/01_normal_colouring_6.frag; echo 'uniform sampler2D picture; // "my own.png" sRGB clamp: a picture'; } | hand_in eve 01_6.frag
cp tests/references/00_first_scene.png "$class/eve/my own.png"
sed 's/0.5 \* Time/0.5 * (Time == 1.0 || Time == 4.0 ? Time : 0.0)/' $right | hand_in finn 00_2.frag
echo '#include "ada/00_2.frag"' | hand_in . gil_00_2.frag
echo '#include "inner/00_2.frag"' | hand_in hal 00_2.frag
hand_in hal/inner 00_2.frag <$right
check 'a class that includes each other is marked' marks "$class/*/*.frag $class/*.frag $class/*/*/*.frag" '00_2 01_6'
check 'an answer does not see the files of another student' has ben 00_2 wrong 0 '' 'asks for ../ada/00_2.frag, which is not its own' 'does not run: 00_2.frag:1: .*'
check 'not even through a link' has cleo 00_2 wrong 0 '' 'asks for part.glsl, which is not its own'
check 'nor in a folder that several share' has gil 00_2 wrong 0 '' 'asks for ada/00_2.frag, which is not its own'
check 'nor below its own folder' has hal 00_2 wrong 0 '' 'asks for inner/00_2.frag, which is not its own'
check 'it sees the files of its student' has dan 00_2 right 1 '' ''
check 'a picture that was handed in is named' has eve 01_6 right 1 '' 'reads the picture my own.png, which was handed in with it'
check 'so is an answer that is right only at the times of the check' has finn 00_2 right 1 '' 'draws what the check compares, but with --size 656x369 --time [0-9.]*, .* differ .*' 'matches .*'
check 'all others have nothing to look at' has ada 00_2 right 1 '' '' 'matches .*'
alone() { cp "$class/gil_00_2.frag" "$scratch/alone.frag" && rm -r "$class" && hand_in . ada_00_2.frag <$right && sed 's/ada./ada_/' "$scratch/alone.frag" | hand_in . gil_00_2.frag && marks "$class/*.frag" 00_2 && has gil 00_2 wrong 0 '' 'asks for ada_00_2.frag, which is not its own'; }
check 'in a single folder, an answer sees only itself' alone
class=$outer

# ---- Points ----

# earns POINTS MARK RESULTS UNSOLVED: for an answer with these results, where 10 points are for a right one.
earns() {
    printf '00_2\t\tunsolved\ta|b|c|d|e\t-\t-\t%s\n00_2\tada\t%s\twhy\t-\t-\t%s\t\t\t\n' "$4" "$2" "$3" |
        awk -F '\t' -v csv="$scratch/marks.csv" -v page=/dev/null -v exercises=00_2 -v weights='00_2=10 00_3=1' -f .make/table.awk -f .make/marks.awk >/dev/null &&
        has ada 00_2 "$2" "$1"
}
check 'a right answer earns all points' earns 10 right +++++ -----
check 'a wrong one earns those of the comparisons that hold' earns 4 wrong ++--- -----
check 'except for those that hold without a solution' earns 2.5 wrong ++--- +----
check 'and never less than none' earns 0 wrong +---- ++---

# ---- Lists of students ----

# known IDENTIFIER NAME: list.awk finds a student in the list of standard input.
known() {
    awk -f .make/table.awk -f .make/list.awk | awk -F '\t' -v id="$1" -v name="$2" '$1 == id { for (i = 3; i <= NF; i++) if ($i == name) found = 1 } END { exit !found }'
}
moodle=$'First name,"Last name",ID number,"Email address",Groups\r\nAda,"Lovelace, King",0012,ada@x.org,"a\r\nb"\r\nZo\xc3\xab,"""O\'Neil""",13,zoe@x.org,\r\n'
check 'a list as Moodle exports it is read' known ada@x.org 'ada lovelace, king' <<<"$moodle"
check 'so is the student after a line break in a cell' known zoe@x.org $'zo\xc3\xab "o\'neil"' <<<"$moodle"
check 'with semicolons and a byte order mark' known 13 $'zo\xc3\xab "o\'neil"' < <(printf '\357\273\277' && sed 's/,/;/g; s/Email/E/' <<<"$moodle")
check 'with tabs' known 13 $'zo\xc3\xab "o\'neil"' < <(sed $'s/,/\t/g; s/Email/E/' <<<"$moodle")
wanted='id NUMBER' check 'with another column' known 13 $'"o\'neil", zo\xc3\xab' <<<"$moodle"
check 'with the address in front of the name' known ada@x.org 'lovelace ada' <<<$'Email;First name;Last name\nada@x.org;Ada;Lovelace'
check 'a student is found by the number' known ada@x.org 0012 <<<"$moodle"

# ---- For a learning platform ----

outer=$class class=$scratch/platform
hand_in 'Ada Lovelace_123_assignsubmission_file' 00_2.frag <$right
hand_in zoe@x.org 00_2.frag <chapters/00_first_scene.frag
echo 'a fault' | hand_in $'eve; "x\\' 00_2.frag
sed 's/0.5 \* Time/Time == 4.0 ? 2.0 : 0.0/' $right | hand_in finn 00_2.frag
printf '# points\n00_2 8\r\n\n00_3 2.5' >"$scratch/weights"
printf 'First name;Last name;Email address\r\nAda;Lovelace;ada@x.org\r\nZo\xc3\xab;ONeil;zoe@x.org\r\nAbsent;Aldo;aldo@x.org\r\nFinn;One;one@x.org\r\nFinn;Two;two@x.org\r\n' >"$scratch/list.csv"
export WEIGHTS=$scratch/weights STUDENTS=$scratch/list.csv
check 'a class with a list and weights is marked' marks "$class/*/*.frag" '00_2 00_3'
check 'a right answer has the points of the exercise' has 'Ada Lovelace_123_assignsubmission_file' 00_2 right 8
check 'an answer of which one picture of two is right has some of them' has finn 00_2 wrong 2.67
totals() { [ "$(cut -d , -f 1-3 "$scratch/marks.csv")" = "$(cat <<'END'
student,"Email address",points
"Ada Lovelace_123_assignsubmission_file","ada@x.org",8
"eve; ""x\ ","eve; ""x\ ",0
"finn","finn",2.67
"zoe@x.org","zoe@x.org",0
"Absent Aldo","aldo@x.org",0
"Finn One","one@x.org",0
"Finn Two","two@x.org",0
END
)" ]; }
check 'each row has the sum and the e-mail address of the list, or a name that no platform knows; who handed in nothing has a row' totals || sed 's/^/# /' "$scratch/marks.csv"
check 'who is not in the list is named' grep -q '^make: STUDENTS=.*not in the list, or not alone with this name: eve; "x\\, finn: correct ' "$scratch/said"
# Python's csv is a second reader of the table, in each of its forms. `grades` does what Moodle's grade import does with
# one of its columns: a row whose address nobody has, or a cell that is neither a number nor -, refuses the file. In some
# versions, a row without an address goes to the student in the row above.
reads() { # STYLE ARGUMENTS
    CSV_STYLE=$1 marks "$class/*/*.frag" '00_2 00_3' && python3 - "$scratch/marks.csv" "${@:2}" <<'END'
import csv, sys
path, separator, encoding, comma = sys.argv[1:]
text = open(path, newline="", encoding=encoding).read()
assert not text.startswith("\ufeff") and ("\r\n" in text) == (encoding == "utf-8-sig"), "beginning or line ends"
rows = list(csv.reader(text.splitlines(keepends=True), delimiter=separator, strict=True))
head = ["student", "Email address", "points"] + [x + y for x in ("00_2", "00_3") for y in ("", " points", " same as", " look at", " remark")]
assert rows[0] == head, rows[0]
assert [len(row) for row in rows] == [len(head)] * 8, rows
assert rows[2][0] == 'eve; "x\\ ' and rows[2][3] == "wrong" and "does not run" in rows[2][7], rows[2]
assert rows[3][2].replace(comma, ".") == "2.67" and float(rows[3][4].replace(comma, ".")) == 2.67, rows[3]
def grades(title, rows, known):
    found = {}
    for row in rows:
        user, grade = row[head.index("Email address")].strip(), row[head.index(title)].strip()
        assert user != "", "the grade goes to the row above"
        if user not in known:
            return "nobody has the address " + user
        found[user] = None if grade in ("", "-") else float(grade.replace(comma, "."))
    return found
known = {"ada@x.org", "zoe@x.org", "aldo@x.org", "one@x.org", "two@x.org"}
assert grades("points", rows[1:], known) == 'nobody has the address eve; "x\\', rows
rows_known = rows[1:2] + rows[4:6]
assert grades("points", rows_known, known) == {"ada@x.org": 8, "zoe@x.org": 0, "aldo@x.org": 0}, rows
assert grades("00_2 points", rows_known, known) == {"ada@x.org": 8, "zoe@x.org": 0, "aldo@x.org": None}, rows
assert rows[5] == ["Absent Aldo", "aldo@x.org", "0", "missing", "-", "", "", "", "missing", "-", "", "", ""], rows[5]
END
}
if command -v python3 >/dev/null; then
    check 'the table is read by another program' reads '' , utf-8 .
    check 'with semicolons' reads semicolon ';' utf-8 .
    check 'with tabs' reads tab $'\t' utf-8 .
    check 'as Excel expects it where the comma is for decimals' reads excel ';' utf-8-sig ,
    check 'and where it is not' reads 'excel comma' , utf-8-sig .
fi
summary() { diff build/marks/summary.txt - <<'END'
00_2: 4 answers, 1 right, 3 wrong; on average 2.67 of 8 points
     1  to look at
     1  do not run
     2  fail: the picture with --time 1
     2  fail: the rays of nine of its pixels
     1  fail: the picture with --time 4

00_3: 0 answers, 0 right, 0 wrong; on average 0 of 2.5 points
END
}
check 'the summary says which comparisons fail most often' summary
feedback() {
    local page="build/marks/feedback/finn.html"
    [ "$(ls build/marks/feedback)" = $'Ada Lovelace_123_assignsubmission_file.html\neve; _x_.html\nfinn.html\nzoe@x.org.html' ] &&
        grep -q '^<p>Matches the solution in 2 pictures: no pixel differs ' build/marks/feedback/Ada*.html &&
        grep -q '<h2>Exercise 00_2: wrong, 2.67 of 8 points</h2>' $page && grep -q "Your picture differs from the solution's: with --time 1, .* differ " $page &&
        grep -q '<li>right: the picture with --time 4$' $page && grep -q '<li class="fails">wrong: the picture with --time 1$' $page &&
        [ "$(grep -c '<img alt="" src="data:image/png;base64,iVBOR' $page)" = 2 ] && ! sed 's/base64,[^"]*//' $page | grep 'build/\|Ada\|tmp/'
}
check 'each student has a page with the pictures in it, which names nobody else' feedback
pixels() { # the picture in the page is that of the difference
    sed -n 's/.*base64,\([^"]*\)".*lighter where.*/\1/p' build/marks/feedback/finn.html | base64 -d | cmp - build/marks/2.difference.png
}
check 'the last of them is the difference' pixels
unset WEIGHTS STUDENTS
class=$outer

# ---- The engine ----

if [ -x build/first_steps/engine_6 ]; then
    outer=$class class=$scratch/engine
    step=chapters/first_steps/engine_6.c
    patch -s -o "$scratch/right.c" $step chapters/solutions/engine_1.diff
    sed 's/double time = 0.0;/puts("drawing"); &/' "$scratch/right.c" | hand_in ada engine_1.c
    hand_in ben engine_1.c <$step
    echo '#include "../ada/engine_1.c"' | hand_in cleo engine_1.c
    echo 'int main(void) { return 0; }' | hand_in dan 'my engine-1.c'
    sed 's/WIDTH = 640/WIDTH = 320/' "$scratch/right.c" | hand_in finn engine_1.c
    sed 's/double time = 0.0;/double time = 2.0;/' "$scratch/right.c" | hand_in gil engine_1.c
    printf '#include "main.h"\n' | hand_in hal engine_1.c
    hand_in hal main.h <"$scratch/right.c"
    printf '#include <unistd.h>\nint main(void)\n{\n    for (;;)\n        pause();\n}\n' | hand_in ida engine_1.c
    CHECK_LIMIT=1 check 'programs for the engine are marked' marks "$class/*/*.c" 'engine_1 00_2' || sed 's/^/# /' "$scratch/said"
    check 'a right program is right, whatever it prints' has ada engine_1 right 1 'the published solution' '' 'matches .*'
    check 'the unsolved engine is named' has ben engine_1 wrong 0 '' 'the engine, unchanged' 'with -o FILE.png -t 0.7 .* ends with status 2, .*'
    check 'a program does not see the files of another student' has cleo engine_1 wrong 0 '' 'asks for ../ada/engine_1.c, which is not its own' 'does not compile: engine_1.c:1:.*'
    check 'a program that writes no picture is wrong' has dan engine_1 wrong 0 '' '' '.* writes no picture that can be read'
    check 'so is one that writes a picture of another size' has finn engine_1 wrong 0 'the published solution' '' 'with -t 0.7 .*, the picture has 320x360 pixels instead of 640x360'
    check 'one that mends one thing and breaks another gains nothing' has gil engine_1 wrong 0 'the published solution' '' 'with chapters/00_first_scene.frag, .* differ .*'
    check 'a program sees the files of its student' has hal engine_1 right 1 'the published solution' '' 'matches .*'
    check 'a program that waits for ever is wrong' has ida engine_1 wrong 0 '' '' '.* the program does not end, .*'
    programs() {
        grep -q '^     4  fail: what the program does with -o FILE.png chapters/00_first_scene.frag$' build/marks/summary.txt &&
            grep -q '^<p>Your program does not compile. The first message is: <code>engine_1.c:1:' build/marks/feedback/cleo.html
    }
    check 'the summary and the pages name what programs do' programs
    class=$outer
else
    skip 'the marks of the engine' 'this machine has no GLFW or no EGL'
fi

# ---- Requests that are refused ----

refuses() { # WORDS FILES EXERCISES CSV
    marks "${@:2}"
    [ $? = 2 ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q -e "$1" "$scratch/said"
}
check 'a command without exercises is refused' refuses 'which exercises' x ''
check 'an exercise without a solution is refused' refuses 'EXERCISES: 00_9: no solution' x '00_2 00_9'
check 'a command without files is refused' refuses 'which files' '' 00_2
for line in '00_2' '00_2 x' '00_2 -1' '00_2 1 2' 'zero 1'; do
    printf '00_3 1\n%s\n' "$line" >"$scratch/weights"
    WEIGHTS=$scratch/weights check "weights with the line '$line' are refused" refuses 'weights: line 2: must be an exercise and its points' "$class/*/*.frag" 00_2
done
WEIGHTS=$scratch/absent check 'weights that do not exist are refused' refuses 'WEIGHTS=.*cannot be read' "$class/*/*.frag" 00_2
CSV_STYLE='excel, comma' check 'an unknown style is refused' refuses 'CSV_STYLE=excel, comma: must be' "$class/*/*.frag" 00_2
STUDENTS=$scratch/absent check 'a list that does not exist is refused' refuses 'STUDENTS=.*cannot be read' "$class/*/*.frag" 00_2
STUDENTS=$scratch/list.csv IDENTIFIER=number check 'a column that the list does not have is refused, and its columns are named' refuses 'IDENTIFIER to one of these titles: First name, Last name, Email address' "$class/*/*.frag" 00_2
: >"$scratch/empty.csv"
STUDENTS=$scratch/empty.csv check 'an empty list is refused' refuses 'STUDENTS=.*the file is empty' "$class/*/*.frag" 00_2
printf 'student;mail\na;b\n' >"$scratch/other.csv"
STUDENTS=$scratch/other.csv check 'the table does not replace the list' refuses 'this is the list of students' "$class/*/*.frag" 00_2 "$scratch/other.csv"
check 'a pattern that matches no file is refused' refuses 'no such file' "$class/eve/*" 00_2

# ---- What the table may replace ----

victim=$class/copy/00_2.frag
cp "$victim" "$scratch/before"
ln -s "$victim" "$scratch/link.csv"
ln "$victim" "$scratch/hard.csv"
spares() { refuses "$@" && cmp -s "$scratch/before" "$victim"; }
check 'the table does not replace a file that was handed in' spares 'handed in' "$class/*/*.frag" 00_2 "$victim"
check 'nor by another path' spares 'handed in' "$class/*/*.frag" 00_2 "$class/twin/../copy/00_2.frag"
check 'nor through a link' spares 'handed in' "$class/*/*.frag" 00_2 "$scratch/link.csv"
check 'nor through a hard link' spares 'handed in' "$class/*/*.frag" 00_2 "$scratch/hard.csv"
check 'the table replaces no other file either' refuses 'not a table of marks' "$class/twin/*.frag" 00_2 "$right"
unwritable() { refuses "^make: $1: cannot be written: " "$class/twin/*.frag" 00_2 "$1"; }
check 'a table that is a folder is refused' unwritable /
check 'a table that is a device is refused' unwritable /dev/null
check 'a table in a folder that does not exist is refused' unwritable "$scratch/absent/marks.csv"
cp "$scratch/marks.csv" "$scratch/old.csv"
nameless() { refuses 'none of these names contains one of the exercises 00_2 00_3' "$class/nameless/*.frag" '00_2 00_3' && cmp -s "$scratch/old.csv" "$scratch/marks.csv"; }
check 'if no name contains an exercise, one line says so, and the old table stays' nameless
printf '\357\273\277"student";"00_2"\r\n' >"$scratch/sheet.csv" # as a spreadsheet saves it
ln -s sheet.csv "$scratch/linked.csv"
linked() { marks "$class/twin/*.frag" 00_2 "$scratch/linked.csv" && [ -L "$scratch/linked.csv" ] && grep -q '^"twin",0,wrong' "$scratch/sheet.csv"; }
check 'an old table is replaced where a link leads to it' linked
others() { marks "$class/twin/*.frag" 00_2 build/marks/one.csv && marks "$class/twin/*.frag" 00_2 build/marks/two.csv && cmp build/marks/one.csv build/marks/two.csv; }
check 'other tables in build/marks stay' others
cp "$scratch/before" build/marks/00_2.frag
check 'a file in build/marks is not deleted' spares 'copy the file to another place' 'build/marks/*.frag' 00_2
rm build/marks/00_2.frag

# ---- Names that are not plain ----

class="$scratch/names"
number=0
for name in $'\r=1+1' ' =2+2' '＝3' -n -e '@x' $'\e[31mred' $'bell\a' $'Zo\xeb' $'Zo\xef' $'\xc2\x9b1m' $'turned\xe2\x80\xae' 'back\slash' '%s' '<i>&' "$(printf 'x%.0s' {1..255})"; do
    number=$((number + 1))
    printf 'fault %d\n' $number | hand_in "$name" 00_2.frag
done
cat >"$scratch/expected" <<'END'
"' =2+2"
"%s"
"'-e"
"'-n"
"<i>&"
"'@x"
"Zo\xeb"
"Zo\xef"
"\x0d=1+1"
"\x1b[31mred"
"\xc2\x9b1m"
"back\slash"
"bell\x07"
"turned\xe2\x80\xae"
END
printf '"%s"\n' "$(printf 'x%.0s' {1..255})" >>"$scratch/expected"
echo "\"'＝3\"" >>"$scratch/expected"
named() { marks "$class/*/00_2.frag" 00_2 && sed '1d; s/,0,wrong,0,"","","does not run.*//' "$scratch/marks.csv" | diff "$scratch/expected" -; }
check 'every student has a row, whatever the name' named
clean() { # true if the files contain no control characters, and only UTF-8
    ! grep -n '[[:cntrl:]]' "$@" && iconv -f UTF-8 -t UTF-8 "$@" >/dev/null
}
check 'the table, the page and the messages contain no control characters, and only UTF-8' clean "$scratch/marks.csv" build/marks/index.html "$scratch/said"
check 'the page shows signs of HTML as they are' grep -q '<td>&lt;i&gt;&amp;<td>' build/marks/index.html
wrong() { # a picture is wrong, and a list of scenes cannot contain its name
    class=$scratch/listed
    hand_in $'a\rb' 00_2.frag <chapters/00_first_scene.frag
    hand_in c 00_2.frag <chapters/00_first_scene.frag
    marks "$class/*/*.frag" 00_2 && [ "$(grep -c '^make: .*a.x0db/00_2.frag: a list of scenes cannot contain this name' "$scratch/said")" = 1 ] &&
        [ "$(build/lecture --print build/marks/wrong.txt | wc -l)" = 1 ] && clean build/marks/wrong.txt
}
check 'a wrong picture whose name is not plain is reported, and the others are listed' wrong
plan

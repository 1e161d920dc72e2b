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
row() { grep -q -e "$1" "$scratch/marks.csv" || { sed 's/^/# /' "$scratch/marks.csv"; return 1; }; }
check 'a class is marked' marks "$class/*/*.frag" '00_2 00_3'
check 'a row has a mark, whose text is the same and a remark for each exercise' row "^\"Zoë \"\"O'Neil\"\"\",right,\"\",\"\",\"matches the solution.*\",right,\"\",\"\",\"matches the solution.*\"$"
check 'a wrong solution is marked, and a folder name that a spreadsheet would read as a formula is escaped' row "^\"'=cmd()\",wrong,\"\",\"the chapter, unchanged\",\".* differ .*\",missing,\"\",\"\",\"\"$"
check 'a file that includes the published solution is the same as that' row '^"include",wrong,"the published solution","","does not run: .*#version in an included file'
check 'the same text from two students is recognised, whatever its names, blanks and comments' row '^"twin",wrong,"the other twin","","does not run: '
check 'a few words are nobody'"'"'s' row '^"idle",wrong,"","the chapter, unchanged",".* differ .*",wrong,"","","does not run'
check 'two files of one student are not compared' row '^"again",wrong wrong,"","","does not run'
check 'a pipe is refused without waiting for it' row '^"pipe",wrong,"","","not a regular file"'
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
    marks "$class/*/00_2.frag" 00_2 && grep -q 'N for the next one: make lecture LIST=build/marks/wrong.txt$' "$scratch/said" &&
        build/lecture --print build/marks/wrong.txt >"$scratch/scenes" && [ "$(wc -l <"$scratch/scenes")" = 3 ] &&
        [ "$(grep -c 'frag. --compare chapters/solutions/00_first_scene_2.frag .*, on the left: .* differ ' "$scratch/scenes")" = 3 ]
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
one_folder() { cp "$class/copy/00_2.frag" "$scratch/ada_00_2.frag" && marks "$scratch/*.frag" 00_2 && row '^"ada",right,'; }
check "in a single folder, the student's name is taken from the name of the file" one_folder

# ---- Whose text is the same ----

# like TEXT...: prints what likeness.awk says of the answers of as many students, 'a' to 'z', separated by '|'. $course
# and $solution are texts of the course.
course='' solution='a solution'
like() {
    local text student=({a..z}) number=0
    {
        printf '\001course\n%s\001chapter\t00_2\t\nint mine; #define mine\n\001solution\t00_2\t\n%s' "$course" "$solution"
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
check 'an answer does not see the files of another student' row '^"ben",wrong,"","asks for ../ada/00_2.frag, which is not its own","does not run: 00_2.frag:1: '
check 'not even through a link' row '^"cleo",wrong,"","asks for part.glsl, which is not its own",'
check 'nor in a folder that several share' row '^"gil",wrong,"","asks for ada/00_2.frag, which is not its own",'
check 'nor below its own folder' row '^"hal",wrong,"","asks for inner/00_2.frag, which is not its own",'
check 'it sees the files of its student' row '^"dan",right,"","",'
check 'a picture that was handed in is named' row '^"eve",missing,"","","",right,"","reads the picture my own.png, which was handed in with it",'
check 'so is an answer that is right only at the times of the check' row '^"finn",right,"","draws what the check compares, but with --size 656x369 --time [0-9.]*, .* differ .*","matches'
check 'all others have nothing to look at' row '^"ada",right,"","","matches'
alone() { cp "$class/gil_00_2.frag" "$scratch/alone.frag" && rm -r "$class" && hand_in . ada_00_2.frag <$right && sed 's/ada./ada_/' "$scratch/alone.frag" | hand_in . gil_00_2.frag && marks "$class/*.frag" 00_2 && row '^"gil",wrong,"","asks for ada_00_2.frag, which is not its own",'; }
check 'in a single folder, an answer sees only itself' alone
class=$outer

# ---- Requests that are refused ----

refuses() { # WORDS FILES EXERCISES CSV
    marks "${@:2}"
    [ $? = 2 ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q -e "$1" "$scratch/said"
}
check 'a command without exercises is refused' refuses 'which exercises' x ''
check 'an exercise without a solution is refused' refuses 'EXERCISES: 00_9: no solution' x '00_2 00_9'
check 'a command without files is refused' refuses 'which files' '' 00_2
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
linked() { marks "$class/twin/*.frag" 00_2 "$scratch/linked.csv" && [ -L "$scratch/linked.csv" ] && grep -q '^"twin",wrong' "$scratch/sheet.csv"; }
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
named() { marks "$class/*/00_2.frag" 00_2 && sed '1d; s/,wrong,"","","does not run.*//' "$scratch/marks.csv" | diff "$scratch/expected" -; }
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

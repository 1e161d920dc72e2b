#!/bin/bash
# marks.sh - tests `make marks`: the table of a class whose folder names contain blanks, accents and quotes, the copies
# that it finds, and the requests that it refuses. check.sh tests the verdict on a single file.
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
echo 'one fault' | hand_in twin 00_2.frag
echo 'one /* */ fault // here' | hand_in 'the other twin' 00_2.frag
hand_in nameless ball.frag <$right
hand_in idle 00_2.frag <chapters/00_first_scene.frag
for name in '00-2 first' '00-2 last'; do echo 'one thing twice' | hand_in again "$name.frag"; done
mkdir -p "$class/pipe" && mkfifo "$class/pipe/00_2.frag"
hand_in odd $'00_2\n.frag' <$right

marks() { FILES=$1 EXERCISES=$2 CSV=${3-$scratch/marks.csv} .make/marks.sh >"$scratch/said" 2>&1; }
row() { grep -q -e "$1" "$scratch/marks.csv" || { sed 's/^/# /' "$scratch/marks.csv"; return 1; }; }
check 'a class is marked' marks "$class/*/*.frag" '00_2 00_3'
check 'a row has a mark and a remark for each exercise' row "^\"Zoë \"\"O'Neil\"\"\",right,\"matches the solution.*\",right,\"matches the solution.*\"$"
check 'a wrong solution is marked, and a folder name that a spreadsheet would read as a formula is escaped' row "^\"'=cmd()\",wrong,\".* differ .*\",missing,\"\"$"
check 'the published solution is recognised, however its blanks and comments are changed' row '^"copy",copied,"the published solution; '
check 'a file that includes the published solution is recognised' row '^"include",copied,"the published solution; '
check 'the same text from two students is marked as copied' row '^"twin",copied,"the same text: the other twin, twin; does not run: '
check "two students' unsolved chapters are not copies" row '^"idle",wrong,".* differ '
check "two files of one student are not copies" row '^"again",wrong wrong,"does not run'
check 'a pipe is refused without waiting for it' row '^"pipe",wrong,"not a regular file"'
check 'a file whose name contains a line break is reported, and the others are marked' grep -q 'odd/00_2.*the name has a tab or a line break' "$scratch/said"
check 'the table has no other rows' [ "$(wc -l <"$scratch/marks.csv")" = 10 ]
check 'a file whose name contains no exercise is reported' grep -q 'nameless/ball.frag: its name contains none of 00_2 00_3, so the file is not marked' "$scratch/said"
check 'the marks are counted' grep -q '^9 students; answers: 2 right, 5 wrong, 4 copied$' "$scratch/said"
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
one_folder() { cp "$class/copy/00_2.frag" "$scratch/ada_00_2.frag" && marks "$scratch/*.frag" 00_2 && row '^"ada",copied,'; }
check "in a single folder, the student's name is taken from the name of the file" one_folder
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
named() { marks "$class/*/00_2.frag" 00_2 && sed '1d; s/,wrong,"does not run.*//' "$scratch/marks.csv" | diff "$scratch/expected" -; }
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

#!/bin/bash
# names.sh - gives the commands names and files that nobody expects: control characters, options, links, pipes, folders,
# devices, full disks. Each must end with the right status, print one line if it fails, print nothing that a terminal
# could take for a command, and lose no file.
# shellcheck disable=SC2016,SC2059,SC2154
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/stand_ins.sh
open_scratch
make_project
tools='' moments=''

# ---- What must hold ----

# plainly: neither output has a control character, a byte that is not UTF-8, or a line of more than 2,000 bytes.
plainly() {
    cat "$scratch/out" "$scratch/err" >"$scratch/both"
    ! tr -d '\n' <"$scratch/both" | grep '[[:cntrl:]]' && iconv -f UTF-8 -t UTF-8 "$scratch/both" >"$scratch/copy" && ! grep -E '.{2000}' "$scratch/both"
}
sums() { (cd "$project" && find . -type f -exec cksum {} + | LC_ALL=C sort); }
# gives STATUS LINES NAME COMMAND...: the command ends with this status, after this many lines on standard error. No file
# goes or changes, except those whose names match $may, and nothing is left over.
may=nothing as=()
gives() { check "$3" answers "$1" "$2" "${@:4}"; }
answers() {
    local status=$1 lines=$2 got
    shift 2
    sums >"$scratch/sums"
    (within ${as[@]+"${as[@]}"} "$@") >"$scratch/out" 2>"$scratch/err" </dev/null
    got=$?
    sums | LC_ALL=C comm -13 - "$scratch/sums" | grep -vE " [.]/($may)\$" >"$scratch/lost"
    [ $got = "$status" ] && [ "$(grep -c '' "$scratch/err")" = "$lines" ] && plainly && [ ! -s "$scratch/lost" ] &&
        [ -z "$(find "$project" -name '.ray-marching.*')" ] && return
    echo "# status $got, lines $(grep -c '' "$scratch/err"), lost: $(cat -v "$scratch/lost")"
    cat -v "$scratch/out" "$scratch/err" | cut -c 1-300 | sed 's/^/# /'
    return 1
}
cd "$project" || exit 1
mkdir chapters/figures && echo '// a figure' >chapters/figures/01_a.frag

# ---- Names that are not plain, of things that do not exist ----

bad=$'no\e[31m\r\a\b\x7f\xe9\x9b\xc2\x9b\xe2\x80\xae\xed\xa0\x80.such'
long=$(printf 'x%.0s' {1..5000})
for name in "$bad" $'two\nlines' "$long" -n -e --help -- - '$(id)' '%s%n' "it's" 'a"b' ' ' '*' /dev/null/x ../../../../../x; do
    shown=$(printf '%.20q' "$name")
    gives 1 0 "make check FILE=$shown" env EXERCISE=00_2 FILE="$name.frag" .make/check.sh
    gives 2 1 "make marks FILES=$shown" env EXERCISES=00_2 FILES="$name/00_2.frag" .make/marks.sh
    gives 1 1 "make play FILE=$shown" env FILE="$name.frag" .make/play.sh
    gives 1 1 "make bake MESH=$shown" env MESH="$name.obj" .make/bake.sh
    gives 1 1 "make slides LIST=$shown" env LIST="$name.txt" .make/slides.sh
done
for name in "$bad" $'two\nlines' "$long" -n '$(id)' '00_2 ' ../00_2; do
    shown=$(printf '%.20q' "$name")
    gives 2 1 "make check EXERCISE=$shown" env EXERCISE="$name" FILE=x .make/check.sh
    gives 2 1 "make marks EXERCISES=$shown" env EXERCISES="$name" FILES='answers/*' CSV=x/y .make/marks.sh
    gives 1 1 "make run CHAPTER=$shown" env CHAPTER="$name" .make/run.sh
    gives 1 2 "make run FIGURE=$shown" env FIGURE="$name" .make/run.sh
    gives 1 1 "make film CHAPTER=$shown" env CHAPTER="$name" .make/film.sh
    gives 1 1 "make diff CHAPTER=$shown" env CHAPTER="$name" .make/diff.sh
    gives 1 1 "make benchmark CHAPTER=$shown" env CHAPTER="$name" .make/benchmark.sh
    gives 2 1 "make references CHAPTER=$shown" env CHAPTER="$name" tests/pictures/references.sh update
    gives 1 1 "make chapter NAME=$shown" env NAME="$name" .make/chapter.sh
    gives 2 1 "make questions of $shown" env QUESTIONS="$name" .make/questions.sh
    gives 1 1 "make docs of $shown" .make/listings.sh "$name.md"
    gives 2 1 "make mutants FILES=$shown" env FILES="${name// /_}" .make/mutants.sh
    gives 2 1 "make fuzz DURATION=$shown" env DURATION="$name" .make/fuzz.sh
done

# ---- Files with such names ----

touch ./-l.txt ./-m.obj ./-a.png ./-b.png
for name in -n -e --help $'esc\e[31m' $'\r=1+1' 'two  blanks' "it's" '$(id)' '`id`' '%s' 'a=b' '*' $'Zo\xeb' "$(printf 'x%.0s' {1..250})"; do
    echo 'int answer;' >"./$name.frag"
    mkdir -p "hand-in/$name" && printf 'int answer = %q;\n' "$name" >"hand-in/$name/00_2.frag"
done
may='build/.*|\./-m.png|marks.csv|-marks.csv'
shown() { printf '%.20q' "$1"; }
for file in *.frag; do
    lines=0
    case $file in *[![:print:]]* | *[$'\x80'-$'\xff']*) lines=1 ;; esac # a list of scenes cannot contain the name
    gives 1 $lines "make check of $(shown "$file")" env EXERCISE=00_2 FILE="$file" .make/check.sh
done
gives 1 3 'make check of all these names' env EXERCISE=00_2 FILES='*.frag' .make/check.sh
gives 0 3 'make marks of folders with these names' env EXERCISES=00_2 FILES='hand-in/*/*.frag' CSV=-marks.csv .make/marks.sh
rows() { [ "$(wc -l <-marks.csv)" = 15 ] && grep -q "^\"'-n\",0,wrong" ./-marks.csv && grep -q "^\"'-e\",0,wrong" ./-marks.csv && ! grep '[[:cntrl:]]' ./-marks.csv; }
check 'every student has a row' rows
in_folder() { (cd hand-in && for name in *; do mv "./$name" ..; done); }
in_folder
gives 0 3 'make marks of folders that begin with a hyphen, and of an exercise that is named twice' env EXERCISES='00_2 00_2' FILES='*/00_2.frag' CSV=-marks.csv .make/marks.sh
check 'they have the same rows' rows
gives 0 0 'make bake MESH=-m.obj' env MESH=-m.obj .make/bake.sh
gives 0 0 'make slides LIST=-l.txt' env LIST=-l.txt .make/slides.sh
gives 0 0 'make lecture LIST=-l.txt' env LIST=-l.txt .make/lecture.sh
gives 2 1 'make lecture NOTES=printer' env NOTES=printer .make/lecture.sh
gives 1 0 "make compare PICTURES='-a.png -b.png'" env PICTURES='-a.png -b.png' .make/compare.sh
for file in -n.frag --help.frag $'esc\e[31m.frag'; do
    gives 0 0 "make play FILE=$(shown "$file")" env FILE="$file" .make/play.sh
done

# ---- Things that are no files ----

ln -s nowhere dangling.frag
ln -s circle.frag circle.frag
mkfifo pipe.frag
mkdir folder.frag
: >empty.frag
printf 'a\0b\n' >nul.frag
for file in dangling circle pipe folder; do
    gives 1 0 "make check FILE=$file.frag" env EXERCISE=00_2 FILE=$file.frag .make/check.sh
    gives 2 1 "make questions of a $file" env QUESTIONS=$file.frag .make/questions.sh
    gives 1 1 "make docs of a $file" .make/listings.sh $file.frag
done
gives 1 0 'make check FILE=/dev/zero' env EXERCISE=00_2 FILE=/dev/zero .make/check.sh
gives 1 0 'make check of a file with a zero byte' env EXERCISE=00_2 FILE=nul.frag .make/check.sh
mkdir odd && mv ./*.frag odd
gives 2 1 'make marks if no name has the exercise' env EXERCISES='00_2 00_3' FILES='odd/*.frag' CSV=marks.csv .make/marks.sh

# ---- Targets ----

for table in . odd /dev/null absent/marks.csv README.md answers/ada_00_2.frag "$PWD/answers/../answers/ben_00_2.frag" "$long"; do
    gives 2 1 "make marks CSV=$(shown "$table")" env EXERCISES=00_2 FILES='answers/*' CSV="$table" .make/marks.sh
done
ln -s loop.csv loop.csv && mkfifo pipe.csv
for table in loop.csv pipe.csv; do
    gives 2 1 "make marks CSV=$table" env EXERCISES=00_2 FILES='answers/*' CSV=$table .make/marks.sh
done
may='build/check/.*'
mkdir -p build/marks build/check/00_2 build/slides build/lecture-scenes
echo 'int own;' | tee build/marks/00_2.frag build/check/00_2/my.frag >/dev/null
cp docs/lecture.txt build/slides/my.txt && cp docs/lecture.txt build/lecture-scenes/my.txt
gives 2 1 'make marks of a file in the folder that it writes' env EXERCISES=00_2 FILES='build/marks/*.frag' .make/marks.sh
may=nothing
gives 2 1 'make check of a file in the folder that it writes' env EXERCISE=00_2 FILE=build/check/00_2/my.frag .make/check.sh
gives 1 1 'make slides of a list in the folder that it writes' env LIST=build/slides/my.txt .make/slides.sh
gives 1 1 'make lecture of a list in the folder that it writes' env LIST=build/lecture-scenes/my.txt .make/lecture.sh
echo v >build/compare.png && ln -s build/compare.png mine.png && ln -s build/23.png 23.obj && echo v >build/23.png
gives 2 1 'make compare of the picture that it writes' env PICTURES='build/compare.png -a.png' .make/compare.sh
gives 2 1 'make compare of a link to it' env PICTURES='-a.png mine.png' .make/compare.sh
gives 2 1 'make bake of the picture that it writes' env MESH=23.obj .make/bake.sh

# The results exist already; then a folder has the name of each file, and a file that of each folder.
may='build/.*|docs/benchmark.md|docs/engine.md|docs/figures/a.svg|shaders/textures/noise.png|chapters/play.frag'
commands=('env CHAPTER=00 .make/film.sh' 'env MESH=my.obj .make/bake.sh' .make/questions.sh .make/book.sh .make/handouts.sh .make/slides.sh .make/lecture.sh .make/site.sh \
    .make/windows_zip.sh .make/web.sh .make/textures.sh '.make/figures.sh a' '.make/listings.sh docs/engine.md' 'env WRITE=1 MARCHES=1 .make/benchmark.sh' \
    'env EXERCISE=00_2 FILE=answers/ada_00_2.frag .make/check.sh' 'env EXERCISES=00_2 FILES=answers/* .make/marks.sh')
echo v >my.obj
for command in "${commands[@]}"; do
    status=0
    case $command in *check.sh) status=1 ;; esac
    # shellcheck disable=SC2086 # words
    gives $status 0 "$command" $command
done
cp -pR "$project" "$scratch/done"
fresh() { rm -rf "$project" && cp -pR "$scratch/done" "$project" && cd "$project" && new_version "$1"; } # VERSION
may=nothing
blocked() { # FILE STATUS COMMAND...
    fresh 2
    if [ -d "$1" ]; then rm -r "$1" && echo mine >"$1"; else rm "$1" && mkdir "$1" && echo mine >"$1/mine"; fi
    gives "$2" 1 "${*:3} cannot replace $1" "${@:3}"
}
may='build/film/.*'
blocked build/film/00_first_scene.mp4 1 env CHAPTER=00 .make/film.sh
may=nothing
blocked build/film/00_first_scene 1 env CHAPTER=00 .make/film.sh
blocked build/film 1 env CHAPTER=00 .make/film.sh
blocked build/my.png 1 env MESH=my.obj .make/bake.sh
blocked build/questions 1 .make/questions.sh
blocked build/questions/ray-marching.xml 1 .make/questions.sh
blocked build/book.pdf 1 .make/book.sh
blocked build/handouts-answers.pdf 1 .make/handouts.sh
blocked build/slides 1 .make/slides.sh
blocked build/lecture-scenes 1 .make/lecture.sh
blocked build/site 1 .make/site.sh
blocked build/site.zip 1 .make/site.sh
blocked build/web/course.json 1 .make/web.sh
blocked build/ray-marching-windows.zip 1 .make/windows_zip.sh
blocked docs/figures/a.svg 1 .make/figures.sh a
blocked shaders/textures/noise.png 1 .make/textures.sh
blocked docs/benchmark.md 1 env WRITE=1 MARCHES=1 .make/benchmark.sh
blocked build/marks 2 env EXERCISES=00_2 FILES='answers/*' .make/marks.sh

# ---- Tools that fail, full disks, write-protected folders ----

fails() { # COMMAND...: fails, after one line
    gives "$1" 1 "$why: ${*:2}" "${@:2}"
}
fresh 2
touch broken
why='a tool fails'
for command in .make/book.sh .make/handouts.sh .make/slides.sh .make/site.sh .make/web.sh .make/windows_zip.sh; do fails 1 $command; done
may='build/film/00_first_scene/.*'
fails 1 env CHAPTER=00 .make/film.sh
may=nothing
rm broken
why='no frames'
fails 1 env CHAPTER=00 FRAMES=0 .make/film.sh

# A limit on the size of files acts like a full disk.
fresh "$(printf '2%.0s' {1..3000})"
as=(bash -c 'trap "" XFSZ; ulimit -f 1; exec "$@"' bash)
why='a full disk'
fails 1 .make/questions.sh
fails 1 .make/figures.sh a
fails 1 .make/textures.sh
fails 1 env MESH=my.obj .make/bake.sh
fails 1 .make/listings.sh docs/engine.md
fails 1 env WRITE=1 MARCHES=1 .make/benchmark.sh
for command in .make/book.sh .make/handouts.sh .make/site.sh; do fails 1 $command; done
as=()

fresh 2
chmod -R a-w docs shaders build/questions build/film build/check answers
chmod a-w build/my.png build && chmod a-r answers/ada_00_2.frag
as=()
if [ "$(id -u)" = 0 ]; then
    chmod 711 "$scratch" && chown -R 65534:65534 "$project" "$scratch/tmp"
    as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
fi
why='write-protected'
fails 1 .make/questions.sh
fails 1 env CHAPTER=00 .make/film.sh
fails 1 env MESH=my.obj .make/bake.sh
fails 1 .make/figures.sh a
fails 1 .make/textures.sh
fails 1 .make/listings.sh docs/engine.md
fails 1 env WRITE=1 MARCHES=1 .make/benchmark.sh
fails 1 env NAME=mine .make/chapter.sh
for command in .make/book.sh .make/slides.sh .make/site.sh .make/windows_zip.sh; do fails 1 $command; done
fails 2 env EXERCISE=00_2 FILE=answers/ben_00_2.frag .make/check.sh
fails 2 env EXERCISES=00_2 FILES='answers/*' CSV=docs/marks.csv .make/marks.sh
chmod u+w build build/check
fails 2 env EXERCISE=00_2 FILE=answers/ben_00_2.frag .make/check.sh
chmod -R u+w build/check/00_2
may='build/check/.*'
gives 1 0 'make check of a file that cannot be read' env EXERCISE=00_2 FILE=answers/ada_00_2.frag .make/check.sh
chmod -R u+rwX "$project"
as=()

# ---- Contents ----

may='build/questions/.*'
questions() { # STATUS LINES NAME: of a file from standard input
    fresh 2
    cat >docs/questions.txt
    gives "$1" "$2" "make questions of $3" .make/questions.sh
}
good='## 00.1 Why?\n+ a\n- b // c\n- d // e\n'
questions 0 0 'a file with a byte order mark' < <(printf '\357\273\277'"$good")
questions 0 0 'a file with carriage returns' < <(printf "$good" | sed 's/$/\r/')
questions 0 0 'a file with control characters' < <(printf "$good" | sed 's/Why/a\x1b[31mb\x07/')
controlled() { ! grep '[[:cntrl:]]' build/questions/*; }
check 'the files of questions have no control characters' controlled
may=nothing
questions 1 1 'a file with a zero byte' < <(printf "$good\\0\n")
questions 1 1 'a file that is not text' < <(head -c 4000 "$root/build/00_first_scene" | tail -c 3000)
questions 1 1 'a long line' < <(printf "$long$long$long")
cd "$root" || exit 1
plan

# shellcheck shell=bash disable=SC2154
# stand_ins.sh - a small project in which every command that writes files runs in a moment, because stand-ins replace
# the programs, pandoc, ffmpeg and so on. A suite sources this file after tap.sh:
#
#   make_project      makes $project, with the scripts of .make/
#   new_version N     changes its sources and what the stand-ins write
#   within COMMAND... becomes a command in it
#
# A moment passes between the two halves of a result, and whenever a script starts a tool. The folder $moments gets a
# link for each, whose target is the name of the tool. At moment $AT, everybody in the group of processes gets $SIGNAL.
# A suite that needs no moments sets `moments` and `tools` to ''.

# Write a stand-in from standard input. $@ are its arguments, and halves FILE writes its result.
stand_in() { # PATH
    mkdir -p "$(dirname "$1")"
    {
        printf '#!/bin/sh\n'
        cat <<'END'
moment() { # [TOOL]
    [ -n "$moments" ] || return 0
    what=${1:-half}
    set -- "$moments"/*
    number=$#
    until ln -s "$what" "$moments/$number" 2>/dev/null; do number=$((number + 1)); done
    [ "$number" != "$AT" ] || kill -"$SIGNAL" 0
}
halves() { # FILE
    { printf 'a result of version ' && moment && cat "$project/version"; } >"$1"
}
PATH=$real_path
END
        cat
    } >"$1"
    chmod +x "$1"
}

# shellcheck disable=SC2016 # the stand-ins expand the variables
make_project() {
    local name tool
    export project=$scratch/project moments=$scratch/moments real_path=$PATH tools=$scratch/tools AT='' SIGNAL=''
    mkdir -p "$project" "$scratch/bin" "$moments" "$scratch/tmp"
    export TMPDIR=$scratch/tmp
    : >"$moments/0"
    cd "$project" || exit 1
    cp -R "$root/.make" .
    mkdir -p chapters/first_steps chapters/solutions chapters/figures docs/figures docs/web shaders/textures tests/pictures tests/course tests/shaders \
        tests/references answers build common/picture/font .ci

    cp "$root/tests/pictures/references.sh" tests/pictures

    # ---- Sources ----

    for name in 00_first_scene 01_normal_colouring 23_stored_distances; do
        printf '// a chapter\n' | tee "chapters/$name.c" >"chapters/$name.frag"
    done
    printf '// a solution\n' >chapters/solutions/00_first_scene_2.frag
    for name in clouds land night prism stored water; do printf '// %s\n' $name >shaders/$name.glsl; done
    printf '// play\n' | tee chapters/first_steps/play.frag shaders/screen.vert tests/shaders/openness.frag tests/shaders/shadows.frag >/dev/null
    printf '00_first_scene  -  \n00_first_scene  solution-2  -f chapters/solutions/00_first_scene_2.frag\n' >tests/pictures/images.txt
    printf '00_2 --time 1\nengine_1 --time 1\n' >tests/course/checks.txt
    printf '01\n    A sentence.\n' >docs/lecture.txt
    printf '<!-- benchmark -->\n<!-- /benchmark -->\n<!-- marches -->\n<!-- /marches -->\n' >docs/benchmark.md
    for name in LICENSE Makefile docs/web/live.css docs/web/LICENSE.fonts docs/web/guesses.txt common/picture/font/README tests/course/a.sh tests/course/a.mjs .ci/run \
        docs/web/site.css docs/web/site.js docs/web/find.js docs/web/guess.js docs/web/question.js docs/web/progress.js docs/web/play.js docs/web/dropped.js docs/web/edits.js docs/web/icon.svg docs/figures/a.svg \
        tests/references/a-solution-1.png shaders/textures/noise.png; do
        printf 'solutions/\n' >"$name"
    done
    printf '# none\n' >.make/student/replaced.txt
    printf '// noise\n' >shaders/textures/noise.c

    # ---- Stand-ins ----

    # A program writes a picture, the pictures of a film, or what it measures.
    stand_in build/01_normal_colouring <<'END'
case " $* " in *" --version "*) echo 1; exit ;; *benchmark=json*) printf '  "backend": "x",\n  "frame_median_gpu_ms": null,\n  "frame_median_cpu_ms": 1,\n  "first_frame_cpu_ms": 1,\n  "compile_cpu_ms": %d,\n' "$(cat "$project/version")"; exit ;; esac
frames=
while [ $# -gt 0 ]; do
    case $1 in -o | --output) file=$2 ;; --frames) frames=$2 ;; esac
    shift
done
[ -n "${file-}" ] || exit 3
# The program writes a picture beside the old one itself.
picture() { moment && { printf 'a picture of version ' && cat "$project/version"; } >"$1"; }
case $frames in
'') picture "$file" ;;
0) echo '--frames 0: must be at least 1' >&2; exit 2 ;;
*) for i in 0 1 2; do picture "$(printf "$file" "$i")"; done ;;
esac
END
    cp build/01_normal_colouring build/00_first_scene
    cp build/01_normal_colouring build/23_stored_distances
    stand_in build/tests/judge <<'END'
case $1 in
picture) halves "$5"; printf '1,2\n3\nit differs by %s\n' "$(cat "$project/version")"; exit 1 ;;
*) echo 'a ray' ;;
esac
END
    stand_in build/tests/compare <<'END'
case $1 in --pack) halves "$3" ;; --subtract) halves "$4" ;; *) echo 'largest 9'; exit 1 ;; esac
END
    stand_in build/tests/measure <<'END'
halves /dev/stdout
END
    stand_in build/lecture <<'END'
[ "$1" = --print ] || exit 3
case $2 in -*) echo "$2: no such option" >&2; exit 2 ;; esac
[ -r "$2" ] || { echo 'lecture: the list cannot be read' >&2; exit 1; }
printf '1\037part\03701_normal_colouring\037--time 0\037A sentence.\n2\037part\03701_normal_colouring\037--time 1\037A sentence.\n'
END
    # Programs that draw to their standard output, if their file, which they may have, exists.
    for name in build/shaders/textures/clay build/shaders/textures/noise build/docs/figures/a; do
        stand_in "$name" <<'END'
[ $# = 0 ] || [ -f "$1" ] || { echo 'clay: the mesh cannot be read' >&2; exit 1; }
moment && printf 'a drawing of the version ' && moment && cat "$project/version"
END
    done
    for tool in pandoc ffmpeg zip cwebp pngquant; do
        stand_in "$scratch/bin/$tool" <<'END'
[ ! -e "$project/broken" ] || { echo 'Error: broken' >&2; exit 1; }
[ "${0##*/}" = zip ] && cat >/dev/null
file=
for word; do
    [ "${before-}" != -o ] || file=$word
    before=$word
done
halves "${file:-$word}"
END
    done
    stand_in "$scratch/bin/pdfinfo" <<'END'
echo 'Pages: 1'
END
    # node SCRIPT OUT...: the site, or the packed texts.
    stand_in "$scratch/bin/node" <<'END'
[ ! -e "$project/broken" ] || { echo 'Error: broken' >&2; exit 1; }
case $1 in
*/site.mjs) for page in index one two; do halves "$2/$page.html" || exit; done ;;
*/figures_html.mjs) halves "$2/a.html" ;;
*) mkdir -p "$2/course" && halves "$2/course/a.glsl" && halves "$2/course.json" ;;
esac
END
    stand_in build/node/node_modules/.bin/esbuild <<'END'
for word; do
    case $word in
    --outdir=*) for name in live stage check program editor; do halves "${word#--outdir=}/$name.js"; done ;;
    --outfile=*) halves "${word#--outfile=}" ;;
    esac
done
END
    mkdir -p build/web/objects build/windows/tests build/windows/prefix/licences
    for name in build/web/objects/harness.js build/web/objects/harness.wasm build/windows/00_first_scene.exe build/windows/harness.dll build/windows/tests/compare.exe \
        build/windows/tests/judge.exe build/windows/prefix/licences/a.txt; do
        echo made >"$name"
    done

    # ---- Tools ----

    for tool in awk basename cat chmod cksum cmp comm cp cut date dirname du find grep gzip head ls mkdir mktemp mv od paste rm rmdir sed sort tail tar tee \
        touch tr wc xargs; do
        stand_in "$tools/$tool" <<'END'
tool=$(command -v "${0##*/}")
moment "${0##*/}"
PATH=$tools:${project%/*}/bin:$real_path
case $tool in
*/mv | */rm | */cp)
    "$tool" "$@" || exit
    PATH=$real_path
    moment done
    ;;
*) exec "$tool" "$@" ;;
esac
END
    done
    cd "$root" || exit 1
    new_version 1
}

# shellcheck disable=SC2016 # the backticks are Markdown's
new_version() { # N
    local page
    echo "$1" >"$project/version"
    for page in README docs/README docs/engine docs/platforms docs/teaching docs/00_first_scene docs/01_normal_colouring docs/23_stored_distances; do
        printf '# 00 Title\n\nText of version %s.\n' "$1" >"$project/$page.md"
    done
    printf '\n`main.glsl`:\n\n<!-- code: shaders/main.glsl * -->\n```glsl\n```\n' >>"$project/docs/engine.md"
    printf '// version %s\n' "$1" >"$project/shaders/main.glsl"
    printf '// an answer, version %s\n' "$1" >"$project/answers/ada_00_2.frag"
    printf 'int ben;\n' >"$project/answers/ben_00_2.frag"
    printf '// the chapter, version %s\n' "$1" >"$project/chapters/00_first_scene.frag"
    printf '## 00.1 Why?\n+ a%s\n- b // c\n- d // e\n' "$1" >"$project/docs/questions.txt"
}

# Become a command in the project.
within() {
    cd "$project" && PATH=${tools:+$tools:}$scratch/bin:$real_path && exec "$@"
}

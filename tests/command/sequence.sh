#!/bin/bash
# sequence.sh - tests --frames: each picture of a film is the same as a single picture at its time, an interruption
# leaves only complete files, and make film passes the pictures to ffmpeg.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/00_first_scene
small=(-s 64x36)
out=$scratch/out
mkdir "$out"

clear_out() { find "$out" -mindepth 1 -delete; }
names() { (cd "$out" && find . -type f | sed 's|^\./||' | sort | tr '\n' ' '); }

# ---- The pictures ----

row() {
    "$program" "${small[@]}" -t 1 --frames 3 --fps 4 -o "$out/f-%03d.png" >"$scratch/said" 2>&1 &&
        [ "$(names)" = 'f-000.png f-001.png f-002.png ' ] && [ ! -s "$scratch/said" ]
}
check '--frames 3 writes three pictures, and prints nothing if there is no terminal' row
each() {
    local number time
    for number in 0 1 2; do
        time=$(echo "$number" | awk '{ print 1 + $1 / 4 }')
        "$program" "${small[@]}" -t "$time" -o "$scratch/one.png" && cmp -s "$scratch/one.png" "$out/f-00$number.png" || return 1
    done
}
check 'each picture of a film is, bit for bit, the single picture at its time' each
differ() { ! cmp -s "$out/f-000.png" "$out/f-002.png"; }
check 'the first and the last picture of a film differ' differ

cat >"$scratch/inputs.frag" <<'GLSL'
void mainImage(out vec4 c, vec2 p)
{
    float k = float(iFrame);
    bool right = abs(iTime - 2.0 - 0.1 * k) < 1e-5 && abs(iDate.w - iTime) < 1e-5 &&
                 abs(iTimeDelta - (iFrame > 0 ? 0.1 : 0.0)) < 1e-6;
    c = vec4(right ? vec3(0.2 * k) : vec3(1.0, 0.0, 0.0), 1.0);
}
GLSL
inputs() {
    local number
    "$program" "${small[@]}" -f "$scratch/inputs.frag" -t 2 --frames 5 --fps 10 -o "$out/i-%d.png" || return 1
    for number in 0 1 2 3 4; do
        printf 'void mainImage(out vec4 c, vec2 p) { c = vec4(vec3(%s), 1.0); }\n' "0.2 * $number.0" >"$scratch/grey.frag"
        "$program" "${small[@]}" -f "$scratch/grey.frag" -o "$scratch/grey.png" && cmp -s "$scratch/grey.png" "$out/i-$number.png" || return 1
    done
}
check 'iFrame, iTimeDelta, iTime and iDate change from picture to picture' inputs

clear_out
parts() { # run three programs at once, as on three machines
    local part pids=()
    mkdir "$out/parts"
    "$program" "${small[@]}" -t 1 --frames 7 --fps 10 -o "$out/%02d.png" || return 1
    for part in 0-2 3-3 4-6; do
        "$program" "${small[@]}" -t 1 --frames "$part" --fps 10 -o "$out/parts/%02d.png" & pids+=($!)
    done
    for part in "${pids[@]}"; do wait "$part" || return 1; done
    [ "$(cd "$out/parts" && echo *)" = '00.png 01.png 02.png 03.png 04.png 05.png 06.png' ] || return 1
    for part in "$out"/parts/*; do cmp -s "$part" "$out/${part##*/}" || return 1; done
}
check 'three parts of a film make up, bit for bit, the whole film' parts

clear_out
default_fps() {
    "$program" "${small[@]}" --frames 26 -o "$out/%d.png" && "$program" "${small[@]}" -t 1 -o "$scratch/one.png" &&
        cmp -s "$scratch/one.png" "$out/25.png"
}
check 'a film has 25 pictures per second by default' default_fps

# A shader that keeps frames: each adds its number to the half of the last one, and is drawn after all before it.
{
    printf '#include "main.glsl"\nuniform sampler2D history; // the last frame\n'
    printf 'Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, -1.0)); }\nfloat sceneDistance(vec3 p) { return p.z; }\n'
    printf 'vec4 frameKept(vec2 p) { return 0.5 * texelFetch(history, iPixel.yx %% 36, 0) + fract(iTime * p.x * 7.1 + iDate.w); }\n'
    printf 'vec3 rayColour(Ray ray) { return 0.5 * texelFetch(history, iPixel, 0).rgb; }\n'
} >"$scratch/keeps.frag"
keeping() { "$BUILD/01_normal_colouring" "${small[@]}" -f "$scratch/keeps.frag" "$@"; }
beginnings() { # a film that begins later has the same pictures, and so has a single picture, whatever its samples
    clear_out
    keeping -t 1 --frames 10 -o "$out/a%d.png" && keeping -t 1 --frames 5-9 -o "$out/b%d.png" &&
        cmp -s "$out/a5.png" "$out/b5.png" && cmp -s "$out/a9.png" "$out/b9.png" && ! cmp -s "$out/a8.png" "$out/a9.png" &&
        [ "$(names)" = "$(printf '%s ' a0.png a1.png a2.png a3.png a4.png a5.png a6.png a7.png a8.png a9.png b5.png b6.png b7.png b8.png b9.png)" ] &&
        keeping -t 1 --frame 9 -o "$out/c.png" && cmp -s "$out/a9.png" "$out/c.png" &&
        keeping -t 1 --frame 9 --samples 2 -o "$out/d.png" && cmp -s "$out/a9.png" "$out/d.png" &&
        keeping -t 1 --frame 9 --fps 60 -o "$out/e.png" && cmp -s "$out/a9.png" "$out/e.png" &&
        keeping -t 1 --frame 9 --fps 61 -o "$out/f.png" && ! cmp -s "$out/a9.png" "$out/f.png"
}
check 'films of kept frames with different beginnings have the same pictures, at 60 per second' beginnings
single() { # without kept frames, --frame is the picture of a film with that number
    "$program" "${small[@]}" --frames 4-4 -o "$out/g%d.png" && "$program" "${small[@]}" --frame 4 -o "$out/h.png" && cmp -s "$out/g4.png" "$out/h.png"
}
check '--frame N is picture N of a film' single
settings() {
    "$BUILD/01_normal_colouring" "${small[@]}" -a 2 -v steps -p maxSteps=20 --frames 1 -o "$out/s%d.png" &&
        "$BUILD/01_normal_colouring" "${small[@]}" -a 2 -v steps -p maxSteps=20 -o "$scratch/one.png" &&
        cmp -s "$scratch/one.png" "$out/s0.png"
}
check 'samples, view and parameters apply to a film as to a single picture' settings
slices() { "$BUILD/01_normal_colouring" "${small[@]}" -v slice --probe 30,18 --frames 2 -o "$out/v%d.png"; }
check 'a film can show the slice of a selected ray' slices
walks() { # the march is shown from its first step to its last, while the time does not change
    local ray=(-v slice --probe '30,18')
    clear_out
    "$BUILD/01_normal_colouring" "${small[@]}" "${ray[@]}" --step walk --frames 20 -o "$out/w%d.png" >"$scratch/said" &&
        "$BUILD/01_normal_colouring" "${small[@]}" "${ray[@]}" --step 0 -o "$scratch/first.png" >"$scratch/march" &&
        "$BUILD/01_normal_colouring" "${small[@]}" "${ray[@]}" -o "$scratch/whole.png" >/dev/null &&
        last=$(awk -F, '/^[0-9]/ { n = $1 } END { print n }' "$scratch/march") &&
        "$BUILD/01_normal_colouring" "${small[@]}" "${ray[@]}" --step "$last" -o "$scratch/last.png" >/dev/null &&
        cmp -s "$scratch/first.png" "$out/w0.png" && cmp -s "$scratch/last.png" "$out/w19.png" &&
        ! cmp -s "$out/w0.png" "$out/w10.png" && ! cmp -s "$out/w10.png" "$out/w19.png"
}
check 'a film walks along a ray from its first step to its last' walks

few_files() { # fewer files may be open at once than the film has pictures
    clear_out
    (ulimit -n 40 && "$program" -s 16x9 --frames 60 -o "$out/%d.png") && [ "$(names | wc -w)" = 60 ]
}
if [ "${SYSTEM-}" = Windows ]; then
    skip 'a film leaves no file open' 'ulimit does not limit Windows programs'
else
    check 'a film leaves no file open' few_files
fi

# ---- Names and numbers ----

refused() { # NAME STATUS PATTERN OPTION...
    local name=$1 wanted=$2 pattern=$3 status
    shift 3
    clear_out
    "$program" "${small[@]}" "$@" >"$scratch/said" 2>&1
    status=$?
    if [ "$status" = "$wanted" ] && [ "$(grep -c '' "$scratch/said")" = 1 ] &&
        grep -q -e "$pattern" "$scratch/said" && [ -z "$(names)" ]; then
        ok "$name"
    else
        not_ok "$name" "status $status: $(cat "$scratch/said")"
    fi
}
# tests/unit/numbers.c tests the names; tests/command/options.c tests the numbers and the valid combinations.
refused 'a name without %d is refused' 2 'must contain one %d' --frames 2 -o "$out/frame.png"
refused 'a film whose last time is too large is refused' 2 'the last time' --frames 100000 --fps 0.001 -t 1e9 -o "$out/%d.png"
refused 'a missing folder is reported' 1 'nowhere' --frames 2 -o "$out/nowhere/%d.png"
taken() {
    clear_out
    mkdir "$out/1.png"
    ! "$program" "${small[@]}" --frames 3 -o "$out/%d.png" 2>"$scratch/said" && grep -q '1\.png' "$scratch/said" && [ -z "$(names)" ]
}
check 'a folder with the name of a picture is reported before any picture is written' taken
rmdir "$out/1.png"

# ---- Interrupted ----

# True if every file is a complete picture.
whole() {
    local file
    for file in "$out"/* "$out"/.[!.]*; do
        [ -e "$file" ] || continue
        case $file in *.png) "$BUILD/tests/compare" "$file" "$file" >/dev/null || return 1 ;; *) return 1 ;; esac
    done
}
# A shell starts background jobs with SIGINT ignored, and nohup starts everything with SIGHUP ignored. env can restore
# both.
heed=(env '--default-signal=INT,HUP')
"${heed[@]}" true 2>/dev/null || heed=()
interrupted() { # SIGNAL [STATUS]
    clear_out
    ${heed[@]+"${heed[@]}"} "$program" -s 320x180 --frames 5000 -o "$out/%05d.png" &
    local child=$! tries=2400 status
    while [ ! -e "$out/00003.png" ] && [ $tries -gt 0 ]; do sleep 0.05; tries=$((tries - 1)); done
    kill -"$1" $child
    wait $child 2>/dev/null
    status=$?
    [ $status = "${2-$((128 + $(kill -l "$1")))}" ] && [ -e "$out/00003.png" ] && [ ! -e "$out/04999.png" ] && whole
}
if [ "${SYSTEM-}" = Windows ]; then # Windows has only Ctrl+C, on which Wine ends any program with status 0
    for name in 'a signal during a film leaves only complete pictures' 'a lost terminal during a film leaves only complete pictures'; do skip "$name" 'Windows has no such signal'; done
    check 'Ctrl+C during a film leaves only complete pictures' interrupted INT 0
else
    check 'a signal during a film leaves only complete pictures' interrupted TERM
    check 'a lost terminal during a film leaves only complete pictures' interrupted HUP
    if [ ${#heed[@]} != 0 ]; then check 'Ctrl+C during a film leaves only complete pictures' interrupted INT; else skip 'Ctrl+C during a film leaves only complete pictures' 'env has no --default-signal'; fi
fi

clear_out
if command -v script >/dev/null && script -qec true /dev/null >/dev/null 2>&1; then
    progress() {
        # Wine's console moves the cursor to the right instead of printing a space.
        script -qec "$program -s 64x36 --frames 3 -o $out/%d.png" /dev/null </dev/null |
            sed $'s/\e\\[1C/ /g; s/\e\\[[?0-9]*[A-Za-z]//g' >"$scratch/terminal"
        grep -q '0 of 3 pictures' "$scratch/terminal" && grep -q '2 of 3 pictures' "$scratch/terminal"
    }
    check 'a terminal shows how many pictures are done' progress
else
    skip 'a terminal shows how many pictures are done' 'the command script is missing, or does not work'
fi

# ---- make film ----

mkdir "$scratch/project" "$scratch/bin" && cp -r .make chapters shaders "$scratch/project" &&
    mkdir "$scratch/project/build" && ln -s "$root/$program" "$scratch/project/build/00_first_scene"
film() { (cd "$scratch/project" && CHAPTER=00 FRAMES=3 FPS=${2-10} PATH=$1 .make/film.sh -s 65x37 >"$scratch/said" 2>"$scratch/err"); }
if command -v ffmpeg >/dev/null; then
    films() { film "$PATH" && [ -s "$scratch/project/build/film/00_first_scene.mp4" ] && [ -s "$scratch/project/build/film/00_first_scene.gif" ]; }
    check 'make film makes an MP4 and a GIF' films
    # Players require an even width and height, subsampled colour, and the index (moov) before the data (mdat).
    playable() {
        local mp4=$scratch/project/build/film/00_first_scene.mp4
        [ "$(ffprobe -v error -show_entries stream=width,height,pix_fmt,nb_frames,color_space -of csv=p=0 "$mp4")" = '64,36,yuv420p,bt709,3' ] &&
            [ "$(ffprobe -v trace "$mp4" 2>&1 | grep -oE "type:'(moov|mdat)'" | head -n 1)" = "type:'moov'" ]
    }
    check 'players accept the MP4, although the pictures have an odd size' playable
fi
mkdir "$scratch/few" && for tool in sh basename tr sed; do ln -s "$(command -v $tool)" "$scratch/few"; done
none() { ! film "$scratch/few" && grep -q 'ffmpeg is not installed: install it.*--frames 3' "$scratch/err" && [ "$(grep -c '' "$scratch/err")" = 1 ]; }
check 'make film says what to do without ffmpeg' none
# A substitute for ffmpeg that only writes its arguments to the output file, if the pictures exist.
# shellcheck disable=SC2016 # the substitute expands the variables
printf '#!/bin/sh\nfor last; do :; done\nls build/film/00_first_scene/frame-0002.png >/dev/null || exit 1\necho "$@" >"$last"\n' >"$scratch/bin/ffmpeg"
chmod +x "$scratch/bin/ffmpeg"
asks() {
    film "$scratch/bin:$PATH" && grep -q 'frame-%04d.png.*yuv420p' "$scratch/project/build/film/00_first_scene.mp4" &&
        grep -q 'framerate 10 .*paletteuse' "$scratch/project/build/film/00_first_scene.gif" &&
        grep -q '00_first_scene.gif' "$scratch/said"
}
check 'make film passes the pictures to ffmpeg twice' asks
slower() { film "$scratch/bin:$PATH" 100 && grep -q 'fps=50,' "$scratch/project/build/film/00_first_scene.gif"; }
check 'a GIF has at most 50 pictures per second' slower
prints() { # an option that prints instead of drawing pictures
    ! (cd "$scratch/project" && CHAPTER=00 FRAMES=3 FPS=10 PATH=$scratch/bin:$PATH .make/film.sh -s 65x37 --list >/dev/null 2>"$scratch/err") &&
        grep -q 'writes no pictures' "$scratch/err" && [ -e "$scratch/project/build/film/00_first_scene/frame-0002.png" ]
}
check 'make film with an option that draws nothing keeps the old pictures' prints
# A substitute for ffmpeg that writes an empty GIF, as ffmpeg does for a film of less than a picture.
# shellcheck disable=SC2016 # the substitute expands the variables
mkdir "$scratch/empty" && printf '#!/bin/sh\nfor last; do :; done\ncase $last in *.gif) : >"$last" ;; *) echo film >"$last" ;; esac\n' >"$scratch/empty/ffmpeg" && chmod +x "$scratch/empty/ffmpeg"
short() { ! film "$scratch/empty:$PATH" 1000 && grep -q 'shorter than one picture of a GIF' "$scratch/err" && [ -s "$scratch/project/build/film/00_first_scene.gif" ]; }
check 'make film refuses a film that is too short for a GIF, and keeps the old one' short
# A substitute for ffmpeg that fails halfway.
# shellcheck disable=SC2016 # the substitute expands the variables
printf '#!/bin/sh\nfor last; do :; done\necho half >"$last"\nexit 255\n' >"$scratch/bin/ffmpeg"
keeps() {
    ! film "$scratch/bin:$PATH" && grep -q 'fps=50,' "$scratch/project/build/film/00_first_scene.gif" &&
        ! grep -q half "$scratch/project/build/film/"*.* && [ "$(find "$scratch/project/build/film" -maxdepth 1 -type f | wc -l)" = 2 ]
}
check 'if ffmpeg fails halfway, the old film is kept' keeps
views() {
    ln -sf "$root/$BUILD/01_normal_colouring" "$scratch/project/build/01_normal_colouring"
    (cd "$scratch/project" && CHAPTER=01 FRAMES=6 FPS=10 VIEW=plot PATH=$scratch/bin:$PATH .make/film.sh -s 64x36 >"$scratch/said" 2>"$scratch/err")
    # The pictures are in the folder, although the substitute for ffmpeg fails.
    "$BUILD/01_normal_colouring" -s 64x36 -v plot --step 0 -o "$scratch/first.png" &&
        cmp -s "$scratch/first.png" "$scratch/project/build/film/01_normal_colouring/frame-0000.png"
}
check 'make film shows a view, and the march of its ray step by step' views

plan

#!/bin/sh
# film.sh [OPTION...] - `make film`: make an MP4 and a GIF of a chapter with ffmpeg.
#
# Environment: CHAPTER, "03" or a whole stem (if empty, the first chapter); FRAMES, the number of pictures; FPS, how
# many of them a second shows; VIEW, the view. The slice and the plot show one ray, and their films follow this ray from
# its first step to its last. The pictures stay in build/film/STEM/. If the command fails or is interrupted, the old
# pictures and the old film are kept.
set -u
. .make/write.sh
. .make/chapters.sh

stem=$(stem_of "${CHAPTER-}") || exit 1
frames=${FRAMES:-100}
fps=${FPS:-25}
view=${VIEW-}
[ -z "$view" ] || set -- --view "$view" "$@"
case $view in slice | plot) set -- --step walk "$@" ;; esac
if ! command -v ffmpeg >/dev/null; then
    fail 1 "ffmpeg is not installed: install it (apt-get, dnf or brew install ffmpeg); to write only the pictures:" \
        "build/$stem --frames $frames --fps $fps -o frame-%04d.png"
fi

begin build/film || exit 1
mkdir "$new/$stem" && "build/$stem" "$@" --frames "$frames" --fps "$fps" -o "$new/$stem/frame-%04d.png" || exit 1
[ -n "$(find "$new/$stem" -name '*.png' -print -quit)" ] || fail 1 "$*: with these options, build/$stem writes no pictures: leave out the option that prints"
keep "$stem" || exit 1

# Players expect colours at half the resolution, which requires an even width and height. The file states which
# conversion of colours it uses; otherwise players would guess it from the size.
ffmpeg -nostdin -loglevel error -y -framerate "$fps" -i "build/film/$stem/frame-%04d.png" \
    -vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int' -pix_fmt yuv420p \
    -color_range tv -colorspace bt709 -color_primaries bt709 -color_trc bt709 \
    -c:v libx264 -crf 18 -movflags +faststart "$new/$stem.mp4" || exit 1
# A GIF has 256 colours, which are chosen for this film. Browsers slow down a GIF of more than 50 pictures a second.
rate=$(printf '%s\n' "$fps" | awk '{ print ($1 > 50 ? 50 : $1) }')
ffmpeg -nostdin -loglevel error -y -framerate "$fps" -i "build/film/$stem/frame-%04d.png" \
    -filter_complex "fps=$rate,split[a][b];[a]palettegen[colours];[b][colours]paletteuse" \
    -loop 0 "$new/$stem.gif" || exit 1
[ -s "$new/$stem.gif" ] || fail 1 "FRAMES=$frames FPS=$fps: shorter than one picture of a GIF, which shows at most 50 a second: give more frames, or a smaller FPS"
keep "$stem.mp4" "$stem.gif" || exit 1
echo "build/film/$stem.mp4"
echo "build/film/$stem.gif"

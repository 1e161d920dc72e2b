#!/bin/sh
# film.sh [OPTION...] - `make film`: a chapter as an MP4 and a GIF, by ffmpeg.
#
# Environment: CHAPTER, "03" or a whole stem, the first one where it is empty; FRAMES and FPS, how
# many pictures and how many a second; VIEW, what they show. Slice and plot show one ray: in their films
# it goes from its first step to its last. The pictures stay in build/film/STEM/. A film that is
# interrupted leaves the old one as it was.
set -u
. .make/chapters.sh

stem=$(stem_of "${CHAPTER-}") || exit 1
frames=${FRAMES:-100}
fps=${FPS:-25}
view=${VIEW-}
[ -z "$view" ] || set -- --view "$view" "$@"
case $view in slice | plot) set -- --step walk "$@" ;; esac
folder=build/film/$stem
film=build/film/$stem
part=$film.part

if ! command -v ffmpeg >/dev/null; then
    echo "make film: ffmpeg is not installed: install it (apt-get, dnf or brew install ffmpeg); the pictures alone:" \
        "build/$stem --frames $frames --fps $fps -o frame-%04d.png" >&2
    exit 1
fi

trap 'rm -f "$part.mp4" "$part.gif"' EXIT
trap 'exit 130' INT
trap 'exit 143' HUP TERM

mkdir -p "$folder" && rm -f "$folder"/frame-*.png || exit 1
build/"$stem" "$@" --frames "$frames" --fps "$fps" -o "$folder/frame-%04d.png" || exit 1

# Halved colour, which players expect, needs an even width and height. Colours are converted as the file
# says that they are; players guess otherwise, by the size.
ffmpeg -nostdin -loglevel error -y -framerate "$fps" -i "$folder/frame-%04d.png" \
    -vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int' -pix_fmt yuv420p \
    -color_range tv -colorspace bt709 -color_primaries bt709 -color_trc bt709 \
    -c:v libx264 -crf 18 -movflags +faststart "$part.mp4" || exit 1
# A GIF has 256 colours: those of this film. Browsers slow down one of more than 50 pictures a second.
rate=$(echo "$fps" | awk '{ print ($1 > 50 ? 50 : $1) }')
ffmpeg -nostdin -loglevel error -y -framerate "$fps" -i "$folder/frame-%04d.png" \
    -filter_complex "fps=$rate,split[a][b];[a]palettegen[colours];[b][colours]paletteuse" \
    -loop 0 "$part.gif" || exit 1
mv "$part.mp4" "$film.mp4" && mv "$part.gif" "$film.gif" || exit 1
echo "$film.mp4"
echo "$film.gif"

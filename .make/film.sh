#!/bin/sh
# film.sh [OPTION...] - `make film`: a chapter as an MP4 and a GIF, by ffmpeg.
#
# Environment: CHAPTER, "03" or a whole stem, the first one where it is empty; FRAMES and FPS, how
# many pictures and how many a second. The pictures stay in build/film/STEM/.
set -u
. .make/chapters.sh

stem=$(stem_of "${CHAPTER-}") || exit 1
frames=${FRAMES:-100}
fps=${FPS:-25}
folder=build/film/$stem
film=build/film/$stem

if ! command -v ffmpeg >/dev/null; then
    echo "make film: ffmpeg is not installed: install it (apt-get install ffmpeg, dnf install ffmpeg," >&2
    echo "brew install ffmpeg) and say make film again. The pictures alone need none:" >&2
    echo "  build/$stem --frames $frames --fps $fps -o frame-%04d.png" >&2
    exit 1
fi

mkdir -p "$folder" && rm -f "$folder"/frame-*.png || exit 1
build/"$stem" "$@" --frames "$frames" --fps "$fps" -o "$folder/frame-%04d.png" || exit 1

# Halved colour, which players expect, needs an even width and height.
ffmpeg -loglevel error -y -framerate "$fps" -i "$folder/frame-%04d.png" \
    -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -c:v libx264 -pix_fmt yuv420p -crf 18 \
    -movflags +faststart "$film.mp4" || exit 1
# A GIF has 256 colours: those of this film.
ffmpeg -loglevel error -y -framerate "$fps" -i "$folder/frame-%04d.png" \
    -filter_complex 'split[a][b];[a]palettegen[colours];[b][colours]paletteuse' \
    -loop 0 "$film.gif" || exit 1
echo "$film.mp4"
echo "$film.gif"

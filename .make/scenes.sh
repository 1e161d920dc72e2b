# shellcheck shell=sh
# scenes.sh - sourced by the scripts that need the pictures of a lecture's scenes.

# draw_scenes LIST FOLDER: draw the picture of each scene of a list, FOLDER/01.png and so on, and write the
# output of build/lecture --print for the list to FOLDER/scenes. Fails if a scene cannot be drawn.
draw_scenes() {
    mkdir -p "$2" && build/lecture --print "$1" >"$2/scenes" || return
    while IFS=$(printf '\037') read -r number _ stem options _; do
        picture=$2/$(printf '%02d' "$number").png
        # xargs splits the options into words as build/lecture does. --overlay is removed, because it would draw the
        # window's overlay into the picture.
        printf '%s\n' "--size 1280x720 $options" | sed 's/ --overlay[^ ]*//' | xargs "build/$stem" --output "$picture" || return
        echo "  $picture"
    done <"$2/scenes"
}

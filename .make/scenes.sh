# shellcheck shell=sh
# scenes.sh - sourced by the scripts that need the pictures of a lecture's scenes.
. .make/write.sh

# draw_scenes LIST NAME: begin with a folder in build/, and draw the picture of each scene of a list, NAME/01.png and so
# on, in $new. The output of build/lecture --print for the list is NAME/scenes. Ends the script if a scene cannot be
# drawn.
draw_scenes() {
    list=$1 folder=$2
    case $list in -*) list=./$list ;; esac # a name, not an option
    ! is_in "build/$folder" "$list" || fail 1 "LIST=$list: the folder build/$folder is written anew: copy the list to another place"
    begin build || exit 1
    mkdir "$new/$folder" && build/lecture --print "$list" >"$new/$folder/scenes" || exit 1
    while IFS=$(printf '\037') read -r number _ stem options _; do
        picture=$folder/$(printf '%02d' "$number").png
        # xargs splits the options into words as build/lecture does. --overlay is removed, because it would draw the
        # window's overlay into the picture.
        printf '%s\n' "--size 1280x720 $options" | sed 's/ --overlay[^ ]*//' | xargs "build/$stem" --output "$new/$picture" || exit 1
        echo "  build/$picture"
    done <"$new/$folder/scenes"
}

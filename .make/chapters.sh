# shellcheck shell=sh
# chapters.sh - read by the other scripts here: which chapters there are, and what runs them. They read and
# print the same in every language.
export LC_ALL=C

stems() {
    for file in chapters/[0-9][0-9]_*.c; do
        basename "$file" .c
    done
}

# stem_of NAME: the stem of 03, 3 or 03_shadows; the first one of no name.
stem_of() {
    for stem in $(stems); do
        case $stem in
        "$1" | "$1"_* | 0"$1"_*) echo "$stem"; return ;;
        esac
        [ -z "$1" ] && { echo "$stem"; return; }
    done
    printf 'make: CHAPTER=%s: no such chapter: there are %s\n' "$1" \
        "$(stems | tr '\n' ' ' | sed 's/ $//; s/ /, /g')" >&2
    return 1
}

# in_window PROGRAM OPTION...: run it, and end with its status; come back only where it wants a window and none can
# be opened, which the program alone knows: status 3.
in_window() {
    "$@"
    status=$?
    [ "$status" = 3 ] || exit "$status"
    echo 'No window can be opened here: rendering into files instead.'
}

# in_file NAME PROGRAM OPTION...: a picture in build/gallery/.
in_file() {
    picture=build/gallery/$1.png
    shift
    mkdir -p build/gallery && "$@" -o "$picture" || exit 1
    echo "  $picture"
}

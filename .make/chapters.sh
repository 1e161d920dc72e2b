# shellcheck shell=sh
# chapters.sh - defines the list of chapters and functions that run them, and is sourced by other scripts here. It also
# sets LC_ALL, so that the scripts behave the same in every language.
. .make/names.sh

stems() {
    for file in chapters/[0-9][0-9]_*.c; do
        basename "$file" .c
    done
}

# stem_of NAME: print the stem of the chapter with this name, such as 3, 03 or 03_shadows; if NAME is empty, print the
# stem of the first chapter.
stem_of() {
    for stem in $(stems); do
        case $stem in
        "$1" | "$1"_* | 0"$1"_*) echo "$stem"; return ;;
        esac
        [ -z "$1" ] && { echo "$stem"; return; }
    done
    report "CHAPTER=$1: no such chapter: the chapters are $(stems | tr '\n' ' ' | sed 's/ $//; s/ /, /g')"
    return 1
}

# in_window PROGRAM OPTION...: run the program and exit with its status; return only if it needs a window and none can
# be opened. Only the program can find this out; its status is then 3.
in_window() {
    "$@"
    status=$?
    [ "$status" = 3 ] || exit "$status"
    echo 'No window can be opened here: rendering into files instead.'
}

# in_file NAME PROGRAM OPTION...: render a picture into build/gallery/.
in_file() {
    picture=build/gallery/$1.png
    shift
    mkdir -p build/gallery && "$@" -o "$picture" || exit 1
    echo "  $picture"
}

# write_table NAME FILE: in docs/benchmark.md, replace the table between the comments NAME and /NAME with that of FILE.
write_table() {
    # shellcheck disable=SC2016 # the dollar is awk's
    write docs/benchmark.md awk -v name="$1" -v table="$2" '
        $0 == "<!-- " name " -->" { print; while ((getline line < table) > 0) print line; skip = 1; next }
        $0 == "<!-- /" name " -->" { skip = 0 }
        !skip { print }' docs/benchmark.md && echo 'docs/benchmark.md: written'
}

# shellcheck shell=sh
# write.sh - the one way in which the scripts here write files. A result is made beside the old one and renamed at the
# end, so its name always denotes the old result or the new one, whole. If a command fails or is interrupted, the old
# result stays, and whatever else the command has made is removed.
#
#   write FILE COMMAND...        replace a file with what a command prints
#   begin FOLDER; keep NAME...   make files and folders in $new, and then move them to FOLDER
#
# Both fail after a message. A script may set `scratch` to a folder and `child` to a process in the background: they
# end with the script. Functions with a body in brackets run in a process of their own, so that their variables are
# their own, and so that ignored signals have their effect once the function is done.
. .make/names.sh
unset CDPATH # with it, cd might print a folder

new='' part='' scratch='' child=''
discard() {
    trap '' HUP INT PIPE TERM
    if [ -n "$child" ] && kill "$child" 2>/dev/null; then wait "$child" 2>/dev/null; fi
    for each in "$new" "$part" "$scratch"; do [ -z "$each" ] || rm -rf "$each"; done
    new='' part='' scratch='' child=''
}
trap discard EXIT
# A second signal must not end `discard`. bash 5.2 may carry out a trap while it expands $(...). It then takes the text
# for the inside of the brackets; without the bracket it would report an error and go on with the script. Any other
# shell ends before it reads that line.
bracket='
)'
for each in 'HUP 129' 'INT 130' 'PIPE 141' 'TERM 143'; do
    # shellcheck disable=SC2064 # expanded now
    trap "trap '' HUP INT PIPE TERM; exit ${each#* }$bracket" "${each% *}"
done

# follow FILE: set `to` to the file that a path denotes, with a folder before its name, following links even to missing
# files.
follow() {
    to=$1 links=40
    while [ -L "$to" ] && [ "$links" -gt 0 ]; do
        link=$(readlink "$to") links=$((links - 1))
        case $link in /*) to=$link ;; *) to=${to%"${to##*/}"}$link ;; esac
    done
    case $to in */*) ;; *) to=./$to ;; esac
}

# target FILE: set `to` to the file that writing to FILE replaces or creates. Fails, after a message, if no file can be
# written there.
target() {
    follow "$1"
    set -- "$1" "${to##*/}"
    if [ -d "$to" ] || [ -z "$2" ]; then
        why='it is a folder'
    elif [ -L "$to" ]; then
        why='its links lead in a circle'
    elif [ ${#2} -gt 255 ]; then
        why='its name is too long'
    elif [ -e "$to" ] && [ ! -f "$to" ]; then
        why='it is not a regular file'
    elif [ ! -d "${to%/*}/" ]; then
        why="the folder ${to%/*}/ does not exist"
    elif [ ! -w "${to%/*}/" ] || { [ -e "$to" ] && [ ! -w "$to" ]; }; then
        why='it is write-protected'
    else
        return 0
    fi
    report "$1: cannot be written: $why"
    return 1
}

# is_in FOLDER FILE: true if a file, or the file that a link denotes, is in a folder, which replacing the folder would
# delete.
is_in() {
    follow "$2"
    outer=$(cd "$1" 2>/dev/null && pwd -P) && inner=$(cd "${to%/*}/" 2>/dev/null && pwd -P) || return 1
    case $inner/ in "$outer"/*) ;; *) return 1 ;; esac
}

# sweep FOLDER: remove what killed commands have left in a folder. A folder that was killed between its two renames gets
# its name back.
sweep() (
    set +f
    for left in "$1"/.ray-marching.*; do
        process=${left#"$1"/.ray-marching.}
        process=${process%.*}
        case $process in '' | *[!0-9]*) continue ;; esac
        ! kill -0 "$process" 2>/dev/null || continue
        for old in "$left"/*.old; do
            name=$1/${old##*/}
            [ ! -e "$old" ] || [ -e "${name%.old}" ] || mv "$old" "${name%.old}"
        done
        rm -rf "$left" 2>/dev/null
    done
)

write() {
    target "$1" || return
    shift
    sweep "${to%/*}"
    part=${to%/*}/.ray-marching.$$.part
    failed=0
    cp -p "$to" "$part" 2>/dev/null || : # the new file has the owner and the permissions of the old one
    said=$({ "$@" >"$part"; } 2>&1 && trap '' HUP INT PIPE TERM && mv -f "$part" "$to" 2>&1) || failed=$?
    # Many tools do not say that the disk is full.
    if [ "$failed" != 0 ] && ! { head -c 4096 /dev/zero >>"$part"; } 2>/dev/null; then
        case $to in "${new:-/}"/*) to=${new%/*}${to#"$new"} ;; esac
        said="make: $to: cannot be written: the disk is full"
    fi
    [ -z "$said" ] || printf '%s\n' "$said" | while IFS= read -r line; do plain "$line"; done >&2
    rm -f "$part"
    part=
    return "$failed"
}

begin() {
    if ! mkdir -p "$1" 2>/dev/null || [ ! -w "$1" ]; then
        report "$1: cannot be written: it is no folder, or it is write-protected"
        return 1
    fi
    sweep "$1"
    new=$1/.ray-marching.$$.new
    rm -rf "$new" && mkdir "$new"
}

keep() (
    trap '' HUP INT PIPE TERM
    place=${new%/*}
    for name; do
        if [ ! -e "$new/$name" ]; then
            report "$place/$name: was not made"
            return 1
        elif [ ! -d "$new/$name" ]; then
            target "$place/$name" || return
        elif [ -e "$place/$name" ] && [ ! -d "$place/$name" ]; then
            report "$place/$name: cannot be written: it is not a folder"
            return 1
        fi
    done
    for name; do
        if [ -L "$place/$name" ] && [ ! -d "$new/$name" ]; then
            write "$place/$name" cat "$new/$name" || return
            continue
        elif [ ! -d "$new/$name" ]; then
            mv -f "$new/$name" "$place/$name"
        elif [ ! -e "$place/$name" ] || mv "$place/$name" "$new/$name.old"; then
            mv "$new/$name" "$place/$name" || { mv "$new/$name.old" "$place/$name" && false; }
        else
            false
        fi 2>/dev/null && continue
        report "$place/$name: cannot be written: it is write-protected"
        return 1
    done
)

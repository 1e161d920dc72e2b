# shellcheck shell=sh
# written.sh - knows which files of the course for students `make student` has written. Everything else there is the
# lecturer's. Sourced by the scripts that change or remove the folder.

# sums FOLDER: print a line for each file in a folder: checksum, size, name. The history and what was built are left
# out.
sums() {
    (cd "$1" && find . \( -path ./.git -o -path ./build \) -prune -o -type f -print0 | xargs -0 cksum) | sort
}

# added FOLDER LIST: print the name of a file in a folder that is not in a list of sums, or whose contents differ.
# Prints nothing if there is no such file.
added() {
    [ ! -e "$1/.git" ] || { echo .git && return; }
    sums "$1" | comm -23 - "$2" | sed -n '1s/^[0-9]* [0-9]* [.]\///p'
}

#!/bin/bash
# fresh.sh - `make test-fresh`: do the README's two commands work on a machine that has nothing?
#
# For each release a bare root, as debootstrap makes it, with only git and make added: without them nobody
# has the project or types a command. It is kept as an archive, and unpacked anew for each try. Into it
# goes a clone of what is committed here. Twice: root types the commands; then, in another root, a reader
# who may install nothing hands the command that `make run` prints to root, and goes on. A try passes when
# each command ends well, tests passed, none failed, and none was skipped that tests/skipped.txt does not
# name. What the commands printed is in build/fresh/.
#
# Nothing of this machine is seen inside: a mount and a process namespace of its own, with a proc, a
# tmpfs on /dev/shm and terminals of its own. /dev is never mounted: its files are nodes in the root.
# Both namespaces end with this script, and the mounts with them.
#
# Environment: TRIES, RELEASE:root or RELEASE:reader each, else both on Debian 12 and 13; SID=1 adds both
# on sid, which reports and does not judge;
# MIRROR, else the one that this machine's apt uses; XDG_CACHE_HOME.
set -u
export LC_ALL=C

tries=${TRIES:-bookworm:root bookworm:reader trixie:root trixie:reader}
[ -z "${SID-}" ] || tries="$tries sid:root sid:reader"
for try in $tries; do
    case $try in
    *?:root | *?:reader) ;;
    *) echo "make test-fresh: TRIES=$try: say RELEASE:root or RELEASE:reader" >&2; exit 2 ;;
    esac
done
archives=${XDG_CACHE_HOME:-$HOME/.cache}/ray-marching/fresh
logs=$PWD/build/fresh
limit=1800 # seconds for a command: it guards against what never ends

if [ "$(id -u)" != 0 ]; then
    echo 'make test-fresh: it makes bare machines with debootstrap, which only root can: sudo make test-fresh' >&2
    exit 1
fi

# ---- Ending ----

inside= # what runs in namespaces of its own, by its process
roots=$(mktemp -d "${TMPDIR:-/tmp}/fresh.XXXXXX") || exit 1

end() {
    [ -z "$inside" ] || { kill -9 "$inside" && wait "$inside"; } 2>/dev/null
    # What was killed may write its last while this looks.
    rm -rf --one-file-system "$roots" "$archives"/*.part || { sleep 1 && rm -rf --one-file-system "$roots"; }
}
trap end EXIT
trap 'exit 130' INT
trap 'exit 143' HUP TERM

# isolated COMMAND...: in a mount and a process namespace of its own; what is left running ends with it.
# In the background, for a shell that waits for it hears a signal at once.
isolated() {
    unshare --mount --pid --fork --kill-child "$@" </dev/null &
    inside=$!
    wait "$inside"
    local status=$?
    inside=
    return "$status"
}

# within ROOT USER SCRIPT: run it there, as a login of USER would. The root takes the place of this
# machine's, whose files and mounts are then gone from the namespace. Its first process collects the orphans
# of all others, so it stays a shell.
within() {
    # shellcheck disable=SC2016 # for the shell inside
    isolated sh -c '
        mount --bind "$1" "$1" && mount -t proc proc "$1/proc" && mount -t tmpfs -o mode=1777 tmpfs "$1/dev/shm" &&
            mount -t devpts -o newinstance,ptmxmode=666 devpts "$1/dev/pts" &&
            cd "$1" && pivot_root . . && umount -l . && cd / || exit 1
        home=$(sed -n "s|^$2:.*:\(.*\):.*|\1|p" /etc/passwd)
        timeout -k 5 "$4" chroot --userspec="$2:$2" / /usr/bin/env -i HOME="$home" USER="$2" LOGNAME="$2" SHELL=/bin/sh \
            PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd; $3"
        exit $?' within "$1" "$2" "$3" "$limit"
}

# ---- Bare roots ----

# This machine's sources of Debian's own packages: LABEL to ask for (Debian, Debian-Security).
source_of() {
    # shellcheck disable=SC2016 # apt's own names
    apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(REPO_URI)' 'Created-By: Packages' |
        sed -n "s,^Debian|$1|\(.*[^/]\)/*\$,\1,p" | head -n 1
}

mirror=${MIRROR:-$(source_of Debian)}
security=$(source_of Debian-Security)
[ -n "$mirror" ] || {
    echo "make test-fresh: this machine's apt knows no source of Debian: say MIRROR=URL" >&2
    exit 1
}

settings() { # ROOT RELEASE: apt inside finds what apt here finds
    {
        echo "deb $mirror $2 main"
        [ "$2" = sid ] || echo "deb $mirror $2-updates main"
        [ "$2" = sid ] || [ -z "$security" ] || echo "deb $security $2-security main"
    } >"$1/etc/apt/sources.list"
    apt-config dump | grep -E '^Acquire::(https?::|Check-)' >"$1/etc/apt/apt.conf.d/50here"
    cp -rT /etc/apt/auth.conf.d "$1/etc/apt/auth.conf.d" 2>/dev/null
    cp -L /etc/resolv.conf /etc/hosts "$1/etc"
}

# archive RELEASE: make it where there is none, or one that is older than a month.
archive() {
    local file=$archives/$1.tar.gz root=$roots/$1
    [ -z "$(find "$file" -mtime -30 2>/dev/null)" ] || return 0
    mkdir -p "$archives"
    printf '%-24s a bare root is made, once\n' "$1"
    eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
    export http_proxy https_proxy
    isolated debootstrap --variant=minbase --include=ca-certificates,git,make "$1" "$root" "$mirror" \
        >"$logs/$1-debootstrap.log" 2>&1 &&
        chroot "$root" useradd --create-home reader &&
        rm -rf "$root"/var/cache/apt/archives/*.deb "$root"/var/lib/apt/lists/* &&
        tar -C "$root" --one-file-system -cf - . | gzip -1 >"$file.part" &&
        mv "$file.part" "$file"
    local status=$?
    rm -rf --one-file-system "$root"
    return "$status"
}

# unpack RELEASE USER: a root in $root, with a clone that USER owns.
unpack() {
    root=$roots/$1-$2
    local home=$root/root
    [ "$2" = root ] || home=$root/home/$2
    mkdir "$root" && tar -C "$root" -xzf "$archives/$1.tar.gz" && settings "$root" "$1" &&
        git clone -q . "$home/course" && chroot "$root" chown -R "$2:$2" "${home#"$root"}/course"
}

# ---- The two commands ----

commands() { # those that the README names, and no others
    awk '/^## / { here = /Two commands/ } here && /^make / { sub(/ *#.*/, ""); print }' README.md
}

passed=0 failed=0 skipped=0

# step RELEASE WHO WHAT COMMAND...: run, keep what it printed, print a line. Its log is $log.
step() {
    local status start=$SECONDS
    log=$logs/$1-$2-${3//[^a-z]/-}.log
    "${@:4}" >"$log" 2>&1
    status=$?
    verdict "$status" "$1" "$2" "$3" "$((SECONDS - start)) s"
}

verdict() { # STATUS RELEASE WHO WHAT TEXT
    local word=ok
    if [ "$1" = 0 ]; then
        passed=$((passed + 1))
    elif [ "$2" = sid ]; then
        word='failed, which is not judged'
        skipped=$((skipped + 1))
    else
        word=FAILED
        failed=$((failed + 1))
    fi
    printf '%-10s %-7s %-28s %s, %s\n' "$2" "$3" "$4" "$word" "$5"
    [ "$1" = 0 ] || tail -n 25 "$log" | sed 's/^/    /'
    return "$1"
}

# The last line of `make test` counts; every skipped test is in the list, with its reason.
sound_tests() { # RELEASE LOG
    local counts line name unknown=0
    counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$2" | tail -n 1)
    [[ $counts =~ ^[1-9][0-9]*\ passed,\ 0\ failed, ]] || { echo "no count of tests that all passed: $counts"; return 1; }
    while read -r line; do
        name=${line#*- }
        name=${name%% # SKIP*}
        awk -F ' *[|] *' -v at="$1" -v name="$name" '$1 == at && $2 == name { found = 1 }
            END { exit !found }' tests/skipped.txt || { echo "skipped, and not in the list: $name"; unknown=1; }
    done < <(grep -E '^ +(not )?ok .*# *SKIP' "$2")
    [ "$unknown" = 0 ]
}

tests_of() { # ROOT RELEASE USER COMMAND: `make test`, and its counts
    within "$1" "$3" "cd course && $4" && sound_tests "$2" "$log"
}

# two_commands RELEASE USER
two_commands() {
    local command
    while read -r command; do
        case $command in
        *test*) step "$1" "$2" "$command" tests_of "$root" "$1" "$2" "$command" || return 1 ;;
        *) step "$1" "$2" "$command" within "$root" "$2" "cd course && $command" || return 1 ;;
        esac
    done < <(commands)
}

# The user's first command fails and prints, on a line of its own, what root is to type.
hand_over() { # RELEASE
    local command
    within "$root" reader 'cd course && make run' && { echo 'It did not ask for anything.'; return 1; }
    command=$(sed -n 's/^  \(.*apt-get.*\)/\1/p' "$log")
    [ -n "$command" ] || { echo 'It printed no command.'; return 1; }
    within "$root" root "$command"
}

mkdir -p "$logs" && rm -f "$logs"/*.log
for try in $tries; do
    release=${try%:*} user=${try#*:}
    log=$logs/$release-debootstrap.log
    archive "$release" || { verdict 1 "$release" - 'debootstrap' "see $log"; continue; }
    unpack "$release" "$user" || { verdict 1 "$release" "$user" 'unpacking' "$archives/$release.tar.gz, $root"; continue; }
    { [ "$user" = root ] || step "$release" reader 'one command for root' hand_over "$release"; } &&
        two_commands "$release" "$user"
    rm -rf --one-file-system "$root"
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ] && [ "$passed" != 0 ]

#!/bin/bash
# fresh.sh - `make test-fresh`: check that the README's two commands work on a bare machine.
#
# For each release, debootstrap makes a bare root file system, to which only git, make and certificates are added,
# because a reader needs them to fetch the project and to type a command. The file system is kept as an archive. For
# each try, the archive is unpacked, and a clone of the last commit is added. In the first kind of try, the user root
# types the commands. In the second, a reader who may not install packages gives root the command that `make run`
# prints, and then continues. A try passes if every command succeeds, at least one test passes, none fails, and every
# skipped test is listed in tests/lib/skipped.txt. Only a few suites are run, which together need every package of both
# commands; ALL=1 runs the whole `make test`. The output of the commands is in build/fresh/.
#
# A third kind of try, with ALL=1, imitates a machine in the cloud. It runs the commands of
# .devcontainer/devcontainer.json and then, in the course for students, the commands of its workflow with a right answer
# and a check of a wrong one.
#
# A fourth kind, also with ALL=1, runs `make test-web`: it builds the site with the release's own Emscripten and pandoc,
# and tests it in the release's own browsers.
#
# A try sees nothing of this machine: it has its own mount and process namespaces, its own /proc and terminals, and
# its own tmpfs on /dev/shm. /dev is never mounted; its files are nodes in the root file system. Both namespaces end
# with this script, and the mounts with them.
#
# Environment: TRIES, a list of RELEASE:root, RELEASE:reader, RELEASE:cloud and RELEASE:web, by default the first two on
# Debian 12 and 13, and with ALL=1 the others on Debian 13; SID=1, to add the first two on sid, whose failures are
# printed but do not count; MIRROR, Debian's mirror, by default the one that this machine's apt uses; XDG_CACHE_HOME, the
# folder for the archives, by default ~/.cache.
set -u
export LC_ALL=C

tries=${TRIES:-bookworm:root bookworm:reader trixie:root trixie:reader${ALL:+ trixie:cloud trixie:web}}
[ -z "${SID-}" ] || tries="$tries sid:root sid:reader"
for try in $tries; do
    case $try in
    *?:root | *?:reader | *?:cloud | *?:web) ;;
    *) echo "make test-fresh: TRIES=$try: must be RELEASE:root, RELEASE:reader, RELEASE:cloud or RELEASE:web" >&2; exit 2 ;;
    esac
done
archives=${XDG_CACHE_HOME:-$HOME/.cache}/ray-marching/fresh
logs=$PWD/build/fresh
limit=7200 # seconds for a command, in case it never ends

if [ "$(id -u)" != 0 ]; then
    echo 'make test-fresh: only root can make bare machines with debootstrap: sudo make test-fresh' >&2
    exit 1
fi

# Each release is tried in a separate process, because a package manager keeps at most one processor busy.
releases=$(echo "$tries" | tr ' ' '\n' | sed '/^$/d; s/:.*//' | sort -u)
if [ "$(echo "$releases" | wc -l)" != 1 ]; then
    status=0
    trap 'kill $(jobs -p) 2>/dev/null' EXIT
    trap 'exit 130' INT
    trap 'exit 143' HUP TERM
    for release in $releases; do
        TRIES=$(echo "$tries" | tr ' ' '\n' | grep "^$release:") "$0" &
    done
    for job in $(jobs -p); do
        wait "$job" || status=1
    done
    exit $status
fi

# ---- Cleaning up ----

inside= # the isolated process, if one is running
roots=$(mktemp -d "${TMPDIR:-/tmp}/fresh.XXXXXX") || exit 1

end() {
    [ -z "$inside" ] || { kill -9 "$inside" && wait "$inside"; } 2>/dev/null
    # A process that was killed may still be writing.
    rm -rf --one-file-system "$roots" "$archives/$releases.part" || { sleep 1 && rm -rf --one-file-system "$roots"; }
}
trap end EXIT
trap 'exit 130' INT
trap 'exit 143' HUP TERM

# isolated COMMAND...: run a command in separate mount and process namespaces; processes that it leaves behind end with
# it. The command runs in the background, because a shell that waits for a background process reacts to a signal at
# once.
isolated() {
    unshare --mount --pid --fork --kill-child "$@" </dev/null &
    inside=$!
    wait "$inside"
    local status=$?
    inside=
    return "$status"
}

# within ROOT USER SCRIPT: run the script in ROOT, as a login shell of USER would. ROOT replaces the root of this
# machine, whose files and mounts then no longer exist in the namespace. The first process must collect all orphans,
# so it remains a shell.
within() {
    # shellcheck disable=SC2016 # the inner shell expands the variables
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

# source_of LABEL: print the address from which this machine's apt gets Debian's packages with this label (Debian or
# Debian-Security).
source_of() {
    # shellcheck disable=SC2016 # apt expands the names
    apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(REPO_URI)' 'Created-By: Packages' |
        sed -n "s,^Debian|$1|\(.*[^/]\)/*\$,\1,p" | head -n 1
}

mirror=${MIRROR:-$(source_of Debian)}
security=$(source_of Debian-Security)
[ -n "$mirror" ] || {
    echo "make test-fresh: this machine's apt has no source for Debian: give one with MIRROR=URL" >&2
    exit 1
}

settings() { # ROOT RELEASE: give apt in ROOT the settings of this machine's apt
    {
        echo "deb $mirror $2 main"
        [ "$2" = sid ] || echo "deb $mirror $2-updates main"
        [ "$2" = sid ] || [ -z "$security" ] || echo "deb $security $2-security main"
    } >"$1/etc/apt/sources.list"
    apt-config dump | grep -E '^Acquire::(https?::|Check-)' >"$1/etc/apt/apt.conf.d/50here"
    cp -rT /etc/apt/auth.conf.d "$1/etc/apt/auth.conf.d" 2>/dev/null
    cp -L /etc/resolv.conf /etc/hosts "$1/etc"
}

# archive RELEASE: make the archive if there is none, or if it is older than a month.
archive() {
    local file=$archives/$1.tar.gz root=$roots/$1
    [ -z "$(find "$file" -mtime -30 2>/dev/null)" ] || return 0
    mkdir -p "$archives"
    printf '%-24s making a bare root, which is kept for a month\n' "$1"
    eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
    export http_proxy https_proxy
    isolated debootstrap --variant=minbase --include=ca-certificates,git,make "$1" "$root" "$mirror" \
        >"$logs/$1-debootstrap.log" 2>&1 &&
        chroot "$root" useradd --create-home reader &&
        rm -rf "$root"/var/cache/apt/archives/*.deb "$root"/var/lib/apt/lists/* &&
        tar -C "$root" --one-file-system -cf - . | gzip -1 >"$archives/$1.part" &&
        mv "$archives/$1.part" "$file"
    local status=$?
    rm -rf --one-file-system "$root"
    return "$status"
}

# unpack RELEASE USER: unpack a root into a folder, add a clone that USER owns, and set root to the folder's path.
unpack() {
    root=$roots/$1-$2
    local home=$root/root
    [ "$2" = root ] || home=$root/home/$2
    mkdir "$root" && tar -C "$root" -xzf "$archives/$1.tar.gz" && settings "$root" "$1" &&
        git clone -q . "$home/course" && chroot "$root" chown -R "$2:$2" "${home#"$root"}/course"
}

# ---- The two commands ----

commands() { # print exactly the commands that the README names
    awk '/^## / { here = /Two commands/ } here && /^make / { sub(/ *#.*/, ""); print }' README.md
}

passed=0 failed=0 skipped=0

# step RELEASE WHO WHAT COMMAND...: run the command, keep its output in $log, and print a line.
step() {
    local status start=$SECONDS
    log=$logs/$1-$2-${3//[^a-z]/-}.log
    "${@:4}" >"$log" 2>&1
    status=$?
    verdict "$status" "$1" "$2" "$3" "$((SECONDS - start)) s"
}

# Print from the output of tests/run what it says about the suites that failed; from any other output, the end.
shown() {
    if grep -q '^FAILED: ' "$log"; then
        awk '/^[^ ].* FAILED/ { on = 1; print; next } /^[^ ]/ { on = 0 } on || /^FAILED: /' "$log"
    else
        tail -n 25 "$log"
    fi
}

verdict() { # STATUS RELEASE WHO WHAT TEXT
    local word=ok
    if [ "$1" = 0 ]; then
        passed=$((passed + 1))
    elif [ "$2" = sid ]; then
        word='failed, which does not count'
        skipped=$((skipped + 1))
    else
        word=FAILED
        failed=$((failed + 1))
    fi
    printf '%-10s %-7s %-28s %s, %s\n' "$2" "$3" "$4" "$word" "$5"
    [ "$1" = 0 ] || shown | sed 's/^/    /'
    return "$1"
}

# two_commands RELEASE USER: run both commands of the README, as steps.
two_commands() {
    local command
    while read -r command; do
        case $command in
        *test*)
            [ -n "${ALL-}" ] || command="$command SUITE='camera context picture report run'"
            step "$1" "$2" "$command" within "$root" "$2" "cd course && SKIPPED=$1 $command" || return 1
            ;;
        *) step "$1" "$2" "$command" within "$root" "$2" "cd course && $command" || return 1 ;;
        esac
    done < <(commands)
}

# The user's first command must fail and print, on a separate line, the command that root then types.
hand_over() { # RELEASE
    local command
    within "$root" reader 'cd course && make run' && { echo 'make run did not ask for anything.'; return 1; }
    command=$(sed -n 's/^  \(.*apt-get.*\)/\1/p' "$log")
    [ -n "$command" ] || { echo 'make run printed no command.'; return 1; }
    within "$root" root "$command"
}

# Print the command NAME of .devcontainer/devcontainer.json, and those of the workflow in the course for students.
devcontainer() { # NAME
    sed -n "s/^ *\"$1\": \"\(.*\)\",*\$/\1/p" .devcontainer/devcontainer.json
}
workflow() {
    awk '/^ *- run: / { sub(/^ *- run: /, ""); printf "%s%s", n++ ? " && " : "", $0 }' .make/student/folder/.github/workflows/check.yml
}
cloud() { # RELEASE
    local course=course/build/student/ray-marching
    step "$1" cloud 'devcontainer, create' within "$root" root "cd course && $(devcontainer onCreateCommand)" &&
        step "$1" cloud 'devcontainer, afterwards' within "$root" root "cd course && $(devcontainer postCreateCommand)" &&
        step "$1" cloud 'make student' within "$root" root 'cd course && EXERCISES=00_2 make student' &&
        step "$1" cloud 'workflow, a right answer' within "$root" root "cp course/chapters/solutions/00_first_scene_2.frag $course/answers/00_2.frag && cd $course && $(workflow)" &&
        step "$1" cloud 'workflow, a wrong answer' within "$root" root "cd $course && cp chapters/00_first_scene.frag answers/00_2.frag && ! answers/check.sh"
}

mkdir -p "$logs" && rm -f "$logs/$releases"-*.log
for try in $tries; do
    release=${try%:*} user=${try#*:}
    log=$logs/$release-debootstrap.log
    archive "$release" || { verdict 1 "$release" - 'debootstrap' "see $log"; continue; }
    case $user in cloud | web) user=root ;; esac
    unpack "$release" "$user" || { verdict 1 "$release" "$user" 'unpacking' "$archives/$release.tar.gz, $root"; continue; }
    case ${try#*:} in
    cloud) cloud "$release" ;;
    web) step "$release" web 'make test-web' within "$root" root 'cd course && make test-web' ;;
    *)
        { [ "$user" = root ] || step "$release" reader 'one command for root' hand_over "$release"; } &&
            two_commands "$release" "$user"
        ;;
    esac
    rm -rf --one-file-system "$root"
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ] && [ "$((passed + skipped))" != 0 ]

#!/bin/bash
# run.sh - tests tests/run itself with suites that are made for this purpose: which results tests/run counts, and which
# suites it ends. This suite also tests which commands of make run one after the other.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
unset TEST_RESULTS ALL CI SKIPPED JOBS PATTERN
mkdir -p "$scratch/tests/course"
cp tests/run "$scratch/tests"

suite() { # NAME: writes the suite from standard input
    { echo '#!/bin/bash'; cat; } >"$scratch/tests/course/$1.sh"
    chmod +x "$scratch/tests/course/$1.sh"
}
# gives STATUS PATTERN [SUITE...]: running these suites, or all suites if none is named, must end with this status and
# print a line that matches the pattern.
gives() {
    local wanted=$1 pattern=$2 status
    shift 2
    TEST_LIMIT=${limit:-600} "$scratch/tests/run" "$@" >"$scratch/out" 2>&1
    status=$?
    [ "$status" = "$wanted" ] && grep -q -e "$pattern" "$scratch/out" && return
    sed 's/^/# /' "$scratch/out"
    return 1
}

suite good <<<'echo "ok 1 - a"; echo "ok 2 - b # SKIP no b"; echo 1..2'
check 'passed and skipped tests are counted' gives 0 '^1 passed, 0 failed, 1 skipped$' good
CI=1 check 'a skip is a failure in continuous integration' gives 1 'nothing may be skipped' good
check 'an unknown suite is refused' gives 2 'no such suite' bad
suite bad <<<'echo "ok 1 - a"; echo "not ok 2 - b"; echo 1..2; exit 1'
check 'failed tests are counted' gives 1 '^1 passed, 1 failed, 0 skipped$' bad
check 'the failures are repeated in the last lines' gives 1 '^FAILED: bad: not ok 2 - b$' bad
suite died <<<'echo "ok 1 - a"; kill -SEGV $$'
check 'a suite that dies is reported' gives 1 '^FAILED: died: died with status 139$' died
suite short <<<'echo "ok 1 - a"; echo 1..2'
check 'a suite that runs fewer tests than it planned is reported' gives 1 'planned 2 tests, ran 1' short
suite none <<<'exit 0'
check 'a suite that tests nothing is reported' gives 1 'ran no test' none
check 'two named suites are run' gives 1 '^2 passed, 1 failed, 1 skipped$' good bad
check 'an unknown suite beside a known one is refused' gives 2 'SUITE=worse: no such suite' good worse
check 'the results of all suites are added up' gives 1 '^4 passed, 4 failed, 1 skipped$'
# In continuous integration, one more suite fails, because the program that renders a picture under the sanitizers does
# not exist here.
CI=1 check 'the suites of continuous integration are added' gives 1 '^4 passed, 5 failed, 1 skipped$'

# A child process of the suite must end with the suite.
suite hangs <<<'echo "ok 1 - a"; sleep 1000 & echo $! >child; while :; do echo busy; sleep 0.2; done'
ended() {
    limit=2 gives 1 'no result for 2 s: ended' hangs || return
    while kill -0 "$(cat "$scratch/child")" 2>/dev/null; do sleep 0.1; done
}
check 'a suite that hangs is ended, whatever it prints' ended
# shellcheck disable=SC2016 # i is the suite's
suite slow <<<'for i in 1 2 3 4 5 6 7 8; do echo "ok $i - $i"; sleep 0.5; done; echo 1..8'
lasts() { limit=3 gives 0 '^8 passed, 0 failed' slow; }
check 'a suite that has results may take longer than the limit' lasts

# Two commands on one command line of make, such as all and tests, would compile the same files if they ran at once.
in_turn() { make -npq "$@" 2>/dev/null | grep -q '^[.]NOTPARALLEL:'; }
check 'two commands on one command line of make run one after the other' in_turn all tests
at_once() { ! in_turn "$1" && ! in_turn programs tests; }
check 'a single command of make runs in parallel, and so do two commands that only build' at_once test

plan

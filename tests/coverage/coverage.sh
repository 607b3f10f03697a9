#!/usr/bin/env bash
# Which lines and branches of src/ and cli/ the tests run, in a build that counts them:
#     coverage.sh BUILD OBJECTS JOBS
#
# Left out are suites and scripts of known answers and physics, which take long and run hardly a line that others do
# not. The tests must pass but for those of faults, as a process whose allocations fail cannot always write its counts.
# Each group of tests has counts of its own, so that a process killed while it writes spoils no others; table.awk merges
# them, counts and has the bounds. The build is optimised (-O1), without inlining, so that a loop has one copy in an
# object, and with the branches of each condition as they are written. BUILD/counts/missing lists what never runs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/../.."
build=$(realpath -e "$1") objects=$(realpath -e "$2") jobs=$3
counts=$build/counts
rm -rf "$counts" && mkdir -p "$counts/logs"
IFS=/ read -ra above <<<"${objects#/}"
GCOV_PREFIX_STRIP=${#above[@]}
export GCOV_PREFIX_STRIP GCOV_PREFIX=$counts/units
export SPH2D=$build/sph2d SPH2D_FAULTS=$build/tests CK_TIMEOUT_MULTIPLIER=10
export OMP_WAIT_POLICY=passive GCOV_ERROR_FILE=$counts/libgcov.log

suites_left_out=' elevation rest settings '
scripts_left_out=' cases '
# The long ones first, so that none runs alone at the end.
{
    for script in tests/cli/*.sh; do
        name=$(basename "$script" .sh)
        [[ $scripts_left_out == *" $name "* ]] || echo "cli_$name tests/cli/run-all $name"
    done
    echo "strangers $build/tests/strangers --command $build/sph2d --dir $build/strangers --jobs 1" \
        "--known tests/strangers/known_failures --seeds 1..20"
    echo "fuzz tests/fuzz/fuzz.sh $build/sph2d $build/fuzz $build/fuzz/found --inputs 400 --seed 3 --limit 60"
    echo "hard $build/tests/hard_cases --jobs 1 --known tests/hard/known_failures --short A"
    "$build/tests/check_all" --list | while read -r suite; do
        [[ $suites_left_out == *" $suite "* ]] || echo "units $build/tests/check_all $suite"
    done
} >"$counts/groups"

# shellcheck disable=SC2317 # called by xargs
run_group() { # run_group GROUP COMMAND...
    local group=$1 start=$EPOCHREALTIME verdict=ok
    shift
    local log=$counts/logs/$group.${*: -1}
    log=${log//[^a-zA-Z0-9_.\/-]/_}
    GCOV_PREFIX=$counts/$group "$@" >"$log" 2>&1 </dev/null || verdict=FAIL
    [ "$verdict $group" != "FAIL cli_faults" ] || verdict=part
    awk -v v="$verdict" -v n="$group ${*: -1}" -v a="$start" -v b="$EPOCHREALTIME" \
        'BEGIN { printf "%-4s %s (%.1f s)\n", v, n, b - a }'
    [ "$verdict" != FAIL ] || tail -n 20 "$log" | sed 's/^/     | /'
}
export -f run_group
export counts
# shellcheck disable=SC2016 # the inner shell's
xargs -P "$jobs" -L 1 bash -c 'run_group "$@"' _ <"$counts/groups" | tee "$counts/log"

# What a process was killed in the middle of writing is no file of gcov's: the others of its group count.
for group in "$counts"/*/; do
    [ "$group" != "$counts/logs/" ] || continue
    (cd "$objects" && find src cli -name '*.gcno' -exec cp -l --parents -t "$group" {} +)
    find "$group" -name '*.gcda' -print0 | xargs -0 -n 100000 gcov -t -b -c -r 2>>"$counts/gcov.log" || true
done >"$counts/text"
# Objects that nothing runs count, too.
find "$objects/src" "$objects/cli" -name '*.gcno' -print0 | xargs -0 -n 100000 gcov -t -b -c -r \
    >>"$counts/text" 2>>"$counts/gcov.log" || true
: >"$counts/missing"
status=0
awk -f tests/coverage/table.awk -v missing="$counts/missing" "$counts/text" || status=1
LC_ALL=C sort -t : -k 1,1 -k 2,2n -o "$counts/missing" "$counts/missing"
! grep -q '^FAIL' "$counts/log" || status=1
exit $status

#!/bin/sh
# One thread or several: the same bytes. The environment stays as it is.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
"$SPH2D" --version | grep -q '^OpenMP *yes' || exit 77

expect 0 "$SPH2D" init dam.yaml -q
# Enough particles that several threads get some.
set -- run dam.yaml -s spacing=0.008 -s run.until=0.02 -s run.snapshots.per_second=200 --no-frames --json
expect 0 "$SPH2D" "$@" -o one --threads 1 && prints '"threads": 1,'
expect 0 "$SPH2D" "$@" -o two --threads 2 && prints '"threads": 2,'
expect 0 "$SPH2D" "$@" -o many --threads 5
same one two && same one many
[ "$(find one -name '*.h5' | wc -l)" = 5 ] || fail 'not 5 snapshots'

# What OpenMP reads of the environment is for OpenMP; a list of numbers has one for regions within the step's, too.
expect 0 env OMP_NUM_THREADS=3,1 "$SPH2D" "$@" -o listed && prints '"threads": 3,' && same one listed
expect 0 env OMP_NUM_THREADS=4 OMP_THREAD_LIMIT=2 "$SPH2D" "$@" -o limited && prints '"threads": 2,' && same one limited
expect 0 env OMP_NUM_THREADS=2 OMP_WAIT_POLICY=passive OMP_PROC_BIND=true OMP_PLACES=threads OMP_DYNAMIC=true \
    "$SPH2D" "$@" -o bound && same one bound

# The command that runs is the one that was started, with the environment that it was given.
if [ -r /proc/self/environ ]; then
    env -i A=b "$SPH2D" run dam.yaml -s run.until=1e5 --no-frames --progress never -q -o endless &
    pid=$!
    await test -e endless/snapshot_000000.h5
    [ "$(tr '\0' ' ' </proc/$pid/environ)" = 'A=b ' ] || fail 'the environment was changed'
    kill $pid
    wait $pid || :
fi

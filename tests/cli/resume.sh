#!/bin/sh
# Long: a run that was stopped and goes on leaves the same folder, byte for byte, as one that never stopped.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" run "$TINY" -o whole -q "$DRAW" --set run.until=0.2

# Stopped after every single step.
code=0
"$SPH2D" run "$TINY" -o steps -q "$DRAW" --set run.until=0.2 --max-wall 0.001s >out 2>err || code=$?
present steps/checkpoint.h5 || absent steps/snapshot_000001.h5
sessions=1
while [ $code = 75 ] && [ $sessions -lt 500 ]; do
    code=0
    "$SPH2D" resume steps -q "$DRAW" --max-wall 0.001s >out 2>err || code=$?
    sessions=$((sessions + 1))
done
[ $code = 0 ] || fail "session $sessions ended with $code"
[ $sessions -gt 20 ] || fail "only $sessions sessions"
same whole steps

# Nothing left to do.
expect 0 "$SPH2D" resume steps && says 'is complete' && same whole steps
expect 0 "$SPH2D" resume steps --json && prints '"end": "complete"' && same whole steps

# A later end is reached as if it had been so from the start, but for the scene that is kept in the files.
expect 0 "$SPH2D" resume steps -q "$DRAW" --set run.until=0.24 && present steps/snapshot_000006.h5
expect 0 "$SPH2D" run "$TINY" -o longer -q "$DRAW" --set run.until=0.24
for probe in energy corner often; do
    same longer/$probe.csv steps/$probe.csv
done
same longer/snapshot_000006.h5 steps/snapshot_000006.h5
for until in 0.25 0.26 0.28; do
    expect 0 "$SPH2D" resume steps -q "$DRAW" --set run.until=$until
done
expect 0 "$SPH2D" run "$TINY" -o longest -q "$DRAW" --set run.until=0.28
same longest/snapshot_000007.h5 steps/snapshot_000007.h5

# The end of a run between two snapshots, without snapshots.
expect 75 "$SPH2D" run "$TINY" -o bare -q "$DRAW" -s run.until=0.2 -s run.snapshots.per_second=0 --max-wall 0.001s
present bare/checkpoint.h5
expect 0 "$SPH2D" resume bare -q "$DRAW" && absent bare/checkpoint.h5
expect 0 "$SPH2D" run "$TINY" -o bare2 -q "$DRAW" -s run.until=0.2 -s run.snapshots.per_second=0 && same bare bare2
expect 66 "$SPH2D" resume bare && says 'no complete snapshot'

# --no-frames leaves out frames and nothing else; what comes after has the right numbers.
if can_draw; then
    expect 75 "$SPH2D" run "$TINY" -o part -q --no-frames --set run.until=0.2 --max-wall 0.001s
    expect 0 "$SPH2D" resume part -q
    absent part/frames/frame_000000.png
    same whole/frames/frame_000005.png part/frames/frame_000005.png
    same whole/snapshot_000005.h5 part/snapshot_000005.h5
fi

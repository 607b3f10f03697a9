#!/bin/sh
# A guard stops a run: exit 1, a sentence that names it, and the moment in guard.h5, which resume does not take.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 1 "$SPH2D" run "$TINY" -o folder --no-frames --progress never -s method.time_step=0.2 -s run.until=5
says 'error\[R30[1-4]\]' && says 'guard.h5' && prints 'guard at t = '
present folder/guard.h5 && present folder/snapshot_000000.h5
last=$(cd folder && printf '%s\n' snapshot_*.h5 | tail -n 1)
says "the last snapshot before is '$last'"
expect 0 "$SPH2D" info folder/guard.h5
cp -r folder before
expect 1 "$SPH2D" resume folder --no-frames --progress never && says 'error\[R30'
same before folder

# Stopped before it and resumed: the folder of the run that was not.
set -- run "$TINY" --no-frames -q -s method.time_step=0.004 -s run.until=1
expect 1 "$SPH2D" "$@" -o whole && present whole/guard.h5
expect 75 "$SPH2D" "$@" -o parts --max-wall 0.001s && present parts/checkpoint.h5
code=75
while [ $code = 75 ]; do
    code=0
    "$SPH2D" resume parts --no-frames -q --max-wall 0.001s >out 2>err || code=$?
done
[ $code = 1 ] || fail "resumed until the guard: ended with $code"
same whole parts

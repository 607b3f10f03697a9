#!/bin/sh
# One thread or several: the same bytes.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
can_thread || exit 77

expect 0 "$SPH2D" init dam.yaml -q
# Enough particles that several threads get some.
set -- run dam.yaml -s spacing=0.008 -s run.until=0.02 -s run.snapshots.per_second=200 --no-frames --json
expect 0 "$SPH2D" "$@" -o one --threads 1 && prints '"threads": 1,'
expect 0 "$SPH2D" "$@" -o two --threads 2 && prints '"threads": 2,'
expect 0 "$SPH2D" "$@" -o many --threads 5
same one two && same one many
[ "$(find one -name '*.h5' | wc -l)" = 5 ] || fail 'not 5 snapshots'

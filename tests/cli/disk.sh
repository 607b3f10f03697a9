#!/bin/sh
# The disk space that `check` expects of snapshots is within 10 % of what a run without compression writes, for few and
# many particles, walls and none, bodies, methods with other arrays, liquid that comes and goes.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# expected SCENE [OPTION...]: bytes by `check`. taken DIR: bytes of the snapshots of a run.
expected() { "$SPH2D" check "$@" --json | sed -n 's/.*"disk_bytes": \([0-9.e+]*\).*/\1/p'; }
taken() { cat "$1"/snapshot_*.h5 | wc -c; }
# fits NAME [OPTION...]: of NAME.yaml.
fits() {
    name=$1
    shift
    bytes=$(expected "$name.yaml" "$@")
    "$SPH2D" run "$name.yaml" "$@" -o "$name" -f -q --no-frames
    echo "$name $*: expected $bytes, taken $(taken "$name")"
    awk -v a="$bytes" -v b="$(taken "$name")" 'BEGIN { exit !(a > 0.9 * b && a < 1.1 * b) }' ||
        fail "$name $*: $bytes bytes are expected, $(taken "$name") are written"
}

cat >column.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
blocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]
run: {until: 0.02, snapshots: {every: 0.01}}
END
fits column
fits column -s spacing=0.02
fits column -s spacing=0.004 -s run.until=0.001 -s 'run.snapshots={every: 0.0005}'
fits column -s spacing=0.02 -s method.name=constraint
fits column -s spacing=0.02 -s method.name=muller
fits column -s spacing=0.02 -s method.name=pcisph -s 'probes=[{name: force, kind: force, on: left, every: 0.01}]'

cat >periodic.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.02
boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}
gravity: [0, 0]
blocks: [{box: {min: [0, 0], max: [1, 1]}}]
method: {operators: fitted, sound_speed: 10}
run: {until: 0.01, snapshots: {every: 0.01}}
END
fits periodic

# Walls and bodies that are more than the liquid.
{
    cat column.yaml && echo 'bodies:'
    for i in 1 2 3 4 5 6; do
        for k in 1 2 3 4; do
            echo "- {name: b$i$k, circle: {center: [0.$((i + 2))5, 0.$((k + 5))5], radius: 0.04}, density: 300}"
        done
    done
    echo 'obstacles:'
    for k in 1 2 3 4; do echo "- {polyline: [[0.6, 0.$k], [0.7, 0.${k}5], [0.9, 0.$k]]}"; done
} >crowd.yaml
fits crowd -s spacing=0.02
fits crowd -s spacing=0.03

# Liquid that comes from a source, at first none, and liquid that leaves.
cat >source.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.02
sources: [{at: [0.5, 0.9], width: 0.2, direction: [0, -1], speed: 1}]
run: {until: 0.5, snapshots: {per_second: 40}}
END
fits source

# Much is checked by a coarser scene.
fits column -s spacing=0.0012 -s run.until=1e-5

# Compression takes less, and the table says which of the two it has.
"$SPH2D" check column.yaml -s spacing=0.01 >plain
"$SPH2D" check column.yaml -s spacing=0.01 -s run.snapshots.compress=6 >compressed
grep -qE '^snapshots +3, [0-9.]+ MiB$' plain || fail "no size: $(grep '^snapshots' plain)"
grep -qE '^snapshots +3, [0-9.]+ MiB without compression$' compressed || fail "$(grep '^snapshots' compressed)"
"$SPH2D" run column.yaml -s spacing=0.01 -s run.snapshots.compress=6 -o compressed.d -q --no-frames
[ "$(taken compressed.d)" -lt "$(expected column.yaml -s spacing=0.01 | sed 's/\..*//')" ] || fail 'compression takes more'

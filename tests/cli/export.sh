#!/bin/sh
# The particles of a snapshot as CSV: whole, by their numbers, to the last bit, and as the input of another scene.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 64 "$SPH2D" export && says 'one snapshot must be given'
expect 64 "$SPH2D" export a.h5 b.h5
expect 64 "$SPH2D" export a.h5 -o a.vtk && says "'a.vtk' must end in .csv"
expect 66 "$SPH2D" export missing.h5 && empty
expect 65 "$SPH2D" export "$TINY" -o a.csv && absent a.csv
expect 0 "$SPH2D" run "$TINY" -o run --no-frames -q -s run.until=0.2
for snapshot in run/snapshot_*.h5; do :; done # the last
expect 0 "$SPH2D" export "$snapshot" && silent
head -n 1 out | grep -q '^id,x \[m\],y \[m\],vx \[m/s\],vy \[m/s\],density \[kg/m^3\],pressure \[Pa\],mass \[kg/m\],ax' ||
    fail 'the headings are others'
count=$("$SPH2D" info "$snapshot" | sed -n '/^fluid/,/^wall/s/^  Densities *f64 *\([0-9]*\) x.*/\1/p')
[ "$count" -gt 100 ] && lines $((count + 1))
awk -F, 'NR == 1 { n = NF } NF != n { exit 1 } NR > 2 && $1 <= last { exit 1 } { last = $1 }' out ||
    fail 'rows are broken, or not in the order of numbers'
mv out printed
expect 0 "$SPH2D" export "$snapshot" -o a.csv && says "wrote $count particles to 'a.csv'" && empty && same printed a.csv
expect 0 "$SPH2D" export "$snapshot" -o a.csv -q && silent && same printed a.csv

# A scene of these particles has them to the last bit.
cat >again.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
method: {name: wcsph, sound_speed: 40}
particles: a.csv
run: {until: 1e-9, snapshots: {every: 1}}
END
cut -d, -f2-5 a.csv | LC_ALL=C sort >before
expect 0 "$SPH2D" run again.yaml -o again -q
"$SPH2D" export again/snapshot_000000.h5 | cut -d, -f2-5 | LC_ALL=C sort | cmp before - || fail 'other particles'

# What another program changed, a folder that is missing, and a disk that is full.
cp "$snapshot" changed.h5 && printf x >>changed.h5
expect 65 "$SPH2D" export changed.h5 -o changed.csv && absent changed.csv
expect 0 "$SPH2D" export changed.h5 -o changed.csv --no-checksum && same changed.csv a.csv
expect 73 "$SPH2D" export "$snapshot" -o missing/a.csv
(trap '' XFSZ && ulimit -f 16 && expect 74 "$SPH2D" export "$snapshot" -q -o a.csv) || fail 'no room'
same printed a.csv
if [ -w /dev/full ]; then
    code=0 && "$SPH2D" export "$snapshot" >/dev/full 2>err || code=$?
    [ $code = 74 ] && says 'cannot write to standard output'
fi

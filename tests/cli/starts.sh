#!/bin/sh
# Liquid that starts with a table or a snapshot: read beside the scene, refused with file and line, not needed to resume.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

mkdir scenes
cat >scenes/shear.yaml <<'EOS'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
gravity: [0, 0]
boundary: {top: wall}
blocks: [{box: {min: [0, 0], max: [1, 1]}, start: {table: shear.csv}}]
probes:
  - {name: motion, kind: momentum, every: 0.02}
  - {name: p, kind: pressure, at: [0.5, 0.5], every: 0.02}
run: {until: 0.1, snapshots: {every: 0.05}}
EOS
table() { # table ROW...: writes scenes/shear.csv
    printf '%s\n' "$@" >scenes/shear.csv
}
scene() { # scene CODE [SET...]: checks it
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" check scenes/shear.yaml "$@"
}

# vx = 2 y - 0.6, p = 100, in any order, with other columns: 1000 kg/m at 0.4 m/s in the mean.
table '# shear' 'x [m],note,y [m],vx [m/s],pressure [Pa]' '1,1,1,1.4,100' '0,1,0,-0.6,100' '1,1,0,-0.6,100' '0,1,1,1.4,100'
scene 0 && prints 'sound speed *14 m/s'
expect 0 "$SPH2D" run scenes/shear.yaml -o whole -q
sed -n 2p whole/motion.csv | awk -F, '{ exit !($2 > 399.999 && $2 < 400.001) }' || fail "$(sed -n 2p whole/motion.csv)"
sed -n 2p whole/p.csv | awk -F, '{ exit !($2 > 99 && $2 < 101) }' || fail "$(sed -n 2p whole/p.csv)"

# A stopped run goes on without the file.
code=0
"$SPH2D" run scenes/shear.yaml -o parts -q --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
rm scenes/shear.csv
expect 0 "$SPH2D" resume parts -q && same whole parts
scene 66 && says "blocks\[0\].start.table: cannot open 'scenes/shear.csv'"

# Faults of a table.
table 'x,y,speed' '0,0,1' && scene 65 && says 'shear.csv:2:1: .*needs one of the columns vx, vy, pressure'
table 'x,vx' '0,0' && scene 65 && says "no column 'y'"
table 'x,y,vx' && scene 65 && says 'this file has no rows'
table 'x,y,vx' '0,0,1' '1,0,' && scene 65 && says "shear.csv:3:1: .*lacks a number: its column 'vx'"
table 'x,y,vx' '0,0,1' '1,0,1e13' && scene 65 && says "shear.csv:3:1: .*column 'vx' is larger than 1e12"
table 'x,y,vx' '0,0,1' '1,0,1' && scene 65 && says 'two different x and two different y at least, this has 2 and 1'
table 'x,y,vx' '0,0,1' '1,0,1' '0,1,1' && scene 65 && says 'shear.csv: .*the point (1, 1) is missing: .* its 2 x and 2 y'
table 'x,y,vx' '0,0,1' '1,0,1' '0,1,1' '0,1,2' '1,1,0' && scene 65
says 'shear.csv:5:1: .*the point (0, 1) is given twice, first on line 4'
table 'x,y,vx' '0,0,1' '0.1,0.2,1' '0.3,0.4,1' '0.5,0.6,1' && scene 65
says 'make no rectangular grid: 4 different x, 4 different y, but 4 rows'
table 'x,y,vx' '0,0,1' '1,0,1' '0,0.9,1' '1,0.9,1' && scene 65
says 'shear.yaml:5:.*blocks\[0\].start.table: liquid at (0.025, 0.925) lies outside the table, .* from (0, 0) to (1, 0.9)'
table 'x,y,vx' '0,0,1' '1,0,1' '0,1,1' '1,1,1'
scene 65 --set 'blocks[0].start.flow=still' && says 'blocks\[0\].start: .*more than one thing'
# shellcheck disable=SC2016 # the quotes of a message
scene 65 --set 'start={table: shear.csv}' && says 'start: is that of `particles`'

# A coarse run goes on at half the spacing: the same liquid, its momentum and height; and without the snapshot.
cat >scenes/dam.yaml <<'EOS'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.025
blocks: [{box: {min: [0, 0], max: [0.4, 0.6]}}]
probes: [{name: e, kind: energy, every: 0.05}]
run: {until: 0.2, snapshots: {every: 0.2}}
EOS
fine() { # fine CODE COMMAND [OPTION...]: of the liquid of the coarse run
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" "$@" --set spacing=0.0125 --set 'blocks=[]' --set run.until=0.01 \
        --set "start={snapshot: ../coarse/snapshot_000001.h5}"
}
expect 0 "$SPH2D" run scenes/dam.yaml -o coarse -q
fine 0 check scenes/dam.yaml && prints 'particles *1536 in' && prints 'requested, .* (+0.00 %)'
fine 0 run scenes/dam.yaml -o whole -q -f
# shellcheck disable=SC2016 # for awk
expect 0 awk -F, 'FNR == 2 && FILENAME ~ /whole/ { k = $2; p = $3; m = $4 } FILENAME ~ /coarse/ { a = $2; b = $3; c = $4 }
    END { print k / a, p / b, m / c; exit !(k/a > 0.98 && k/a < 1.02 && p/b > 0.98 && p/b < 1.02 && m/c > 0.98 && m/c < 1.02) }' \
    whole/e.csv coarse/e.csv
code=0
"$SPH2D" run scenes/dam.yaml -o parts -q -f --max-wall 0.001s --set spacing=0.0125 --set 'blocks=[]' \
    --set run.until=0.01 --set "start={snapshot: ../coarse/snapshot_000001.h5}" >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
mv coarse away
expect 0 "$SPH2D" resume parts -q && same whole parts
fine 66 check scenes/dam.yaml && says 'start.snapshot'
mv away coarse
printf 'no snapshot\n' >scenes/none.h5
expect 65 "$SPH2D" check scenes/dam.yaml --set 'start={snapshot: none.h5}' && says 'none.h5'
fine 65 check scenes/dam.yaml --set method=pcisph && says 'start.snapshot: .*does not determine the sound speed'
fine 0 check scenes/dam.yaml --set 'method={name: pcisph, sound_speed: 100}'

# Of a block: its own shape, the values of the snapshot; a study's scene names it from wherever it lies.
cat >study.yaml <<'EOS'
scene: scenes/dam.yaml
runs: [{set: {run.until: 0.01, blocks: [{box: {min: [0, 0], max: [0.4, 0.3]},
        start: {snapshot: ../coarse/snapshot_000001.h5}}]}}]
measures: [{name: e, probe: e, column: kinetic, expect: 0, scale: 1}]
target: 1000
EOS
expect 0 "$SPH2D" study study.yaml -q -o study
expect 0 "$SPH2D" check study/cheapest.yaml && prints "particles *192 in"
grep -q 'snapshot: "/.*coarse/snapshot_000001.h5"' study/cheapest.yaml || fail "$(cat study/cheapest.yaml)"

# Single particles have the pressure of still water.
printf 'x,y\n0.5,0.25\n0.55,0.25\n' >scenes/two.csv
expect 0 "$SPH2D" run scenes/dam.yaml -o two -q --set 'blocks=[]' --set particles=two.csv --set method.sound_speed=20 \
    --set 'start={flow: still, center: [0, 0.6]}' --set run.until=0 \
    --set 'probes=[{name: p, kind: pressure, at: [0.5, 0.25], every: 1}]'
sed -n 2p two/p.csv | awk -F, '{ exit !($2 > 3433 && $2 < 3434) }' || fail "9810 * 0.35: $(sed -n 2p two/p.csv)"

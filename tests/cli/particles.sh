#!/bin/sh
# Particles from a file of their own: read beside the scene, refused with file and line, not needed to resume.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

mkdir scenes
cat >scenes/cloud.yaml <<'EOF'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
particles: cloud.csv
method: {name: wcsph, sound_speed: 20}
probes: [{name: motion, kind: momentum, every: 0.02}]
run: {until: 0.1, snapshots: {every: 0.05}}
EOF
table() { # table HEADING ROW...: writes it as the particles' file
    printf '%s\n' "$@" >scenes/cloud.csv
}
scene() { # scene CODE [SET...]: checks it
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" check scenes/cloud.yaml "$@"
}

# Extra columns, units, comments; what is left out is 0.
table '# a cloud' 'id,x [m],y [m],vx [m/s]' '7,0.5,0.5,1.5' '8,0.55,0.5,1.5'
scene 0 && prints 'particles *2 in the liquid'
expect 0 "$SPH2D" run scenes/cloud.yaml -o whole -q
# 2 particles of 1000 * 0.05^2 kg/m at 1.5 m/s
sed -n 2p whole/motion.csv | grep -q '^0,7.5,0,' || fail "momentum: $(sed -n 2p whole/motion.csv)"

# A stopped run goes on without the file.
code=0
"$SPH2D" run scenes/cloud.yaml -o parts -q --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
mv scenes/cloud.csv away.csv
expect 0 "$SPH2D" resume parts -q && same whole parts
scene 66 && says "^scenes/cloud.yaml:3:12: error.*: particles: cannot open 'scenes/cloud.csv'"
mv away.csv scenes/cloud.csv

# Velocity and density are those of the file: p = c0^2 (rho - rho0) = 4000 Pa.
table 'x,y,vy,density' '0.5,0.5,-3,1010'
expect 0 "$SPH2D" run scenes/cloud.yaml -o dense -q --set run.until=0 \
    --set 'probes=[{name: p, kind: pressure, at: [0.5, 0.5], every: 1}, {name: motion, kind: momentum, every: 1}]'
sed -n 2p dense/motion.csv | grep -q '^0,0,-7.5,' || fail "momentum: $(sed -n 2p dense/motion.csv)"
sed -n 2p dense/p.csv | grep -q ',1010' || fail "density: $(sed -n 2p dense/p.csv)"

# The scene of a study's cheapest row names the file wherever it lies itself.
table 'x,y' '0.5,0.5'
cat >study.yaml <<'EOF'
scene: scenes/cloud.yaml
runs: [{set: {run.until: 0.02}}]
measures: [{name: still, probe: motion, column: momentum_x, expect: 0, scale: 1}]
target: 1
EOF
expect 0 "$SPH2D" study study.yaml -q -o study
expect 0 "$SPH2D" check study/cheapest.yaml && prints 'particles *1 in the liquid'

# Faults.
table 'x,vy' '0.5,0.5' && scene 65 && says "cloud.csv:1:1: .*no column 'y'" && says 'columns here: x, vy'
table 'x,y' '0.5,up' && scene 65 && says "cloud.csv:2:5: .*expected a number, got 'up'"
table 'x,y' '0.5,0.5' '0.5,' && scene 65 && says 'cloud.csv:3:1: .*lacks a number: its column .y. is empty or nan'
table 'x,y,density' '0.5,0.5,0' && scene 65 && says 'cloud.csv:2:1: .*a density must be above 0'
table 'x,y' && scene 65 && says 'this file has no particles'
table 'x [mm],y' '0.5,0.5' && scene 65 && says "cloud.csv:1:1: .*'x' must be in m$"
printf 'x,y\r0.5,0.5\r' >scenes/cloud.csv && scene 65 && says 'line feed'
table 'x,y' '0.5,0.5' '0.6,0.5' '0.50000001,0.5' && scene 65 && says 'particles\[[02]\]: .*where another particle is'
table 'x,y' '0.5,1.5' && scene 65 && says 'cloud.yaml:3:12: .*particles\[0\]: (0.5, 1.5) lies outside the domain'
table 'x,y' '0.97,0.5'
scene 65 --set 'boundary={left: periodic, right: periodic}' --set walls=default \
    --set 'obstacles=[{circle: {center: [0.02, 0.5], radius: 0.1}}]' && says 'inside an obstacle'
table 'x,y' '0.5,0.5'
scene 65 --set fluid.density=-5 && says 'fluid.density'
grep -q 'cloud.csv' err && fail 'the file of particles is not at fault'
scene 65 --set method.sound_speed=0 && says 'does not determine the sound speed'
scene 65 --set 'blocks=[{box: {min: [0.2, 0.2], max: [0.6, 0.6]}}]' && says 'particles\[0\]: .*inside a block'
scene 65 --set 'obstacles=[{circle: {center: [0.5, 0.5], radius: 0.1}}]' && says 'inside an obstacle'
scene 0 --set 'blocks=[{box: {min: [0.1, 0.1], max: [0.3, 0.3]}}]' && prints 'particles *17 in the liquid'

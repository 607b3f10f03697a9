#!/bin/sh
# Gravity and motions in time from files: read beside the scene, refused with file and line, not needed to resume.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

mkdir scenes
cat >scenes/fall.yaml <<'EOS'
domain: {min: [-1, -1], max: [1, 1]}
boundary: {left: open, right: open, bottom: open}
spacing: 0.05
blocks: [{box: {min: [0, 0], max: [0.05, 0.05]}}]
gravity: [0.25, -2]
gravity_file: gravity.csv
method: {name: wcsph, sound_speed: 20, time_step: 0.01}
probes: [{name: motion, kind: momentum, every: 0.1}]
run: {until: 0.4, snapshots: {every: 0.1}}
EOS
table() { # table NAME HEADING ROW...: writes scenes/NAME
    name=$1
    shift
    printf '%s\n' "$@" >"scenes/$name"
}
scene() { # scene CODE [SET...]: checks it
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" check scenes/fall.yaml "$@"
}
impulse() { # impulse FOLDER X Y: momentum of the 2.5 kg/m at the end
    tail -n 1 "$1/motion.csv" | awk -F, -v x="$2" -v y="$3" '
        { exit !(($2 - x) ^ 2 < 1e-16 && ($3 - y) ^ 2 < 1e-16) }' || fail "momentum: $(tail -n 1 "$1/motion.csv")"
}

# gx grows to 4 in 0.2 s and stays; gy is -1, not that of `gravity`. Momentum is 2.5 kg/m times its integral.
table gravity.csv '# shaken' 't [s],note,gx [m/s^2],gy' '0,7,0,-1' '0.2,7,4,-1'
scene 0
expect 0 "$SPH2D" run scenes/fall.yaml -o both -q && impulse both 3 -1

# What the file lacks is that of `gravity`.
table gravity.csv 't,gx' '0,0' '0.2,4'
expect 0 "$SPH2D" run scenes/fall.yaml -o one -q && impulse one 3 -2
table gravity.csv 't,gy' '0,-3'
expect 0 "$SPH2D" run scenes/fall.yaml -o other -q && impulse other 0.25 -3

# Faults.
table gravity.csv 't,x' '0,0' && scene 65 && says "gravity.csv:2:1: .*needs one of the columns gx, gy"
table gravity.csv 'gx' '0' && scene 65 && says "gravity.csv:1:1: .*no column 't'"
table gravity.csv 't,gx' && scene 65 && says 'this file has no rows'
table gravity.csv 't,gx' '0,0' '1,' && scene 65 && says 'gravity.csv:3:1: .*lacks a number: its column .gx. is empty or nan'
table gravity.csv 't,gx' '0,0' '1,1' '1,2' && scene 65 && says 'gravity.csv:4:1: .*times must increase'
table gravity.csv 't,gx [g]' '0,0' && scene 65 && says "'gx' must be in m/s^2"
table gravity.csv 't,gx' '0,1e301' && scene 65 && says 'gravity_path'
{ echo t,gx && seq 0 5000 | sed 's/$/,1/'; } >scenes/gravity.csv && scene 65 && says 'more than 5000 points'
scene 65 --set 'gravity_path=[[0, 0, -1]]' && says 'gravity_file: .*which is given, too'
rm scenes/gravity.csv && scene 66
says "^scenes/fall.yaml:6:15: error\[F201\]: gravity_file: cannot open 'scenes/gravity.csv'"
table gravity.csv 't,gx' '0,0'
scene 66 --set 'motion={file: none.csv}' && says "motion.file: cannot open 'scenes/none.csv'"
scene 66 --set 'obstacles=[{circle: {center: [0, -0.5], radius: 0.1}, motion: {file: none.csv}}]'
says "obstacles\[0\].motion.file: cannot open 'scenes/none.csv'"

# A stopped run goes on without its files: gravity, the tank's motion, and that of the second of two paddles.
table gravity.csv 't,gx' '0,0' '0.2,4'
table tank.csv 't,angle' '0,0' '0.1,0' '0.2,0.01' '0.3,0.02' '0.6,0'
table paddle.csv 't,x,angle' '0,0,0' '0.1,0.01,0.02' '0.5,0,0'
set -- --set run.until=0.2 --set 'motion={file: tank.csv}' --set 'obstacles=[
    {circle: {center: [-0.5, 0], radius: 0.1}, motion: {rate: 1, ramp: 1}},
    {box: {min: [0.4, -0.2], max: [0.7, 0.2]}, motion: {file: paddle.csv, between: lines}}]'
expect 0 "$SPH2D" run scenes/fall.yaml -o whole -q "$@"
code=0
"$SPH2D" run scenes/fall.yaml -o parts -q "$@" --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
rm scenes/*.csv
expect 0 "$SPH2D" resume parts -q && same whole parts

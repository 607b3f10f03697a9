#!/bin/sh
# What openings prescribe over time, from files: read beside the scene, refused with file and line, not needed to resume.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

mkdir scenes
cat >scenes/river.yaml <<'EOS'
domain: {min: [0, 0], max: [0.5, 0.4]}
spacing: 0.05
blocks: [{box: {min: [0, 0], max: [0.5, 0.2]}}]
openings:
  - {name: in, side: left, history: {file: flood.csv}, free_surface: on}
  - {name: out, side: right, level: 0.2}
probes: [{name: in, kind: opening, on: in, every: 0.1}]
run: {until: 0.6, snapshots: {every: 0.3}}
EOS
table() { # table ROW...: writes scenes/flood.csv
    printf '%s\n' "$@" >scenes/flood.csv
}
scene() { # scene CODE [SET...]: checks it
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" check scenes/river.yaml "$@"
}

# From nothing to 0.2 m^2/s, over 0.2 s: 0.1 m^2 until 0.6 s, to half a column of particles.
table '# a flood' 't [s],note,flow_rate [m^2/s]' '0,1,0' '0.2,2,0.2'
scene 0
expect 0 "$SPH2D" run scenes/river.yaml -o all -q
tail -n 1 all/in.csv | awk -F, '{ exit !($4 > 0.09 && $4 < 0.11) }' || fail "let in: $(tail -n 1 all/in.csv)"

# A stopped run goes on without the file.
code=0
"$SPH2D" run scenes/river.yaml -o parts -q --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
rm scenes/flood.csv
expect 0 "$SPH2D" resume parts -q && same all parts

# Faults.
scene 66
says "openings\[0\].history.file: cannot open 'scenes/flood.csv'"
table 't,flow' '0,1' && scene 65 && says 'flood.csv:2:1: .*needs just one of the columns velocity, flow_rate, pressure, level'
table 't,velocity,level' '0,1,1' && scene 65 && says 'needs just one of the columns'
table 't,velocity' && scene 65 && says 'this file has no rows'
table 't,velocity' '0,0' '1,' && scene 65 && says "flood.csv:3:1: .*lacks a number: its column 'velocity'"
table 't,velocity' '0,0' '1,1' '1,2' && scene 65 && says 'flood.csv:4:1: .*times must increase'
table 't,velocity [m]' '0,0' && scene 65 && says "'velocity' must be in m/s"
table 't,velocity' '0,0' '1,1'
scene 65 --set 'openings[0].history.level=[[0, 0.2]]' && says 'history.file: is a list, which is given, too'
scene 65 --set 'openings[0].level=0.2' && says 'openings\[0\]: prescribes more than one thing'

# Velocity over place and time, rows in any order: 0.4 m^2/s in the mean over the first 0.2 s, then 0.8; not needed to resume.
cat >scenes/pipe.yaml <<'EOS'
domain: {min: [0, 0], max: [0.5, 0.4]}
spacing: 0.05
boundary: {top: wall}
gravity: [0, 0]
blocks: [{box: {min: [0, 0], max: [0.5, 0.4]}}]
openings:
  - {name: in, side: left, history: {file: inflow.csv}, ramp: 0.1}
  - {name: out, side: right, pressure: 0}
probes: [{name: in, kind: opening, on: in, every: 0.1}]
run: {until: 0.6, snapshots: {every: 0.3}}
EOS
inflow() { # inflow ROW...: writes scenes/inflow.csv
    printf '%s\n' "$@" >scenes/inflow.csv
}
pipe() { # pipe CODE [SET...]: checks it
    wanted=$1
    shift
    expect "$wanted" "$SPH2D" check scenes/pipe.yaml "$@"
}
inflow 't,y [m],velocity [m/s]' '0.4,0.4,4' '0.4,0,0' '0,0,0' '0.2,0.4,2' '0.2,0,0' '0,0.4,2'
pipe 0
expect 0 "$SPH2D" run scenes/pipe.yaml -o whole -q
tail -n 1 whole/in.csv | awk -F, '{ exit !($2 > 1.9 && $2 < 2.1) }' || fail "velocity: $(tail -n 1 whole/in.csv)"
code=0
"$SPH2D" run scenes/pipe.yaml -o pieces -q --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
rm scenes/inflow.csv
expect 0 "$SPH2D" resume pieces -q && same whole pieces

inflow 'y,velocity' '0,0' '0.2,1' '0.4,0' && pipe 0
inflow 'y,velocity' '0,0' '0.2,1' '0.2,2' '0.4,0' && pipe 65 && says 'inflow.csv:4:1: .*the place 0.2 is given twice at t = 0'
inflow 't,y,velocity' '0,0,0' '0,0.4,0' '1,0,1' '1,0.3,1' && pipe 65 && says 'inflow.csv:5:1: .*the places at t = 1 are not those'
inflow 't,y,velocity' '0,0,0' '0,0.4,0' '1,0,1' && pipe 65 && says 'inflow.csv:4:1: .*the places at t = 1 are not those'
inflow 'x,velocity' '0,0' '0.4,1' && pipe 65 && says "inflow.csv:2:1: .*there is no column 't', nor 'y' with a velocity over places"
inflow 'y,velocity' '0,0' '0.4,' && pipe 65 && says "inflow.csv:3:1: .*lacks a number: its column 'velocity'"
inflow 'y,velocity' '0,0' '0.3,1' && pipe 65
says 'openings\[0\].history.profile: has places from 0 to 0.3, but the opening reaches from 0 to 0.4'

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

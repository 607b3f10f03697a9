#!/bin/sh
# What a run writes and prints.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" run "$TINY" -o folder "$DRAW" --progress never
# 0.4 s at 25 a second, with both ends
[ "$(find folder -name 'snapshot_0000??.h5' | wc -l)" = 11 ] || fail 'not 11 snapshots'
present folder/snapshot_000000.h5 && present folder/snapshot_000010.h5
absent folder/checkpoint.h5
if can_draw; then
    [ "$(find folder/frames -name 'frame_0000??.png' | wc -l)" = 11 ] || fail 'not 11 frames'
fi
[ "$(wc -l <folder/energy.csv)" = 42 ] || fail 'energy.csv does not have 41 rows and a header'
[ "$(wc -l <folder/corner.csv)" = 22 ] || fail 'corner.csv does not have 21 rows and a header'
head -n 1 folder/energy.csv | grep -q '^time \[s\],kinetic \[J/m\],' || fail 'no header with units'
[ "$(find folder -name '.*' ! -name . | wc -l)" = 0 ] || fail 'temporary files are left'

# The summary has speed and error; quiet has neither; JSON has one object.
expect 0 "$SPH2D" run "$TINY" -o table --no-frames --progress never
for row in tiny speed compression energy momentum particles 'particles lost' walls steps; do
    prints "^$row  *[^ ]"
done
prints 'finished at t = 0.4' && prints 'particle-steps/s; .* per CPU second' && prints 'p99 .*mean .*maximum'
grep -q 'above method.max_compression' out && fail 'the sound speed of the scene is not enough'
expect 0 "$SPH2D" run "$TINY" -o soft --no-frames --progress never --set method.stiffness=1
prints 'above method.max_compression, 10 %: about [0-9.]* times the sound speed would limit it'
expect 0 "$SPH2D" run "$TINY" -o quiet --no-frames --quiet && empty && silent
expect 0 "$SPH2D" run "$TINY" -o json --no-frames --json --progress never && lines 1
for key in scene end time until speed particle_steps_per_second real_time_factor step_cpu_seconds output_cpu_seconds \
    error compression_p99 compression_max volume_covered energy_change momentum particles blocked drained left backstop_hits steps \
    time_step limited_by; do
    prints "\"$key\": "
done
grep -v '^{"severity": "note", .*}$' err && fail 'messages are not JSON'
if command -v python3 >/dev/null; then
    python3 -c 'import json; json.load(open("out")); [json.loads(line) for line in open("err")]' || fail 'not JSON'
fi

# What frames took; nothing where there are none.
if can_draw; then
    expect 0 "$SPH2D" run "$TINY" -o drawn --progress never
    prints '^  *11 frames, [0-9.]* ms each to draw, [0-9.]* to read back, [0-9.]* to encode$'
    expect 0 "$SPH2D" run "$TINY" -o drawn -f --json --progress never
    prints '"frames": {"count": 11, "draw_seconds": [0-9.e-]*, "read_seconds": [0-9.e-]*, "encode_seconds": [0-9.e-]*}'
    grep -q '"frames": {[^}]*_seconds": 0[,}]' out && fail 'a frame that took no time'
fi
expect 0 "$SPH2D" run "$TINY" -o bare --no-frames --json --progress never && prints '"frames": {"count": 0, '

# Where the time went, for who asks.
expect 0 "$SPH2D" run "$TINY" -o profile --no-frames --progress never --profile
prints '^profile  *move  *[0-9.]* %' && prints '^  *density  *[0-9.]* %  .* CPU ns per particle and step'
expect 0 "$SPH2D" run "$TINY" -o profiled --no-frames --json --profile && prints '"profile": {"move": {"seconds": '

# The same bytes again, and without frames.
same table quiet && same table json && same table profile
rm -rf folder/frames && same table folder

# The end between two snapshots is kept in a checkpoint; without snapshots there is none.
expect 0 "$SPH2D" run "$TINY" -o between --no-frames -q --set run.until=0.39 && present between/checkpoint.h5
expect 0 "$SPH2D" run "$TINY" -o none --no-frames -q --set run.snapshots.per_second=0 && absent none/checkpoint.h5
[ "$(find none -name '*.h5' | wc -l)" = 0 ] || fail 'snapshots that nobody asked for'
expect 0 "$SPH2D" run "$TINY" -o zero --no-frames -q --set run.until=0 && present zero/snapshot_000000.h5
absent zero/snapshot_000001.h5

# The summary tells how noisy gauges are, from all of their series, and that of a default one far less than that of one
# without a rise time.
cat >gauges.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.04
blocks: [{box: {min: [0, 0], max: [0.4, 0.6]}}]
probes:
  - {name: usual, kind: pressure, at: [0, 0.05], every: 0.005}
  - {name: raw, kind: pressure, at: [0, 0.05], rise_time: 0, every: 0.005}
  - {name: short, kind: pressure, at: [0, 0.05], every: 0.1}
run: {until: 1}
END
expect 0 "$SPH2D" run gauges.yaml -o gauges --progress never
prints '^noise of gauges  *usual: [0-9.e+]* Pa, [0-9.]* % of the mean, [0-9.]* Pa, in the last quarter; rise time 0.0699 s$'
prints '^  *raw: .*rise time 0 s$'
if grep -q 'short: ' out; then fail 'the noise of three samples'; fi
awk '/usual: / { usual = $5 } /raw: / { raw = $2 } END { exit !(raw > 1.5 * usual && usual > 0) }' out || fail 'another noise'
grep 'usual: \|raw: ' out >noise
# The same by the definition: a running mean, centred, over a quarter of the last quarter.
awk -F, 'NR > 1 { t[++n] = $1; p[n] = $2 }
    END {
        for (first = n; first > 1 && t[first - 1] >= t[n] - (t[n] - t[1]) / 4; --first);
        half = int(int((n - first + 1) / 4) / 2)
        for (i = first + half; i <= n - half; ++i) {
            mean = 0
            for (k = i - half; k <= i + half; ++k) mean += p[k] / (2 * half + 1)
            sum += (p[i] - mean) ^ 2; ++count
        }
        printf "%.3g\n", sqrt(sum / count)
    }' gauges/raw.csv >defined
[ "$(awk '/raw: / { print $2 }' noise)" = "$(cat defined)" ] || fail "the noise is $(cat defined) by its definition"
expect 75 "$SPH2D" run gauges.yaml -o parts --max-wall 0.001s -q && expect 0 "$SPH2D" resume parts --progress never
grep 'usual: \|raw: ' out | diff noise - >&2 || fail 'another noise of a run in parts'
expect 0 "$SPH2D" run gauges.yaml -o gauges -f --json --progress never && prints '"gauges": {"usual": {"mean": [0-9.]*, "noise": [0-9.]*, "rise_time": 0.069'

# Liquid that was pressed far together gets a word, other liquid none.
cat >pressed.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
gravity: [0, 0]
method: {name: muller, sound_speed: 10}
blocks: [{box: {min: [0.4, 0.4], max: [0.6, 0.6]}, spacing: 0.035}]
run: {until: 0.001}
END
expect 0 "$SPH2D" run pressed.yaml -o pressed --progress never && prints '^  *some liquid had 2[.]02 times its density'
expect 0 "$SPH2D" run pressed.yaml -o pressed -f -s 'blocks[0].spacing=0.05' --progress never
grep -q 'times its density' out && fail 'a word on liquid that was not pressed'

# A run that would leave nothing keeps its end, and one that goes on the next.
cat >bare.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
blocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]
run: {until: 0.05}
END
expect 0 "$SPH2D" run bare.yaml -o kept --progress never && says "the last moment is in 'kept/snapshot_000000.h5'"
[ "$(ls kept)" = snapshot_000000.h5 ] || fail 'more than one file'
expect 0 "$SPH2D" resume kept -s run.until=0.1 --progress never && says "the last moment is in 'kept/snapshot_000001.h5'"
expect 0 "$SPH2D" run bare.yaml -o again -q && silent && cmp again/snapshot_000000.h5 kept/snapshot_000000.h5 >&2
expect 0 "$SPH2D" run bare.yaml -o undrawn -s 'run.frames={every: 0.05}' --no-frames -q && present undrawn/snapshot_000000.h5
expect 75 "$SPH2D" run bare.yaml -o stopped --max-wall 0.000001s -q && expect 0 "$SPH2D" resume stopped -q
same again stopped

# --verbose says where the number of threads comes from
set -- run "$TINY" --no-frames -v --set run.until=0
if "$SPH2D" --version | grep -q '^OpenMP *yes'; then
    expect 0 "$SPH2D" "$@" -o v1 -j 1 && says ' 1 thread (--threads)'
    expect 0 env OMP_NUM_THREADS=2,1 "$SPH2D" "$@" -o v2 && says ' 1 thread (few particles)'
    set -- "$@" --set spacing=0.01
    expect 0 env OMP_NUM_THREADS=2,1 "$SPH2D" "$@" -o v3 && says ' 2 threads (OMP_NUM_THREADS)'
    expect 0 env OMP_NUM_THREADS=2 OMP_THREAD_LIMIT=1 "$SPH2D" "$@" -o v4 && says ' 1 thread (OMP_THREAD_LIMIT)'
    expect 0 "$SPH2D" "$@" -o v5 && says ' threads* (processors allowed to this process)'
else
    expect 0 "$SPH2D" "$@" -o v1 -j 2 && says ' 1 thread (built without OpenMP)'
fi
for set in baseline avx2 avx512; do
    "$SPH2D" --version | grep -q "^instruction sets.*$set" || continue
    expect 0 "$SPH2D" "$@" -o isa_$set --isa $set && says ", $set\$"
done
# A name of a YAML file may be anything, and -- ends the options.
cp "$TINY" ./-scene
expect 0 "$SPH2D" run -o dash --no-frames -q -- -scene

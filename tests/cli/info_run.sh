#!/bin/bash
# What info tells of the folder of a run, in every state that a run can be left in.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# told KEY VALUE: what the last --json printed.
told() {
    grep -q "\"$1\": $2[,}]" out || fail "$1 is not $2"
}
run() { # CODE FOLDER OPTIONS...
    code=$1 folder=$2
    shift 2
    expect "$code" "$SPH2D" run "$TINY" -o "$folder" --no-frames -q "$@"
}
info() {
    expect 0 "$SPH2D" info "$@" && silent
}

# Finished, with all its numbers; those of energy are the summary's.
expect 0 "$SPH2D" run "$TINY" -o whole --no-frames --json
sed -n 's/.*\("energy_error": [^,]*\),.*\("energy_scale": [^,]*\),.*/\1 \2/p' out >summary
info whole
for row in folder scene 'written by' state time resumable particles files written 'energy error'; do prints "^$row  *[^ ]"; done
prints '^scene  *tiny$' && prints '^state  *finished$' && prints '^time  *0.40[0-9]* s of 0.4 s, after [0-9]* steps, in snapshot_000010.h5$'
prints '^files  *snapshots 11, frames 0, series 3; ' && prints 'sph2d resume whole --set run.until=T'
info whole --json && lines 1
sed -n 's/.*\("energy_error": [^,]*\),.*\("energy_scale": [^}]*\)}.*/\1 \2/p' out >told
same summary told
told state '"finished"' && told until 0.4 && told snapshots 11 && told series 3 && told resumable true && told frames 0
told newest '"snapshot_000010.h5"' && told particles 120 && told wall_particles 5
cp -r whole before && info whole/ && same whole before
if can_draw; then
    expect 0 "$SPH2D" run "$TINY" -o drawn -q -s run.until=0.1 && info drawn --json && told frames 3
fi

# Stopped by --max-wall, by a signal at a step, and just after a snapshot; killed; then resumed to the end.
run 75 stopped --max-wall 0.001s
info stopped --json && told state '"stopped"' && told resumable true && told newest '"checkpoint.h5"' && told snapshots 1
info stopped && prints '^state  *stopped by a signal or --max-wall' && prints 'yes, from t = [0-9.]* s: sph2d resume stopped$'
expect 0 "$SPH2D" resume stopped -q --no-frames && info stopped --json && told state '"finished"'
cp -r whole killed && rm killed/snapshot_00000[4-9].h5 killed/snapshot_000010.h5
info killed --json && told state '"broken_off"' && told newest '"snapshot_000003.h5"' && told resumable true
info killed && prints 'not finished: killed, failed, or stopped just after this snapshot'
# A later end of a run is known where it was reached.
run 0 longer -s run.until=0.1 && expect 0 "$SPH2D" resume longer -q --no-frames -s run.until=0.2
info longer --json && told until 0.2 && told state '"finished"'

# A guard: its moment, and the snapshot before, from which it would go on.
cat >blast.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
method: {name: muller, time_step: 0.05}
blocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]
run: {until: 5, snapshots: {every: 0.05}}
END
expect 1 "$SPH2D" run blast.yaml -o blast -q && present blast/guard.h5
info blast --json && told state '"guard"' && told newest '"guard.h5"' && told resumable true && told until 5
info blast && prints '^state  *stopped by a guard$' && prints '^time .* in guard.h5$' && prints 'yes, from t = '
rm blast/snapshot_*.h5 && info blast --json && told state '"guard"' && told resumable false
info blast && prints '^resumable  *no$'

# Running: nothing is disturbed, and the folder is not locked.
sed 's/until: 5, snapshots: {every: 0.05}/until: 1e6, snapshots: {every: 0.001}/; s/, time_step: 0.05//' blast.yaml >endless.yaml
env --default-signal=TERM "$SPH2D" run endless.yaml -o endless -q -j 1 2>err.run &
pid=$!
await test -e endless/snapshot_000003.h5
for _ in 1 2 3 4 5; do info endless --json && told state '"running"' && told until 1000000; done
info endless && prints '^state  *running: another sph2d' && prints '^resumable  *when that has ended'
kill $pid && code=0 && { wait $pid || code=$?; }
[ "$code" = 143 ] || fail "the run that was looked at ended with $code: $(cat err.run)"
info endless --json && told state '"\(stopped\|broken_off\)"'
# Commands that begin while others look are not refused.
(while [ ! -e enough ]; do "$SPH2D" info whole >/dev/null 2>&1; done) &
looking=$!
for _ in $(seq 30); do expect 0 "$SPH2D" resume whole -q --no-frames; done
: >enough && wait $looking

# Damaged files are skipped with a warning.
cp -r whole damaged && head -c 3000 whole/snapshot_000010.h5 >damaged/snapshot_000010.h5
expect 0 "$SPH2D" info damaged --json && says 'damaged/snapshot_000010.h5. is skipped'
told newest '"snapshot_000009.h5"' && told state '"broken_off"'
for file in damaged/*.h5; do : >"$file"; done
expect 66 "$SPH2D" info damaged && says "'damaged' is not the folder of a run: it has no complete snapshot" && empty
# Without a checksum on request.
cp -r whole altered && rm altered/*.h5 && head -c -16 whole/snapshot_000004.h5 >altered/snapshot_000004.h5
expect 66 "$SPH2D" info altered && expect 0 "$SPH2D" info altered --no-checksum --json && told newest '"snapshot_000004.h5"'

# Folders of others: none of them hides one that is a run's.
mkdir none
expect 66 "$SPH2D" info none && says 'error\[F201\]' && says 'hint: a run writes snapshots if' && empty
expect 66 "$SPH2D" info none --json && says '"code": "F201"'
printf 'scene: %s\nruns: [{set: {}}]\nmeasures: [{name: e, probe: energy, column: kinetic}]\n' "$TINY" >study.yaml
expect 0 "$SPH2D" study study.yaml -o study -q && expect 66 "$SPH2D" info study && says 'hint: it is the folder of a study'
expect 66 "$SPH2D" info none whole/snapshot_000001.h5 whole && prints '^file  *whole/snap' && prints '^folder  *whole$'
run 0 bare -s run.snapshots.per_second=0 && expect 66 "$SPH2D" info bare
if [ "$(id -u)" != 0 ]; then
    cp -r whole secret && chmod 000 secret
    expect 66 "$SPH2D" info secret && says 'ermission'
fi
if command -v python3 >/dev/null; then
    info whole blast --json
    python3 -c 'import json; a, b = map(json.loads, open("out")); assert a.keys() == b.keys() and len(a) == 22' ||
        fail 'not JSON, or not what it should be'
fi

#!/bin/bash
# One folder, several commands: it belongs to the first of them from before it prepares until it ends, and one that
# fails or is stopped while it prepares leaves no folder that it made.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# Obstacles of many points, around which it takes seconds to place many particles; else a part of a second: scene COUNT
# POINTS GRAVITY
scene() {
    awk -v count="$1" -v points="$2" -v gravity="$3" 'BEGIN {
        printf "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.05\nmethod: {name: wcsph}\ngravity: [0, %s]\n", gravity
        printf "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.2]}\nobstacles:\n"
        for (k = 0; k < count; ++k) {
            printf "  - polyline: ["
            for (i = 0; i < points; ++i)
                printf "%s[%.6f, %.6f]", i ? ", " : "", 0.1 + 0.8 * i / points, 0.5 + 0.2 * k + 0.05 * sin(i * 12 / points)
            printf "]\n"
        }
        printf "probes:\n  - {name: energy, kind: energy, every: 0.002}\n"
        printf "run: {until: 0.02, snapshots: {per_second: 200}}\n"
    }'
}
scene 2 2000 -9.81 >slow.yaml
scene 1 400 -9.81 >first.yaml
scene 1 400 -1.62 >second.yaml
printf 'scene: first.yaml\nruns: [{set: {}}]\n' >study.yaml

# start ARGUMENTS...: runs the command in the background, as $pid. A shell switches SIGINT off for those.
start() {
    env --default-signal=INT,TERM,HUP "$SPH2D" "$@" >/dev/null 2>err.start &
    pid=$!
}
ended() {
    code=0
    wait "$1" || code=$?
}

# While the first prepares: all that write there are refused, and a signal ends it at once.
for signal in HUP:129 INT:130 TERM:143; do
    start run slow.yaml -s spacing=0.0007 -q -o a/b/c
    await test -e a/b/c
    for force in -q --force; do
        expect 73 "$SPH2D" run first.yaml -q -o a/b/c $force && says "another sph2d is writing to 'a/b/c'"
        expect 73 "$SPH2D" render slow.yaml -q -o a/b/c $force && says 'another sph2d'
        expect 73 "$SPH2D" study study.yaml -q -o a/b/c $force && says 'another sph2d'
    done
    expect 73 "$SPH2D" resume a/b/c -q && says 'another sph2d'
    [ -z "$(ls a/b/c)" ] || fail 'the preparation is over too soon for this test'
    kill -"${signal%:*}" $pid
    ended $pid
    [ $code = "${signal#*:}" ] || fail "$signal: ended with $code"
    absent a
done

# Stopped while it prepares to replace a run: that is as it was.
expect 0 "$SPH2D" run first.yaml -q -o old/run && cp -r old kept
start run slow.yaml -s spacing=0.0007 -q -o old/run --force
has_locked() { grep -qs FLOCK /proc/$pid/fdinfo/*; }
await has_locked # the folder; to try the lock here could refuse it its own
expect 73 "$SPH2D" run first.yaml -q -o old/run -f && says 'another sph2d'
kill -TERM $pid
ended $pid
[ $code = 143 ] || fail "SIGTERM: ended with $code"
same old kept

# What fails after the folder is claimed: only folders that were made for it go.
mkdir before
for folder in new/with/parents before before/new; do
    expect 66 "$SPH2D" render missing.h5 -q -o $folder
    if can_draw; then
        expect 66 "$SPH2D" run "$TINY" -q -o $folder --shader-dir /nonexistent
    else
        expect 69 "$SPH2D" run "$TINY" -q -o $folder
    fi
done
absent new && absent before/new && present before
code=0
"$SPH2D" run "$TINY" -q -o old/run --force --shader-dir /nonexistent 2>err || code=$?
[ $code != 0 ] || fail 'drawn without shaders'
same old kept

# Two at once, at every distance: one of them has the folder, whole.
expect 0 "$SPH2D" run first.yaml -q -o whole_first
expect 0 "$SPH2D" run second.yaml -q -o whole_second
for distance in 0 0.02 0.06 0.12 0.25; do
    for force in -q --force; do
        rm -rf both
        start run first.yaml -q -o both $force
        first=$pid
        [ $distance = 0 ] || sleep $distance
        code=0
        "$SPH2D" run second.yaml -q -o both $force 2>err || code=$?
        second=$code
        ended $first
        case "$code $second" in
        '0 73') same whole_first both ;;
        '73 0') same whole_second both ;;
        '0 0')
            [ $force = --force ] || fail 'one overwrote the other'
            diff -rq whole_first both >out || same whole_second both
            ;;
        *) fail "after $distance s: ended with $code and $second" ;;
        esac
        [ $second = 0 ] || says 'another sph2d is writing\|exists and is not empty'
    done
done

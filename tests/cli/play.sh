#!/bin/sh
# Long: play opens a window, follows mouse and keys, and says what is missing where it cannot.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
if "$SPH2D" play "$TINY" --max-wall 1s 2>&1 | grep -q 'has no windows'; then
    expect 69 "$SPH2D" play && says libglfw3-dev
    exit 77
fi
DISPLAY='' expect 69 "$SPH2D" play "$TINY" && says 'no window can be opened' && says 'sph2d run'
expect 64 "$SPH2D" play "$TINY" "$TINY" && says 'one scene at a time'
expect 66 "$SPH2D" play missing.yaml
expect 65 "$SPH2D" play "$TINY" -s spacing=-1
command -v Xvfb >/dev/null && command -v xdotool >/dev/null || exit 77

# Leaks of a driver that was unloaded have no name by which a list could except them.
export ASAN_OPTIONS="detect_leaks=0${ASAN_OPTIONS:+:$ASAN_OPTIONS}"
# A display of its own, whose number Xvfb chooses.
Xvfb -displayfd 3 -screen 0 640x480x24 3>number >/dev/null 2>&1 &
server=$!
trap 'kill $server 2>/dev/null' EXIT
for _ in $(seq 100); do [ -s number ] || sleep 0.05; done
DISPLAY=:$(cat number)
export DISPLAY

# What it has to say when it is closed by a key: pictures, simulated time, particles.
play() {
    "$SPH2D" play --size 320x240 -j1 --max-wall 60s "$@" >out 2>err &
    pid=$!
    window=$(xdotool search --sync --onlyvisible --name '^sph2d$' | tail -n 1)
    xdotool windowfocus "$window" mousemove --window "$window" 160 60
}
quit() {
    xdotool key q
    code=0
    wait $pid || code=$?
    [ $code = 0 ] || fail "play ended with $code"
    says 'played [0-9.]* s: [0-9]* pictures, [0-9.]* a second; simulated'
    ! grep 'stopped at t' err || fail 'a simulation stopped'
}
# Waits until a file is there.
until_there() { await test -e "$1"; }

cat >pool.yaml <<END
name: pool
domain: {min: [0, 0], max: [1.2, 0.9]}
spacing: 0.03
blocks:
  - box: {min: [0, 0], max: [1.2, 0.3]}
END
expect 0 "$SPH2D" check pool.yaml --json
first=$(sed -n 's/.*"particles": \([0-9]*\),.*/\1/p' out)

# Liquid is poured and a wall is drawn, the fluid changes, all is saved, and a film is made.
play pool.yaml
xdotool key o mousedown 1
sleep 3 # on a busy machine a step takes long
xdotool mouseup 1 key w mousemove --window "$window" 60 100 mousedown 1
for x in 110 160 210; do
    sleep 0.3
    xdotool mousemove --window "$window" $x 100
done
sleep 0.3
xdotool mouseup 1
sleep 0.3
xdotool key v v v n n n x i z c c c f
until_there film_000/frame_000001.png
xdotool key f s
until_there played_000/snapshot_000000.h5
quit
poured=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$poured" -gt "$first" ] || fail "$poured particles after pouring, $first before"
grep -q 'polyline' played_000/scene.yaml || fail 'no wall was drawn'
grep -q 'dynamic_viscosity' played_000/scene.yaml || fail 'the viscosity is as before'
expect 0 "$SPH2D" check played_000/scene.yaml -q
expect 0 "$SPH2D" info played_000/snapshot_000000.h5
expect 0 "$SPH2D" resume played_000 -q --no-frames

# Another spacing starts again, so that the machine follows.
play pool.yaml
sleep 1
xdotool key a
sleep 1
quit
fitted=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$fitted" != "$first" ] || fail "$fitted particles before and after the fit"

# A scene of play gets the particles that keep the clock here, but those of a spacing that is given.
particles() { sed -n 's/.*; \([0-9]*\) particles.*/\1/p' err; }
play
sleep 3
quit
kept=$(particles)
if [ "$kept" -le 500 ] || [ "$kept" -gt 16600 ]; then fail "$kept particles"; fi
play -s spacing=0.02
sleep 3
quit
kept=$(particles)
if [ "$kept" -le 800 ] || [ "$kept" -ge 900 ]; then fail "$kept particles with a spacing of 0.02 m"; fi

# Wiping takes liquid away, also with dots, while the run is paused; another scene has other particles.
play pool.yaml --style points --color speed
xdotool key space key e mousemove --window "$window" 60 180 mousedown 1
sleep 1
xdotool mouseup 1
quit
wiped=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$wiped" -lt "$first" ] || fail "$wiped particles after wiping, $first before"
says 'simulated 0[0-9.]* s'

# So does pouring, which fills the reach at once then.
play pool.yaml
xdotool key space key o mousemove --window "$window" 60 60 mousedown 1
sleep 1
xdotool mouseup 1
quit
poured=$(particles)
[ "$poured" -gt "$first" ] || fail "$poured particles after pouring while paused, $first before"
says 'simulated 0[0-9.]* s'

# A wall is drawn where the liquid is now, not where it was at first: it may turn sharply, cross itself, stand where a block
# was and in scenes whose walls and bodies move, and be drawn without gravity. A click of the right button takes it away.
cat >column.yaml <<END
name: column
domain: {min: [0, 0], max: [1.2, 0.9]}
spacing: 0.03
blocks:
  - box: {min: [0, 0], max: [0.4, 0.6]}
obstacles:
  - {box: {min: [1, 0.5], max: [1.1, 0.6]}, motion: {amplitude: [0.05, 0], frequency: 1}}
bodies:
  - {box: {min: [0.7, 0.7], max: [0.8, 0.8]}, density: 5000}
END
draw() { # X Y...: a wall through places of the window
    xdotool key w mousemove --window "$window" "$1" "$2" mousedown 1
    shift 2
    while [ $# -gt 0 ]; do
        sleep 0.2
        xdotool mousemove --window "$window" "$1" "$2"
        shift 2
    done
    sleep 0.2
    xdotool mouseup 1
    sleep 0.2
}
walls() { # how many the saved scene has
    until_there "$1"/snapshot_000000.h5
    grep -c polyline "$1"/scene.yaml || :
}
play column.yaml
sleep 2
draw 60 60 120 120 60 120 120 60 120 160
xdotool key 0
draw 60 180 120 180
draw 150 60 230 60 # where the body was
xdotool key s
[ "$(walls played_001)" -ge 6 ] || fail 'no wall was drawn where a block was'
expect 0 "$SPH2D" resume played_001 -q --no-frames -s run.until=0
xdotool mousemove --window "$window" 90 180 click 3
sleep 0.3
xdotool key s
drawn=$(walls played_001)
[ "$(walls played_002)" = $((drawn - 1)) ] || fail 'the wall was not taken away'
# Each is undone: the wall that was taken away, the walls, and gravity between them; then there is nothing.
xdotool key u
sleep 0.2
xdotool key s
[ "$(walls played_003)" = "$drawn" ] || fail 'the wall that was taken away did not come back'
xdotool key u u u ctrl+z u
sleep 0.2
xdotool key s
[ "$(walls played_004)" = 0 ] || fail 'walls after they were undone'
! grep -q 'gravity: \[0, 0\]' played_004/scene.yaml || fail 'no gravity after that was undone'
quit

# Liquid that leaves a tank is told, and comes back: by undo, or from the start.
play pool.yaml
xdotool key Up
sleep 3
xdotool key u
sleep 0.5
quit
grep -q "; $first particles$" err || fail "not $first particles after undo"
for wait in 3 12 48; do # on a busy machine it takes longer until some has left
    play pool.yaml
    xdotool key Up
    sleep $wait
    quit
    left=$(sed -n 's/.* \([0-9]*\) particles, \([0-9]*\) left through open sides$/\1 + \2/p' err)
    [ -z "$left" ] || break
done
[ "$((left))" = "$first" ] || fail "not $first particles in all: $left"
play pool.yaml
xdotool key Up
sleep 3
xdotool key r
sleep 1
quit
grep -q "; $first particles$" err || fail "not $first particles after a new start, with the scene's gravity"

# Ten acts at most.
play pool.yaml
xdotool key v v v v v v v v v v v v s
until_there played_005/snapshot_000000.h5
xdotool key u u u u u u u u u u u u u u s
until_there played_006/snapshot_000000.h5
quit
viscosity() { sed -n 's/.*dynamic_viscosity: *\([0-9.e-]*\).*/\1/p' "$1"/scene.yaml; }
awk "BEGIN { exit !($(viscosity played_005) / $(viscosity played_006) == 1024) }" ||
    fail "$(viscosity played_005) Pa s, $(viscosity played_006) after ten acts were undone"

# The example draws into a window of its own.
example=$SPH2D_ROOT/build/examples/window
if [ -x "$example" ]; then
    "$example" >out 2>err &
    pid=$!
    window=$(xdotool search --sync --onlyvisible --name '^liquid$' | tail -n 1)
    xdotool mousemove --window "$window" 300 100 mousedown 1
    wait $pid || fail 'the example fails'
    xdotool mouseup 1
    grep -q '^[0-9]* particles, 2.0 s$' out || fail 'the example says something else'
fi

# It ends by a signal, and by its time.
play
kill -TERM $pid
code=0
wait $pid || code=$?
[ $code = 143 ] || fail "SIGTERM: ended with $code"
expect 0 "$SPH2D" play "$TINY" --max-wall 1s --size 320x240 && says 'played'

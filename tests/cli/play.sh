#!/bin/sh
# play opens a window, follows mouse and keys, and says what is missing where it cannot.
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
}
# Presses keys until a file is there.
until_there() {
    for _ in $(seq 200); do
        [ ! -e "$1" ] || return 0
        sleep 0.1
    done
    fail "no $1"
}

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
sleep 1
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

# Wiping takes liquid away, also with dots, while the run is paused; another scene has other particles.
play pool.yaml --style points --color speed
xdotool key space key e mousemove --window "$window" 60 180 mousedown 1
sleep 1
xdotool mouseup 1
quit
wiped=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$wiped" -lt "$first" ] || fail "$wiped particles after wiping, $first before"
says 'simulated 0[0-9.]* s'

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

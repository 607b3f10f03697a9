#!/bin/sh
# Long: play opens a window, follows mouse and keys, and says what is missing where it cannot.
# shellcheck disable=SC1091,SC2154
. "$SPH2D_ROOT/tests/cli/common"
if "$SPH2D" play "$TINY" --max-wall 1s 2>&1 | grep -q 'has no windows'; then
    expect 69 "$SPH2D" play && says libglfw3-dev
    exit 77
fi
DISPLAY='' expect 69 "$SPH2D" play "$TINY" && says 'no window can be opened' && says 'sph2d run'
expect 64 "$SPH2D" play "$TINY" "$TINY" && says 'one scene at a time'
expect 66 "$SPH2D" play missing.yaml
expect 65 "$SPH2D" play "$TINY" -s spacing=-1
. "$SPH2D_ROOT/tests/cli/window"

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
xdotool key v v v n n n x i z c c c s
until_there played_000/snapshot_000000.h5
quit
poured=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$poured" -gt "$first" ] || fail "$poured particles after pouring, $first before"
grep -q 'polyline' played_000/scene.yaml || fail 'no wall was drawn'
grep -q 'dynamic_viscosity' played_000/scene.yaml || fail 'the viscosity is as before'
expect 0 "$SPH2D" check played_000/scene.yaml -q
expect 0 "$SPH2D" info played_000/snapshot_000000.h5
expect 0 "$SPH2D" resume played_000 -q --no-frames

# A film is made by ffmpeg, also of a window that is closed; without it there are frames.
frames_of() { ffmpeg -hide_banner -nostdin -i "$1" -map 0:v -f framemd5 - 2>/dev/null | grep -vc '^#'; }
if command -v ffmpeg >/dev/null; then
    play pool.yaml
    xdotool key f
    sleep 2
    [ ! -e film_000.mp4 ] || fail 'the film is there before it is whole'
    xdotool key f
    until_there film_000.mp4
    xdotool key f
    sleep 2
    quit
    for film in film_000.mp4 film_001.mp4; do
        [ "$(frames_of $film)" -gt 3 ] || fail "$(frames_of $film) frames in $film"
    done
    [ -z "$(find . -name '.film*')" ] || fail 'unfinished films are left'
fi
PATH=/nowhere "$SPH2D" play --size 320x240 -j1 --max-wall 60s pool.yaml >out 2>err &
pid=$!
find_window
xdotool key f
until_there film_000/frame_000001.png
xdotool key f
quit

# Another spacing starts again, so that the machine follows.
play pool.yaml
sleep 1
xdotool key a
sleep 1
quit
fitted=$(sed -n 's/.*; \([0-9]*\) particles$/\1/p' err)
[ "$fitted" != "$first" ] || fail "$fitted particles before and after the fit"

# A scene of play gets the particles that keep the clock here, but those of a spacing that is given.
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

# All scenes of its own are without errors and warnings, and are reached by keys.
for file in "$SPH2D_ROOT"/cli/play/scenes/*.yaml; do
    expect 0 "$SPH2D" check "$file" -q
    ! grep warning err || fail "${file##*/} is warned of"
done
play pool.yaml
xdotool key Prior
sleep 0.5
save played_001
xdotool key Next Tab
sleep 0.5
save played_002
quit
grep -q '^name: "boat race"$' played_001/scene.yaml || fail 'the last scene is another one'
grep -q '^name: "two dams"$' played_002/scene.yaml || fail 'the next scenes are others'

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
walls() { # how many the saved scene has
    until_there "$1"/snapshot_000000.h5
    grep -c polyline "$1"/scene.yaml || :
}
play column.yaml
sleep 2
draw w 60 60 120 120 60 120 120 60 120 160
xdotool key 0
draw w 60 180 120 180
draw w 150 60 230 60 # where the body was
xdotool key s
[ "$(walls played_003)" -ge 6 ] || fail 'no wall was drawn where a block was'
expect 0 "$SPH2D" resume played_003 -q --no-frames -s run.until=0
xdotool mousemove --window "$window" 90 180 click 3
sleep 0.3
xdotool key s
drawn=$(walls played_003)
[ "$(walls played_004)" = $((drawn - 1)) ] || fail 'the wall was not taken away'
# Each is undone: the wall that was taken away, the walls, and gravity between them; then there is nothing.
xdotool key u
sleep 0.2
xdotool key s
[ "$(walls played_005)" = "$drawn" ] || fail 'the wall that was taken away did not come back'
xdotool key u u u ctrl+z u
sleep 0.2
xdotool key s
[ "$(walls played_006)" = 0 ] || fail 'walls after they were undone'
! grep -q 'gravity: \[0, 0\]' played_006/scene.yaml || fail 'no gravity after that was undone'
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
until_there played_007/snapshot_000000.h5
xdotool key u u u u u u u u u u u u u u s
until_there played_008/snapshot_000000.h5
quit
viscosity() { sed -n 's/.*dynamic_viscosity: *\([0-9.e-]*\).*/\1/p' "$1"/scene.yaml; }
awk "BEGIN { exit !($(viscosity played_007) / $(viscosity played_008) == 1024) }" ||
    fail "$(viscosity played_007) Pa s, $(viscosity played_008) after ten acts were undone"

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

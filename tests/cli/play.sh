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
    find_window
}
find_window() {
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
save() { # FOLDER
    xdotool key s
    until_there "$1"/snapshot_000000.h5
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
draw() { # KEY X Y...: a wall or a body through places of the window
    xdotool key "$1" mousemove --window "$window" "$2" "$3" mousedown 1
    shift
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

# Bodies are drawn, held and let go while the run is paused, and one is moved; what is saved then runs.
count() { grep -c "$1" "$2"/scene.yaml || :; }
play pool.yaml
xdotool key space
draw d 90 60 110 60 125 60       # a circle from its centre
draw d 180 50 200 70 230 90      # a box from corner to corner
draw d 250 40 300 40 300 90 250 90 250 45 # an outline
draw j 205 70                    # a hinge in the middle of the box
draw j 90 60 70 40 60 20         # a spring from the circle
save played_007
[ "$(count density played_007)" = 3 ] || fail 'not three bodies'
[ "$(count stiffness played_007)" = 2 ] || fail 'not two springs'
[ "$(count 'length: 0$' played_007)" = 1 ] || fail 'not one hinge'
grep -q 'density: 500$' played_007/scene.yaml || fail 'bodies are not half as dense as the liquid'
xdotool key bracketright
draw p 275 60 275 45 275 35 # up
draw d 90 170 110 170 120 170 # in the liquid
save played_008
! cmp -s played_007/scene.yaml played_008/scene.yaml || fail 'the body was not moved'
grep -q 'density: 625$' played_008/scene.yaml || fail 'the body is not denser'
[ "$(count density played_008)" = 4 ] || fail 'no body in the liquid'
xdotool click 3 # there
sleep 0.3
save played_009
[ "$(count density played_009)" = 3 ] || fail 'the body was not taken away'
xdotool key space
sleep 2
draw j 205 70
save played_010
[ "$(count stiffness played_010)" = 1 ] || fail 'the box was not let go'
xdotool key u
sleep 0.3
save played_011
[ "$(count stiffness played_011)" = 2 ] || fail 'the hinge did not come back'
quit
for saved in played_007 played_008 played_009 played_010; do
    expect 0 "$SPH2D" check $saved/scene.yaml -q
    expect 0 "$SPH2D" run $saved/scene.yaml -o run_$saved -q --no-frames -s run.until=0.2
    expect 0 "$SPH2D" resume $saved -q --no-frames -s run.until=0
done

# The wheel with Ctrl zooms about the mouse, the middle button moves the view, Home shows all: boxes as large on the screen
# are smaller in the scene, or elsewhere. A click takes one away.
box() { # N: the corners of box N of the last scene: xmin ymin xmax ymax
    sed -n '/^bodies:/,$s/^ *\(min\|max\): \[\(.*\), \(.*\)\]$/\2 \3/p' "$last"/scene.yaml | paste -d ' ' - - | sed -n "$1p"
}
play pool.yaml
xdotool key space
draw d 250 20 260 25 # picks the circle; too small for a body
draw d 200 40 220 50 260 90
xdotool mousemove --window "$window" 80 60 keydown ctrl click 4 click 4 click 4 click 4 click 4 keyup ctrl
draw p 80 60
xdotool key d
draw d 60 40 80 50 120 90
xdotool mousemove --window "$window" 260 60 mousedown 2
sleep 0.3
xdotool mousemove --window "$window" 160 60
sleep 0.3
xdotool mouseup 2
sleep 0.3
xdotool key d d
draw d 60 40 80 50 120 90
xdotool key Home
sleep 0.3
xdotool key d d
draw d 30 20 50 30 62 52
last=played_012
save $last
awk -v wide="$(box 1)" -v zoomed="$(box 2)" -v moved="$(box 3)" -v home="$(box 4)" 'function differs(a, b) { return (a - b)^2 > 0.004^2 }
    BEGIN {
        split(wide, a); split(zoomed, b); split(moved, c); split(home, d); factor = 1.1^5
        pixel = (a[3] - a[1]) / 60
        exit differs((a[3] - a[1]) / factor, b[3] - b[1]) || differs(c[3] - c[1], b[3] - b[1]) || differs(c[1] - b[1], 100 * pixel / factor) ||
            differs(d[3] - d[1], 32 * pixel) || differs(a[1] - d[1], 170 * pixel)
    }' || fail "views: $(box 1), $(box 2), $(box 3), $(box 4)"
xdotool mousemove --window "$window" 45 40 click 1
sleep 0.3
last=played_013
save $last
[ "$(count density $last)" = 3 ] || fail 'a click does not take a body away'
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
until_there played_014/snapshot_000000.h5
xdotool key u u u u u u u u u u u u u u s
until_there played_015/snapshot_000000.h5
quit
viscosity() { sed -n 's/.*dynamic_viscosity: *\([0-9.e-]*\).*/\1/p' "$1"/scene.yaml; }
awk "BEGIN { exit !($(viscosity played_014) / $(viscosity played_015) == 1024) }" ||
    fail "$(viscosity played_014) Pa s, $(viscosity played_015) after ten acts were undone"

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

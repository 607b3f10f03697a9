#!/bin/sh
# Long: bodies that are drawn, moved and held in the window of play, and its view.
# shellcheck disable=SC1091,SC2154
if "$SPH2D" play missing.yaml 2>&1 | grep -q 'has no windows'; then exit 77; fi
. "$SPH2D_ROOT/tests/cli/window"

# Bodies are drawn, held and let go while the run is paused, and one is moved; what is saved then runs.
play pool.yaml
xdotool key space
draw d 90 60 110 60 125 60       # a circle from its centre
draw d 180 50 200 70 230 90      # a box from corner to corner
draw d 250 40 300 40 300 90 250 90 250 45 # an outline
draw j 205 70                    # a hinge in the middle of the box
draw j 90 60 70 40 60 20         # a spring from the circle
save played_000
[ "$(count density played_000)" = 3 ] || fail 'not three bodies'
[ "$(count stiffness played_000)" = 2 ] || fail 'not two springs'
[ "$(count 'length: 0$' played_000)" = 1 ] || fail 'not one hinge'
grep -q 'density: 500$' played_000/scene.yaml || fail 'bodies are not half as dense as the liquid'
xdotool key bracketright
draw p 275 60 275 45 275 35 # up
draw d 90 170 110 170 120 170 # in the liquid
save played_001
! cmp -s played_000/scene.yaml played_001/scene.yaml || fail 'the body was not moved'
grep -q 'density: 625$' played_001/scene.yaml || fail 'the body is not denser'
[ "$(count density played_001)" = 4 ] || fail 'no body in the liquid'
xdotool click 3 # there
sleep 0.3
save played_002
[ "$(count density played_002)" = 3 ] || fail 'the body was not taken away'
xdotool key space
sleep 2
draw j 205 70
save played_003
[ "$(count stiffness played_003)" = 1 ] || fail 'the box was not let go'
xdotool key u
sleep 0.3
save played_004
[ "$(count stiffness played_004)" = 2 ] || fail 'the hinge did not come back'
quit
for saved in played_000 played_001 played_002 played_003; do
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
last=played_005
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
last=played_006
save $last
[ "$(count density $last)" = 3 ] || fail 'a click does not take a body away'
quit

# Liquid is poured in a colour of its own, and what there was keeps that of water; undo takes it away.
played_colors() { # FOLDER: how many particles are of which colour
    expect 0 "$SPH2D" export "$1"/snapshot_000000.h5 -o "$1"/all.csv -q
    awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) if ($k == "color") at = k; next }
        { ++n[at ? $at : "none"] } END { for (c in n) printf "%s=%d ", c, n[c] }' "$1"/all.csv
}
play pool.yaml
xdotool key space comma
draw o 250 30 255 30
save played_007
xdotool key u
sleep 0.3
save played_008
quit
poured=$(played_colors played_007)
case " $poured" in *' 14423100='[1-9]*) ;; *) fail "no crimson: $poured" ;; esac
case " $poured" in *' 2851535='[1-9][0-9]*) ;; *) fail "no water: $poured" ;; esac
case " $(played_colors played_008)" in *14423100*) fail "crimson after undo" ;; esac
expect 0 "$SPH2D" resume played_007 -q --no-frames -s run.until=0.3

# A tracer draws its path while one plays, and keeps it.
{ cat pool.yaml && echo 'probes: [{name: leaf, kind: tracer, at: [0.5, 0.1], every: 0.02}]'; } >leaf.yaml
play leaf.yaml
sleep 1
save played_009
quit
"$SPH2D" info played_009/snapshot_000000.h5 | grep -Eq '^ *TracerPlaces +[1-9][0-9]* values' || fail 'no path of the tracer'

#!/bin/sh
# render draws from snapshots what run drew from memory, to the pixel.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
if ! can_draw; then
    expect 69 "$SPH2D" run "$TINY" -o folder && absent folder && says 'P401' && says 'no-frames'
    exit 77
fi

for style in metaballs points; do
    expect 0 "$SPH2D" run "$TINY" -o $style -q -s run.frames.style=$style -s run.frames.color=speed
    expect 0 "$SPH2D" render $style/snapshot_*.h5 -o again_$style &&
        says "11 frames in 'again_$style': [0-9.]* ms each to draw, [0-9.]* to read back, [0-9.]* to encode\$"
    same $style/frames again_$style
done
cmp -s metaballs/frames/frame_000005.png points/frames/frame_000005.png && fail 'styles look the same'
expect 0 "$SPH2D" render metaballs/snapshot_000005.h5 -o as_points --style points --color speed -q && silent
same as_points/frame_000000.png points/frames/frame_000005.png

# Options change the picture; frames are numbered in the order given.
snapshot=points/snapshot_000005.h5
for option in --size=200x100 --style=metaballs --radius=0.1 --background=transparent --view=0,0,0.5,0.5 --arrows \
    --streamlines --color=vorticity --isolines=Pressures --color=Pressures --range=0,9; do
    expect 0 "$SPH2D" render $snapshot -o "with$option" -q "$option"
    cmp -s "with$option/frame_000000.png" points/frames/frame_000005.png && fail "$option changes nothing"
done
# One range for all frames: the widest of the percentiles of each, of what is in view; all of it; or what is told. With a
# range of its own a frame alone looks different.
several=$(echo points/snapshot_00000[0-5].h5)
# shellcheck disable=SC2086
for range in percentiles full 0..1500 0,1500; do
    expect 0 "$SPH2D" render $several -o range_$range -q --color Pressures --range $range
done
# shellcheck disable=SC2086
expect 0 "$SPH2D" render $several -o range_default -q --color Pressures && same range_default range_percentiles
same range_0..1500 range_0,1500
for range in full 0..1500; do
    cmp -s range_$range/frame_000005.png range_percentiles/frame_000005.png && fail "$range is as percentiles"
done
expect 0 "$SPH2D" render points/snapshot_000002.h5 -o range_alone -q --color Pressures
cmp -s range_alone/frame_000000.png range_default/frame_000002.png && fail 'a range for each frame'
# percentiles LEFT RIGHT: LOW..HIGH of the pressures between two places, by the definition.
"$SPH2D" export $snapshot -q >particles.csv
percentiles() {
    awk -F, -v left="$1" -v right="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[substr($i, 1, index($i " ", " ") - 1)] = i; next }
        $at["x"] >= left && $at["x"] <= right { print $at["pressure"] }' particles.csv | sort -g |
        awk '{ p[NR - 1] = $1 } END { out = int(0.01 * (NR - 1) + 0.5); print p[out] ".." p[NR - 1 - out] }'
}
for part in 0,1 0,0.3; do
    expect 0 "$SPH2D" render $snapshot -o "part_$part" -q --color Pressures --view "${part%,*},-1,${part#*,},2"
    expect 0 "$SPH2D" render $snapshot -o "told_$part" -q --color Pressures --view "${part%,*},-1,${part#*,},2" \
        --range="$(percentiles "${part%,*}" "${part#*,}")"
    same "part_$part" "told_$part"
done
for range in 1..1 2..1 1.. ..1 1 fulll 1..x; do
    expect 64 "$SPH2D" render $snapshot -o x --range $range && says "'$range' is not LOW..HIGH"
done
# A field without a range from the scene: the same from memory and from a snapshot alone.
expect 0 "$SPH2D" run "$TINY" -o densities -q -s run.frames.color=Densities
expect 0 "$SPH2D" render densities/snapshot_000005.h5 -o density -q
same density/frame_000000.png densities/frames/frame_000005.png

for look in flat glass ink; do
    expect 0 "$SPH2D" render metaballs/snapshot_000005.h5 -o look_$look -q --look $look
    expect 0 "$SPH2D" run "$TINY" -o with_$look -q -s run.frames.look=$look -s run.frames.color=speed
    same with_$look/frames/frame_000005.png look_$look/frame_000000.png
    cmp -s look_$look/frame_000000.png metaballs/frames/frame_000005.png && fail "$look looks like water"
done
# width and height stand at byte 16 of a PNG
[ "$(od -An -tu1 -j 16 -N 8 with--size=200x100/frame_000000.png | tr -s ' ')" = ' 0 0 0 200 0 0 0 100' ] ||
    fail 'not 200 x 100'
# and the kind of pixels at 25: 2 RGB, 6 RGBA
kinds=$(for with in size=200x100 background=transparent; do od -An -tu1 -j 25 -N 1 "with--$with/frame_000000.png"; done | tr -d ' \n')
[ "$kinds" = 26 ] || fail "kinds of pixels: $kinds"
expect 0 "$SPH2D" render points/snapshot_000007.h5 points/snapshot_000002.h5 -o order && says 'earlier'
same order/frame_000000.png points/frames/frame_000007.png
same order/frame_000001.png points/frames/frame_000002.png

# Every wall is in the image, where the width limits the view, too: a tank without its left side looks different.
cat >wide.yaml <<END
domain: {min: [0, 0], max: [1, 0.4]}
spacing: 0.02
blocks:
  - box: {min: [0.3, 0], max: [0.6, 0.2]}
run: {frames: {every: 1, style: points, color: speed}}
END
for side in wall open; do
    expect 0 "$SPH2D" check wide.yaml -q -s boundary.left=$side --preview $side.png
done
cmp -s wall.png open.png && fail 'the left wall is outside the image'

# A body that falls stays in the middle, from memory and from snapshots; another one is not there.
cat >fall.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.02
blocks:
  - box: {min: [0, 0], max: [1, 0.1]}
bodies:
  - {name: ball, circle: {center: [0.4, 0.3], radius: 0.1}, density: 2000}
run:
  until: 0.1
  snapshots: {every: 0.05}
  frames:
    {every: 0.05, size: [200, 100], view: {min: [0, 0], max: [1, 0.5]}, follow: ball, caption: off, arrows: on, streamlines: on,
     isolines: vorticity, color: vorticity}
END
expect 0 "$SPH2D" run fall.yaml -o fall -q
expect 0 "$SPH2D" render fall/snapshot_*.h5 -o again_fall -q -j 1
same fall/frames again_fall
expect 0 "$SPH2D" run fall.yaml -o fall_1 -q -j 1 && same fall/frames fall_1/frames
cmp -s again_fall/frame_000000.png again_fall/frame_000002.png && fail 'the view rests'
expect 65 "$SPH2D" run fall.yaml -o x -s run.frames.follow=bal && absent x && says 'did you mean'
expect 65 "$SPH2D" render fall/snapshot_000001.h5 -o x --follow bal && says "no obstacle or body 'bal'"

# A signal stops it after a frame.
many=''
for _ in $(seq 60); do many="$many $(echo points/snapshot_*.h5)"; done
# shellcheck disable=SC2086
env --default-signal=INT,TERM,HUP "$SPH2D" render $many -o stopped --progress never >out 2>err &
pid=$!
await test -e stopped/frame_000002.png
kill -HUP $pid
code=0
wait $pid || code=$?
[ $code = 129 ] || fail "SIGHUP: ended with $code"
says 'stopped by SIGHUP after [0-9]* of 660 frames' && absent stopped/frame_000659.png
[ "$(find stopped -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left'

# Folders: as run has it, and --force removes frames alone.
expect 73 "$SPH2D" render $snapshot -o order && says F207
cp $snapshot order/snapshot_000000.h5
expect 0 "$SPH2D" render order/snapshot_000000.h5 -o order -f -q
absent order/frame_000001.png && same order/snapshot_000000.h5 $snapshot

# One snapshot is one picture where its name says so, whole or not at all.
expect 0 "$SPH2D" render $snapshot -o alone.png -q && cmp alone.png order/frame_000000.png
expect 73 "$SPH2D" render $snapshot -o alone.png -q && says 'exists already'
expect 0 "$SPH2D" render $snapshot -o alone.png -q --force
expect 64 "$SPH2D" render $snapshot $snapshot -o both.png -q && absent both.png && says '2 snapshots are no single picture'

# What cannot be drawn or read.
expect 66 "$SPH2D" render missing.h5 -o x && absent x
expect 65 "$SPH2D" render "$TINY" -o x && absent x
expect 66 "$SPH2D" render / -o x && absent x
expect 66 "$SPH2D" render $snapshot -o x --shader-dir /nonexistent && absent x && says nonexistent
backends=$("$SPH2D" --version | sed -n 's/^rendering *//p')
for gl in osmesa egl; do
    case $backends in
    *$gl*)
        # A context that is built in may still not come up on this machine.
        "$SPH2D" render $snapshot -o gl_$gl -q --gl $gl || [ $? = 69 ] || fail "$gl"
        [ ! -e gl_$gl ] || same gl_$gl/frame_000000.png points/frames/frame_000005.png
        ;;
    *) expect 69 "$SPH2D" render $snapshot -o x --gl $gl && absent x ;;
    esac
done

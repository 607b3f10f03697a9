#!/bin/sh
# Frames that are encoded beside the steps: the same files as in turn, and the same errors.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
can_draw || exit 77

# Frames more often, less often and as often as snapshots. What waits is written before the run ends.
for rates in '100 25' '25 100' '50 50' '100 0'; do
    frames=${rates% *} snapshots=${rates#* }
    for threads in 1 2; do
        expect 0 "$SPH2D" run "$TINY" -o "by_$threads" -q -f -j $threads -s run.until=0.2 \
            -s run.frames.per_second="$frames" -s run.snapshots.per_second="$snapshots"
    done
    same by_1 by_2
done
[ "$(find by_2/frames -name '*.png' | wc -l)" = 21 ] || fail 'not 21 frames'
expect 0 "$SPH2D" run "$TINY" -o told -j 2 --json && prints '"frames": {"count": 11, .*"encode_seconds": 0.0*[1-9]'

# An image takes more than the limit on the size of files, which stands in for a full disk; nothing else does.
for threads in 1 2; do
    code=0
    (
        ulimit -f 8
        exec "$SPH2D" run "$TINY" -o full_$threads -q -j $threads -s run.until=1000 -s run.snapshots.per_second=0 \
            -s 'run.frames.size=[640, 480]' -s run.frames.color=speed
    ) 2>err || code=$?
    [ $code = 74 ] || fail "no room for a frame, $threads threads: ended with $code"
    [ "$(grep -c error err)" = 1 ] || fail 'not one error'
    says "error.F206.: cannot write 'full_$threads/frames/frame_000000.png': File too large" && says 'hint: make room'
    absent full_$threads/frames # it made that folder, and nothing is in it
done

# A frame that fails is before its snapshot, which then does not come either.
"$SPH2D" run "$TINY" -o gone --progress never -j 2 -s run.until=1000 2>err &
pid=$!
await test -e gone/snapshot_000002.h5
mv gone/frames gone/went
code=0
wait $pid || code=$?
[ $code = 73 ] || [ $code = 74 ] || fail "without its folder of frames it ended with $code"
says "F206.*'gone/frames/" && says 'hint: its folder may have been removed' && says "'sph2d resume gone' continues"
[ "$(find gone -path gone/went -prune -o -name '.*.tmp.*' -print | wc -l)" = 0 ] || fail 'temporary files are left'
rm -f gone/went/.*.tmp.* # of a frame whose folder went away beneath it
frames=$(find gone/went -name '*.png' | wc -l) snapshots=$(find gone -name 'snapshot_*.h5' | wc -l)
[ "$frames" = "$snapshots" ] || fail "$snapshots snapshots say of more or less than $frames frames"
rm -rf gone/frames && mv gone/went gone/frames
until=$(awk "BEGIN { print ($snapshots + 3) / 25 }")
expect 0 "$SPH2D" resume gone -q -j 2 -s run.until="$until" && silent
expect 0 "$SPH2D" run "$TINY" -o never_gone -q -j 1 -s run.until="$until" && same never_gone/frames gone/frames

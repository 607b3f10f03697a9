#!/bin/sh
# Long: render --film: pixels go to ffmpeg, in order, and a film is there when it is whole.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
expect 0 "$SPH2D" run "$TINY" -o folder -q --no-frames

# A folder stands for its snapshots.
expect 64 "$SPH2D" render folder && says 'film'
expect 64 "$SPH2D" render folder -o x --film x.mp4 && says 'one of the two'
expect 64 "$SPH2D" render folder --film x.avi && says "'x.avi' is not the name of a film"
expect 64 "$SPH2D" render folder --film .mp4 && says "'.mp4' is not the name of a film"
expect 64 "$SPH2D" render folder -o x --fps 3 && says 'for films'
for fps in 0 -1 nan inf 1001 x ''; do
    expect 64 "$SPH2D" render folder --film x.mp4 --fps "$fps" && says 'a number above 0'
done
mkdir -p empty only/frames && : >only/frames/frame_000000.png
expect 66 "$SPH2D" render empty --film x.mp4 && says "no snapshots in 'empty'" && says 'run.snapshots'
expect 66 "$SPH2D" render only --film x.mp4 && says 'only frames' && says 'ffmpeg -framerate'
expect 66 "$SPH2D" render folder missing.h5 --film x.mp4
expect 65 "$SPH2D" render "$TINY" --film x.mp4
if ! can_draw; then
    expect 69 "$SPH2D" render folder --film x.mp4 && absent x.mp4
    exit 77
fi
expect 0 "$SPH2D" render folder -o pictures -q && expect 0 "$SPH2D" render folder/snapshot_*.h5 -o one_by_one -q
same pictures one_by_one
PATH=/nonexistent expect 69 "$SPH2D" render folder --film x.mp4 && says 'apt install ffmpeg' && absent x.mp4

no_leftovers() { [ "$(find . -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left'; }
no_leftovers

# What ffmpeg gets, by one that keeps it.
real=$PATH
mkdir bin
PATH=$PWD/bin:$real
stand_in() { printf '#!/bin/sh\n%s\n' "$1" >bin/ffmpeg && chmod +x bin/ffmpeg; }
# shellcheck disable=SC2016
stand_in 'printf "%s\n" "$@" >told; for last; do :; done; cat >"${last#file:}"'
for threads in 1 2; do
    expect 0 "$SPH2D" render folder --film by_$threads.mp4 -j $threads --size 97x63
    says "'by_$threads.mp4': 97 x 63 pixels, 11 frames, 25 a second, the pace of the scene; [0-9.]* ms each to draw"
done
same by_1.mp4 by_2.mp4
[ "$(wc -c <by_1.mp4)" = $((11 * 97 * 63 * 4)) ] || fail 'not 11 frames of 97 x 63'
grep -qx 25 told || fail 'another rate'
grep -q 'crop=' told || fail 'odd sides stay odd'
expect 0 "$SPH2D" render folder/snapshot_00000[12].h5 --film ordered.mp4 -q --size 97x63 && silent
tail -c +$((97 * 63 * 4 + 1)) by_1.mp4 | head -c $((2 * 97 * 63 * 4)) | cmp - ordered.mp4 >&2 || fail 'another order'
expect 0 "$SPH2D" render folder --film -slow.mp4 --fps 12.5 && says '12.5 a second, 0.5 times the pace' && present ./-slow.mp4
expect 0 "$SPH2D" render folder --film fast.gif --fps 50 && says '50 a second (25 of them are in the film), 2 times'
grep -q 'fps=25,.*palettegen' told || fail 'all frames are in the image'
expect 0 "$SPH2D" render folder --film wide.gif -q
[ "$(wc -c <wide.gif)" = $((11 * 96 * 64 * 4)) ] || fail 'another size than that of the frames'
expect 0 "$SPH2D" run "$TINY" -o large -q --no-frames -s 'run.frames.size=[1280, 720]' -s run.until=0.05
expect 0 "$SPH2D" render large --film large.gif -q
grep -qx 640x360 told || fail 'the image is wide'
expect 0 "$SPH2D" render large --film large.mp4 -q
grep -qx 1280x720 told || fail 'the film is small'
expect 0 "$SPH2D" render folder/snapshot_000003.h5 --film lone.mp4 && says '1 frame, 25 a second;'
expect 65 "$SPH2D" render folder/snapshot_00000[3].h5 folder/snapshot_000002.h5 --film back.mp4 && says 'no pace' && says -- '--fps'
expect 0 "$SPH2D" render folder/snapshot_000003.h5 folder/snapshot_000002.h5 --film back.mp4 --fps 2

# Nothing is replaced unless that is wanted, and by nothing but a film.
echo old >old.mp4 && mkdir folder.mp4
expect 73 "$SPH2D" render folder --film old.mp4 && says F207 && grep -qx old old.mp4
expect 73 "$SPH2D" render folder --film folder.mp4 -f && says 'not a regular file'
expect 73 "$SPH2D" render folder --film none/x.mp4 && says "cannot create 'none/x.mp4'"
stand_in 'cat >/dev/null; echo first >&2; echo the reason >&2; echo "Conversion failed!" >&2; exit 1'
expect 74 "$SPH2D" render folder --film old.mp4 -f && says "F206.: ffmpeg cannot make 'old.mp4': the reason\$"
stand_in 'cat >/dev/null; echo no room >&2'
expect 74 "$SPH2D" render folder --film old.mp4 -f && says "ffmpeg cannot make 'old.mp4': no room\$"
# It ends before it has read anything, or is ended.
stand_in 'echo no such codec >&2; exit 3'
expect 74 "$SPH2D" render folder --film old.mp4 -f -j 2 --size 640x480 && says 'old.mp4.: no such codec$'
stand_in 'kill -KILL $$'
expect 74 "$SPH2D" render folder --film old.mp4 -f --size 640x480 && says 'signal 9 ended it'
stand_in 'exit 1'
expect 74 "$SPH2D" render folder --film old.mp4 -f --size 640x480 && says 'it does not say why'
cp folder/snapshot_000000.h5 first.h5 && echo torn >torn.h5
stand_in 'cat >/dev/null'
expect 65 "$SPH2D" render first.h5 torn.h5 folder --film old.mp4 -f -j 2 --fps 5 && says torn.h5
grep -qx old old.mp4 || fail 'a film that failed has replaced one'
no_leftovers

# Stopped by a signal: no film. Killed: a temporary file at most, for ffmpeg to write to.
# shellcheck disable=SC2016
stand_in 'for last; do :; done; head -c 100000 >"${last#file:}"; : >begun; sleep 1; cat >/dev/null'
for number in INT:130 TERM:143 KILL:137; do
    rm -f begun
    env --default-signal=INT,TERM,HUP "$SPH2D" render folder folder folder folder --film stopped.mp4 --fps 5 -j 2 \
        --size 640x480 --progress never >out 2>err &
    pid=$!
    await test -e begun
    kill -"${number%:*}" $pid
    code=0
    wait $pid || code=$?
    [ $code = "${number#*:}" ] || fail "SIG$number: ended with $code"
    absent stopped.mp4
    [ "${number%:*}" = KILL ] || { says 'stopped by SIG.* of 44 frames' && no_leftovers; }
done
rm -f .stopped.mp4.tmp.*

# ffmpeg itself.
PATH=$real
command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null || exit 77
# about FILE: codec, width, height, frames a second, their number.
about() {
    ffprobe -v error -count_frames -show_entries stream=codec_name,width,height,r_frame_rate,nb_read_frames -of csv=p=0 "$1"
}
for name in a.mp4:h264,96,62,25/1,11 a.gif:gif,97,63,25/1,11 a.apng:apng,97,63,25/1,11; do
    expect 0 "$SPH2D" render folder --film "${name%:*}" --size 97x63
    [ "$(about "${name%:*}")" = "${name#*:}" ] || fail "${name%:*} is $(about "${name%:*}")"
done
expect 0 "$SPH2D" render folder --film 'http:a b.mp4' -q && present 'http:a b.mp4'
expect 0 "$SPH2D" render folder --film -q.gif --fps 100 -q
[ "$(about ./-q.gif | cut -d, -f 4)" = 25/1 ] || fail 'more than 25 frames a second'
# The first frame of an animated image is that of the PNG file, but for the nearest of 128 colours.
expect 0 "$SPH2D" render folder --film points.png --style points -q
expect 0 "$SPH2D" render folder -o points --style points -q
for file in points.png points/frame_000000.png; do
    ffmpeg -v error -i $file -frames:v 1 -pix_fmt rgb24 -f rawvideo "$(basename $file).bytes"
done
[ "$(wc -c <points.png.bytes)" = $((3 * 96 * 64)) ] || fail "no frame in an animated PNG"
cmp -l points.png.bytes frame_000000.png.bytes | awk '
    function value(octal) { return 64 * int(octal / 100) + 8 * (int(octal / 10) % 10) + octal % 10 }
    { d = value($2) - value($3); d = d < 0 ? -d : d; sum += d; most = d > most ? d : most }
    END { if (most > 40 || sum > 0.5 * 3 * 96 * 64) { print most, sum; exit 1 } }' >&2 ||
    fail 'another picture in an animated PNG'
# The last bytes find no room.
for name in gif apng mp4; do
    code=0
    (ulimit -f 4 && exec "$SPH2D" render folder --film full.$name --size 640x480 -q) 2>err || code=$?
    [ $code = 74 ] || fail "no room for a .$name: ended with $code"
    says "ffmpeg cannot make 'full.$name': .*File too large" && absent full.$name && no_leftovers
done

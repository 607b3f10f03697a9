#!/usr/bin/env bash
# Nowhere to write: 74, with a sentence, and what was written before is whole.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# into_full ARGUMENTS...: standard output is a device that is always full.
into_full() {
    code=0
    "$SPH2D" "$@" >/dev/full 2>err || code=$?
    [ $code = 74 ] || fail "sph2d $* into /dev/full ended with $code"
    says 'standard output: No space left'
}
into_full --version
into_full --help
into_full help exit
into_full check "$TINY"
into_full check "$TINY" --json
into_full run "$TINY" -o folder --no-frames -s spacing=0.02
into_full info folder/snapshot_000000.h5
# closed is no better than full
code=0
"$SPH2D" --version >&- 2>err || code=$?
[ $code = 74 ] || fail "a closed stdout ended with $code"
code=0
"$SPH2D" run "$TINY" -o closed --no-frames --quiet -s spacing=0.02 >&- 2>&- <&- || code=$?
[ $code = 0 ] || fail "nothing to say and nowhere to say it ended with $code"
same folder closed

# A limit on the size of files stands in for a full disk: it holds the first snapshots, and a source makes later ones
# larger. The unit is 1024 bytes.
small=$(wc -c <folder/snapshot_000002.h5)
large=$(wc -c <folder/snapshot_000010.h5)
[ "$large" -gt $((small + 4096)) ] || fail 'snapshots do not grow'
code=0
(
    ulimit -f $(((small + large) / 2048))
    exec "$SPH2D" run "$TINY" -o full --no-frames -q -s spacing=0.02
) 2>err || code=$?
[ $code = 74 ] || fail "a full disk ended with $code"
says 'F206.*full/' && says 'hint: make room there'
present full/snapshot_000002.h5
[ "$(find full -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left'
for snapshot in full/*.h5; do
    expect 0 "$SPH2D" info "$snapshot"
done
# With room again it goes on.
expect 0 "$SPH2D" resume full -q --no-frames && same folder full

# The same on a small disk, where that can be mounted.
mkdir disk
if mount -t tmpfs -o size=$(((2 * small + large) / 1024))k none disk 2>err; then
    trap 'umount disk 2>/dev/null || true' EXIT
    expect 74 "$SPH2D" run "$TINY" -o disk/run --no-frames --progress never -s spacing=0.02
    says 'F206.*No space left' && says "'sph2d resume disk/run' continues"
    [ "$(find disk/run -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left on a full disk'
    for snapshot in disk/run/*.h5; do
        expect 0 "$SPH2D" info "$snapshot"
    done
    cp -r disk/run moved
    umount disk
    expect 0 "$SPH2D" resume moved -q --no-frames && same folder moved
fi

# A folder that goes away in the middle: the run ends and says so.
"$SPH2D" run "$TINY" -o gone --no-frames -q -s spacing=0.02 -s run.until=1000 2>err &
pid=$!
await test -e gone/snapshot_000001.h5
mv gone went
code=0
wait $pid || code=$?
[ $code = 73 ] || [ $code = 74 ] || fail "a folder that went away: ended with $code"
says "F206.*'gone/" && says 'hint: its folder may have been removed'
expect 0 "$SPH2D" resume went -q --no-frames -s run.until=0.4 && silent

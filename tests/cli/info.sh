#!/bin/sh
# What info tells of snapshots, and of files that are none.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" run "$TINY" -o folder --no-frames -q
expect 0 "$SPH2D" info folder/snapshot_000010.h5 && silent
for row in file scene 'written by' time domain spacing fluid wall outline run; do
    prints "^$row"
done
prints '^scene *tiny' && prints 'Coordinates *f64 .* m ' && prints 'Pressures .* Pa ' && prints 'ParticleIDs *u64'
expect 0 "$SPH2D" info folder/snapshot_00000[12].h5 --json && lines 2 && prints '"scene": "tiny"'
if command -v python3 >/dev/null; then
    python3 - <<'END' || fail 'not JSON, or not what it should be'
import json
for line in open("out"):
    snapshot = json.loads(line)
    fields = {(a["group"], a["name"]): a for a in snapshot["arrays"]}
    assert fields["fluid", "Coordinates"]["components"] == 2
    assert fields["fluid", "Coordinates"]["range"][0][0] >= 0
    assert fields["fluid", "Velocities"]["unit"] == "m/s"
    assert fields["wall", "Coordinates"]["count"] > 0
    assert fields["outline", "WallIDs"]["count"] == fields["outline", "Coordinates"]["count"] > 0
    assert {group for group, _ in fields} == {"fluid", "wall", "outline", "run"}
    assert snapshot["steps"] > 0 and snapshot["domain"]["max"] == [1, 1]
END
fi

expect 66 "$SPH2D" info missing.h5 && says F201
expect 66 "$SPH2D" info / && says F201
expect 65 "$SPH2D" info "$TINY" && says F202
: >empty.h5
expect 65 "$SPH2D" info empty.h5
for size in 100 800 3000 8000; do
    head -c $size folder/snapshot_000001.h5 >cut.h5
    expect 65 "$SPH2D" info cut.h5 && says 'cut.h5' && empty
done
# One bad file does not hide the others.
expect 65 "$SPH2D" info cut.h5 folder/snapshot_000001.h5 && prints '^scene *tiny'

# A file without its checksum is read when that is asked for, and the command says so.
head -c -16 folder/snapshot_000001.h5 >bare.h5
expect 65 "$SPH2D" info bare.h5 && says F203 && says '--no-checksum' && empty
expect 0 "$SPH2D" info bare.h5 --no-checksum && prints '^scene *tiny' && says 'checksums .* not checked'
expect 0 "$SPH2D" info bare.h5 --no-checksum --quiet && silent
cp -r folder altered && rm altered/*.h5
head -c -16 folder/snapshot_000009.h5 >altered/snapshot_000009.h5
expect 66 "$SPH2D" resume altered && says 'checksum .* is missing' && says 'no complete snapshot'
expect 0 "$SPH2D" resume altered --no-checksum --no-frames && says 'checksums .* not checked'
same altered/snapshot_000010.h5 folder/snapshot_000010.h5
if can_draw; then
    expect 65 "$SPH2D" render bare.h5 -o drawn && absent drawn
    expect 0 "$SPH2D" render bare.h5 -o drawn --no-checksum && present drawn/frame_000000.png
fi

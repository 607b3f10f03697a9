#!/bin/sh
# The output folder: refused when it is not ours to take, and only files of our own are ever removed.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
set -- run "$TINY" --no-frames --progress never -s run.until=0.12

mkdir empty
expect 0 "$SPH2D" "$@" -o empty && present empty/snapshot_000000.h5
expect 0 "$SPH2D" "$@" -o new/with/parents/ && same empty new/with/parents
expect 73 "$SPH2D" "$@" -o empty && says 'F207.*empty' && says '--force' && same empty new/with/parents
echo x >file
expect 73 "$SPH2D" "$@" -o file
expect 73 "$SPH2D" "$@" -o file/below
expect 73 "$SPH2D" "$@" -o ''
expect 73 "$SPH2D" "$@" -o /proc/sph2d
expect 73 "$SPH2D" "$@" -o file --force && [ "$(cat file)" = x ]
if [ "$(id -u)" != 0 ]; then
    mkdir locked && chmod 555 locked
    expect 73 "$SPH2D" "$@" -o locked
    expect 73 "$SPH2D" "$@" -o locked/below
fi

# --force
mkdir empty/frames empty/other
touch empty/snapshot_000099.h5 empty/checkpoint.h5 empty/guard.h5 empty/frames/frame_000099.png \
    empty/.snapshot_000001.h5.tmp.77
for mine in snapshot.h5 snapshot_1.h5 snapshot_000001.h5.bak results.csv frames/mine.png other/snapshot_000000.h5 .hidden \
    .notes.tmp.x; do
    echo mine >"empty/$mine"
done
expect 0 "$SPH2D" "$@" -o empty --force && says 'removed 1 unfinished file'
absent empty/snapshot_000099.h5
absent empty/checkpoint.h5
absent empty/guard.h5
absent empty/frames/frame_000099.png
absent empty/.snapshot_000001.h5.tmp.77
for mine in snapshot.h5 snapshot_1.h5 snapshot_000001.h5.bak results.csv frames/mine.png other/snapshot_000000.h5 .hidden \
    .notes.tmp.x; do
    [ "$(cat "empty/$mine")" = mine ] || fail "$mine is gone"
    rm "empty/$mine"
done
rmdir empty/frames empty/other
same empty new/with/parents

# A folder that is no run, for resume.
mkdir nothing
expect 66 "$SPH2D" resume nothing && says 'no complete snapshot'
expect 66 "$SPH2D" resume missing && says 'F201'
expect 66 "$SPH2D" resume file
echo 'not HDF5' >nothing/snapshot_000000.h5
expect 66 "$SPH2D" resume nothing && says 'F202' && says 'is skipped'

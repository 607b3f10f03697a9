#!/usr/bin/env bash
# Every allocation, write, sync, rename, thread and folder of the commands fails once:
#     faults.sh SPH2D SHIM LIBRARY FOLDER JOBS [CASE...]
#
# The calls of each kind are counted first (shim.c); then each of them fails alone, and all from it on (one.sh has what
# must hold). Allocations go into the ten thousands: of them one in a stride fails, unless FULL=1. FEW=N tries N calls of
# each kind, for a quick look.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
SPH2D=$(realpath -e "$1") SHIM=$(realpath -e "$2") LIBRARY=$(realpath -e "$3")
folder=$4 jobs=$5
shift 5
rm -rf "$folder" && mkdir -p "$folder"
folder=$(realpath -e "$folder")
REFERENCE=$folder/reference CODES=$folder/codes
export SPH2D SHIM LIBRARY REFERENCE CODES LC_ALL=C
export OMP_WAIT_POLICY=passive
ulimit -c 0
mkdir "$REFERENCE" && : >"$CODES"
cd "$here"

cases=(library run run_over resume check info info_run plot export export_series init study shard)
! "$SPH2D" --version | grep -q '^rendering.*\(osmesa\|egl\)' || cases+=(run_frames render preview)
[ $# = 0 ] || cases=("$@")

# What the commands give without faults.
"$SPH2D" run scene.yaml -q -j 1 --no-frames -o "$REFERENCE/run"
"$SPH2D" info "$REFERENCE/run/snapshot_000001.h5" >"$REFERENCE/info.txt"
"$SPH2D" info "$REFERENCE/run" >"$REFERENCE/info_run.txt"
mkdir "$REFERENCE/export"
"$SPH2D" export "$REFERENCE/run/snapshot_000001.h5" -q -o "$REFERENCE/export/particles.csv"
mkdir "$REFERENCE/export_series"
"$SPH2D" export "$REFERENCE/run" -q -o "$REFERENCE/export_series/flow.pvd"
(cd "$REFERENCE" && "$SPH2D" init out -q --template drop && mv out init) # the scene names its own path
(cd "$folder" && "$LIBRARY") >"$REFERENCE/library.txt"
case " ${cases[*]} " in *' run_frames '* | *' render '*)
    "$SPH2D" run scene.yaml -q -j 1 -o "$REFERENCE/run_frames"
    "$SPH2D" render "$REFERENCE/run/snapshot_000001.h5" -q -j 1 -o "$REFERENCE/render" ;;
esac
case " ${cases[*]} " in *' preview '*)
    mkdir "$REFERENCE/preview"
    "$SPH2D" check scene.yaml -q -j 1 --preview "$REFERENCE/preview/first.png" ;;
esac

# calls CASE KIND: how many there are, in the process that has most.
calls() {
    awk -v kind="$2" '$1 == kind && $2 > most { most = $2 } END { print most + 0 }' "$folder/calls.$1"
}

# stride CASE: one in how many allocations fails. Mesa's compiler of shaders has most, and takes longest.
stride() {
    if [ -n "${FULL:-}" ]; then
        echo 1
    else
        case $1 in library | init | plot) echo 1 ;; run_frames | render | preview) echo 997 ;; check | info | info_run | export | export_series | study | shard) echo 7 ;; run_over) echo 199 ;; *) echo 23 ;; esac
    fi
}

for case in "${cases[@]}"; do
    FAULTS_COUNT=$folder/calls.$case ./one.sh "$case" none:0 >&2
    for kind in alloc write truncate sync rename open mkdir thread; do
        count=$(calls "$case" $kind) step=1
        [ $kind != alloc ] || step=$(stride "$case")
        # Mesa waits for ever for a thread that fails after the command has seen that all can be started: two, and four.
        [ "$case/$kind" != run_frames/thread ] || count=6
        [ "$kind" != write ] || [ -n "${FULL:-}" ] || [ "$count" -lt 100 ] || step=7
        [ -z "${FEW:-}" ] || step=$((count / FEW + 1))
        for ((k = 1; k <= count; k += step)); do
            echo "$case $kind:$k"
            # One that fails for good fails first at the same call; of allocations fewer are tried so.
            if [ $kind != alloc ] || ((k / step % 5 == 0)); then echo "$case $kind:$k+"; fi
        done
    done
done >"$folder/faults"

total=$(wc -l <"$folder/faults")
echo "$total faults in ${cases[*]}"
xargs -P "$jobs" -n 2 ./one.sh <"$folder/faults" >"$folder/wrong"
sort "$CODES" | uniq -c | awk '{ printf "  %-12s %-9s ended with %3d: %6d times\n", $2, $3, $4, $1 }'
if [ -s "$folder/wrong" ]; then
    head -n 40 "$folder/wrong"
    echo "faults: $(wc -l <"$folder/wrong") of $total have a wrong end ($folder/wrong)" >&2
    exit 1
fi
echo "faults: ok"

#!/usr/bin/env bash
# Runs the harnesses with the files of the corpus and inputs made from them:
#
#     fuzz.sh SPH2D HARNESSES OUT [OPTIONS...]
#
# HARNESSES is the folder of the programs, OUT gets what they find; the options are those of the driver. Without any it
# takes two seconds for each harness, with the same inputs every time; with some it takes the scenes, studies and tables
# of the repository, too. Snapshots to begin with are written by the command.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
sph2d=$(realpath -e "$1") harnesses=$(realpath -e "$2")
rm -rf "$3" && mkdir -p "$3" && out=$(realpath -e "$3")
shift 3
cd "$root"

seed() { # seed NAME SCENE OPTIONS...: one snapshot
    local name=$1 scene=$2
    shift 2
    "$sph2d" run "$scene" -o "$out/seed" --force --no-frames --quiet -s 'run.snapshots={every: 0.01}' "$@"
    cp "$out/seed/snapshot_000001.h5" "$out/$name.h5"
}
scenes=tests/fuzz/corpus/scene
seed plain $scenes/everything.yaml -s run.until=0.01
seed bodies $scenes/bodies.yaml -s run.until=0.01
seed packed $scenes/fitted.yaml -s run.until=0.01 -s 'run.snapshots={every: 0.01, compress: 6}'

# A sanitizer's own memory has no bound, what is asked for at once has one.
export ASAN_OPTIONS=max_allocation_size_mb=1024:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions=$root/tests/fuzz/leaks.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1

# Inputs of about two seconds.
declare -A few=([scene]=2000 [study]=10000 [particles]=5000 [table]=2000 [reference]=5000 [drawing]=5000 [snapshot]=400)
status=0
for name in scene study particles table reference drawing snapshot; do
    files=()
    case $name in
    snapshot) files=("$out"/*.h5) ;;
    *) files=(tests/fuzz/corpus/"$name"/*) ;;
    esac
    options=("$@")
    if [ $# = 0 ]; then
        options=(--inputs "${few[$name]}" --seed 3 --limit 10)
    else
        case $name in
        scene) files+=(examples/*/scene.yaml tests/strangers/scenes/* tests/hard/*/scene.yaml tests/cli/tiny.scene) ;;
        study) files+=(examples/*/study*.yaml tests/hard/*/study.yaml) ;;
        reference) files+=(examples/*/*.csv) ;;
        drawing) files+=(examples/*/*.svg tests/restarts/scenes/*.svg) ;;
        esac
    fi
    mkdir "$out/$name"
    "$harnesses/$name" --dir "$out/$name" "${options[@]}" "${files[@]}" || status=1
done
exit $status

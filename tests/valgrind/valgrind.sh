#!/usr/bin/env bash
# Is memory read that nobody wrote, or lost? valgrind.sh SPH2D CHECK_ALL FOLDER JOBS [NAME...]
#
# Runs most suites and the command under memcheck: uninitialised values, which AddressSanitizer does not see, invalid
# accesses and leaks. Left out are suites that compute for long, whose loops the others enter, too, those that limit the
# processor's time or all memory, and drawing, as Mesa compiles shaders that memcheck cannot judge. The loops are those
# of AVX2: valgrind knows no AVX-512. `suppressions` says what is not ours.
# NAME: only these, suite_cells or run_wcsph.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sph2d=$(realpath "$1") checks=$(realpath "$2") folder=$3 jobs=$4
command -v valgrind >/dev/null || { echo 'test-valgrind: this needs valgrind (Debian: valgrind, libc6-dbg)' >&2 && exit 2; }
rm -rf "$folder" && mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

only=" ${*:5} "
export here folder only
# go NAME COMMAND...: a line where it does not end with 0.
go() {
    local name=$1 code=0
    shift
    [[ $only = '  ' || $only = *" $name "* ]] || return 0
    "$here/../limit.sh" 2700 valgrind --quiet --error-exitcode=66 --leak-check=full --show-leak-kinds=definite \
        --errors-for-leak-kinds=definite --num-callers=20 --suppressions="$here/suppressions" \
        "$@" >"$folder/$name.log" 2>&1 </dev/null || code=$?
    [ $code = 0 ] || { echo "$name $code" >>"$folder/failed" && grep -m 20 '^==\|:[EF]:' "$folder/$name.log"; }
}
export -f go

# Computes for long, or sets limits, or draws.
left_out='flows|muller_energy|periodic|rest|impacts|solver_limits|features|walls|scene_text|packing|packing_rest|extremes|settings|outputs'
# pocl's compiler, and what that makes, are not ours.
left_out+='|device'
left_out+='|sample|probes|elevation|render|drawing|shapes|balls|frame_times|null_render'
# shellcheck disable=SC2016 # the inner shell expands it
{
    "$checks" --list | grep -vxE "$left_out" | while read -r suite; do
        # The tests of a suite are one process, so that not each is searched for leaks, unless they need their own.
        case $suite in scene_file|series|study|study_results) fork=yes ;; *) fork=no ;; esac
        printf '%s\0' "CK_FORK=$fork go suite_$suite '$checks' $suite"
    done
    run="'$sph2d' run '$here/../cli/tiny.scene' --force --no-frames --quiet --threads 2 -s run.until=0.05"
    for method in muller wcsph pcisph constraint hybrid; do
        printf '%s\0' "go run_$method $run -s method.name=$method -s fluid.surface_tension=0.1 -o '$folder/$method'"
    done
    printf '%s\0' "go run_fitted '$sph2d' run '$here/../../examples/taylor_green/scene.yaml' --force --no-frames --quiet \
        -s spacing=0.05 -s method.operators=fitted -s run.until=0.02 -o '$folder/fitted'"
    printf '%s\0' "go check '$sph2d' check '$here/../cli/tiny.scene' --json"
    printf '%s\0' "go help '$sph2d' help scene"
} | xargs -0 -n 1 -P "$jobs" bash -c 'eval "$1" || true' bash
ran=$(find "$folder" -maxdepth 1 -name '*.log' | wc -l)
[ ! -e "$folder/failed" ] || {
    echo "valgrind: $(wc -l <"$folder/failed") of $ran end badly: $(cut -d ' ' -f 1 "$folder/failed" | tr '\n' ' ')" >&2 && exit 1
}
echo "valgrind: $ran runs, no error, no leak"

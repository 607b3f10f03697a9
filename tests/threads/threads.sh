#!/usr/bin/env bash
# Do threads touch the same memory at once? threads.sh SPH2D CHECK_ALL FOLDER [ONLY], built by clang's ThreadSanitizer
#
# Runs the suites that start threads, and the command: a scene by every method with 2 and 4 threads, a study with
# workers, drawing side by side. gcc's OpenMP cannot be used, since its barriers are not seen and all it shares looks
# like a race; those of libomp are told by its tool archer. `threads.sh --needs CC` says in a sentence what is missing.
# ONLY: `suites` or `command`.
set -euo pipefail

archer_of() {
    local folder
    for folder in "$(dirname "$("$1" -print-file-name=libarcher.so)")" "$(dirname "$("$1" -print-runtime-dir)")"/../../.. \
        "$(dirname "$("$1" -print-prog-name=lld)")"/../lib /usr/lib/llvm-*/lib; do
        if [ -e "$folder/libarcher.so" ]; then realpath "$folder/libarcher.so" && return; fi
    done
    return 1
}

needs() {
    local lacks=''
    if ! command -v "$1" >/dev/null; then
        lacks="the compiler $1 (Debian: clang)"
    elif ! "$1" --version | grep -q clang; then
        lacks="clang: $1 is another compiler"
    elif ! echo 'int main(void) { return 0; }' | "$1" -fsanitize=thread -x c - -o /dev/null 2>/dev/null; then
        lacks="clang's ThreadSanitizer (Debian: libclang-rt-*-dev)"
    elif ! echo '#include <omp.h>' | "$1" -fopenmp -E - >/dev/null 2>&1 || ! archer_of "$1" >/dev/null; then
        lacks='libomp with its tool libarcher.so (Debian: libomp-dev)'
    fi
    [ -z "$lacks" ] || { echo "test-threads: this needs $lacks" >&2 && exit 2; }
}

if [ "$1" = --needs ]; then
    needs "$2"
    exit
fi

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sph2d=$(realpath "$1") checks=$(realpath "$2") folder=$3 only=${4-}
rm -rf "$folder" && mkdir -p "$folder"
OMP_TOOL_LIBRARIES=$(archer_of "${CC:-clang}")
export OMP_TOOL_LIBRARIES
# Mesa and HDF5 are not compiled for it: their locks are seen, what they do to memory is not. Mesa's own locks therefore
# order what two threads do before and after they draw, and may hide a race there.
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=0 exitcode=66"
export CK_TIMEOUT_MULTIPLIER=10 LP_NUM_THREADS=0
failed=0 done=0

# go NAME COMMAND...: it ends with 0 and tells no race.
go() {
    local name=$1 code=0
    shift
    "$here/../limit.sh" 600 "$@" >"$folder/$name.log" 2>&1 </dev/null || code=$?
    done=$((done + 1))
    if [ $code != 0 ] || grep -q 'WARNING: ThreadSanitizer' "$folder/$name.log"; then
        failed=$((failed + 1))
        echo "threads: $name ends with $code; $folder/$name.log begins with"
        grep -A 12 'WARNING: ThreadSanitizer' "$folder/$name.log" | head -n 30 || tail -n 5 "$folder/$name.log"
    fi
}

# Archer breaks down in forked processes: their threads are tested without it, by the suite `parallel` of `make test`.
suites=(parallel store cells invariance muller variational fitted fitted_walls friction projection reported_pressure solvers
    packing_rest probes gauge plan state symmetry tension drawing memory)
if [ "$only" != command ]; then
    known=$("$checks" --list)
    for suite in "${suites[@]}"; do
        case=
        [ "$suite" != parallel ] || case=threads
        ! grep -qx "$suite" <<<"$known" || go "suite_$suite" env ${case:+CK_RUN_CASE=$case} "$checks" "$suite"
    done
fi

# Methods, and keys that change what they do.
methods=('hybrid' 'muller' 'muller walls=reflect' 'wcsph' 'wcsph wall_slip=smooth'
    'pcisph' 'pcisph method.time_step=5e-4' 'constraint' 'constraint method.artificial_viscosity=0')
if [ "$only" != suites ]; then
    for method in "${methods[@]}"; do
        read -ra words <<<"$method"
        options=(-s "method.name=${words[0]}")
        for word in "${words[@]:1}"; do options+=(-s "$word"); done
        for threads in 2 4; do
            name=run_${method//[ =.]/_}_$threads
            go "$name" "$sph2d" run "$here/scene.yaml" "${options[@]}" -j $threads -o "$folder/run" -f -q
        done
    done
    for threads in 2 4; do
        go "render_$threads" "$sph2d" render "$folder/run"/snapshot_*.h5 -o "$folder/pictures" -f -q -j $threads
    done
    for threads in 2 4; do
        go "run_fitted_$threads" "$sph2d" run "$here/../../examples/taylor_green/scene.yaml" \
            -s method.operators=fitted -s run.until=0.02 -j $threads -o "$folder/run" -f -q --no-frames
    done
fi
[ $failed = 0 ] || { echo "threads: $failed of $done end badly" >&2 && exit 1; }
echo "threads: $done runs, no race"

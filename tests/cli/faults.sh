#!/bin/sh
# A few of the calls that may fail, each kind in each command; `make test-faults` tries them all.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
: "${SPH2D_FAULTS:=$SPH2D_ROOT/build/tests}"
[ -e "$SPH2D_FAULTS/faults_shim.so" ] || exit 77
[ -e "$SPH2D_FAULTS/faults_library" ] || exit 77

# Where the library does not work, as in a build with sanitizers, it counts nothing.
LD_PRELOAD=$SPH2D_FAULTS/faults_shim.so FAULTS_COUNT=count "$SPH2D" --version >out 2>err || true
[ -s count ] || exit 77

FEW=2 "$SPH2D_ROOT/tests/faults/faults.sh" "$SPH2D" "$SPH2D_FAULTS/faults_shim.so" "$SPH2D_FAULTS/faults_library" few 2 \
    library run resume check info study shard >out 2>err || fail 'a fault has a wrong end'

# broken_by SIGNAL OPTION...: a breakdown has a last sentence and an exit code.
broken_by() {
    signal=$1
    shift
    "$SPH2D" run "$TINY" -o "by_$signal" --no-frames -q -s run.until=1000 "$@" 2>err &
    pid=$!
    await test -e "by_$signal/snapshot_000001.h5"
    kill "-$signal" $pid
    code=0
    wait $pid || code=$?
    [ $code = 70 ] || fail "$signal: ended with $code"
    mv err said
    expect 0 "$SPH2D" info "by_$signal/snapshot_000001.h5"
}
broken_by SEGV
grep -q 'sph2d: error: the command broke down (SIGSEGV)' said || fail 'no last sentence'
grep -q "hint: .*'sph2d resume'" said || fail 'no word of how to go on'
broken_by ABRT --json
grep -q '^{"severity": "error", .*(SIGABRT).*}$' said || fail 'the last sentence is not JSON'

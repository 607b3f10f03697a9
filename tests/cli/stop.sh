#!/bin/sh
# Long: signals in the middle of a run: the first one finishes the step and writes a checkpoint, a kill leaves whole files, and
# in all cases resume comes to the same folder.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# Long enough to be caught in the middle; probes and a source make the state large.
set -- run "$TINY" -q --no-frames -j 1 -s spacing=0.01 -s run.until=1 -s run.snapshots.per_second=50
expect 0 "$SPH2D" "$@" -o whole

# interrupt SIGNAL: starts a run, sends the signal when the third snapshot is there, leaves how it ended in $code.
interrupt() {
    # A shell switches SIGINT off for what it runs in the background.
    env --default-signal=INT,TERM,HUP "$SPH2D" run "$TINY" -q --no-frames -j 1 -s spacing=0.01 -s run.until=1 \
        -s run.snapshots.per_second=50 -o "by_$1" 2>err &
    pid=$!
    await test -e "by_$1/snapshot_000003.h5"
    # By the name that pkill and top know, after the command has started itself again.
    [ ! -r /proc/$pid/comm ] || [ "$(cat /proc/$pid/comm)" = "$(basename "$SPH2D")" ] || fail 'the process has another name'
    kill -"$1" $pid 2>/dev/null || true
    code=0
    wait $pid || code=$?
}

# stopped SIGNAL CODE: the same, with that code. On a busy machine the run may be over before the signal: once more then.
stopped() {
    attempt=1
    interrupt "$1"
    while [ $code = 0 ] && [ $attempt -lt 5 ]; do
        attempt=$((attempt + 1))
        rm -r "by_$1"
        interrupt "$1"
    done
    [ $code = "$2" ] || fail "$1: ended with $code, not $2"
    absent "by_$1/snapshot_000050.h5"
}

for signal in INT TERM HUP; do
    case $signal in INT) code=130 ;; TERM) code=143 ;; HUP) code=129 ;; esac
    stopped $signal "$code"
    [ "$(find by_$signal -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left'
    if [ $signal = TERM ]; then
        # What is damaged is skipped for something older; a guard's file is never taken.
        rm -f by_TERM/checkpoint.h5
        newest=$(find by_TERM -name 'snapshot_*' | sort | tail -n 1)
        head -c 5000 "$newest" >short.h5 && mv short.h5 "$newest"
        echo 'not HDF5' >by_TERM/checkpoint.h5
        cp whole/snapshot_000050.h5 by_TERM/guard.h5
        expect 0 "$SPH2D" resume by_TERM --no-frames --progress never && says "$newest" && says 'is skipped'
    else
        expect 0 "$SPH2D" resume by_$signal -q --no-frames && silent
    fi
    same whole by_$signal
done

# Nobody is left at the terminal: a run that was told so goes on.
env --ignore-signal=HUP "$SPH2D" run "$TINY" -q --no-frames -j 1 -s run.snapshots.per_second=50 -s spacing=0.01 \
    -s run.until=0.1 -o hup 2>err &
pid=$!
await test -e hup/snapshot_000001.h5
kill -HUP $pid 2>/dev/null || true
wait $pid || fail "a signal that is ignored: ended with $?"

# Killed with files half written: what is left of them goes away, with a notice.
stopped KILL 137
: >by_KILL/.snapshot_000007.h5.tmp.12345
expect 0 "$SPH2D" resume by_KILL --no-frames -j 2 --progress never && says 'removed .* unfinished file'
same whole by_KILL

# The second signal does not wait.
env --default-signal=INT,TERM,HUP "$SPH2D" run "$TINY" -q --no-frames -j 1 -s spacing=0.004 -s run.until=1 -o twice 2>err &
pid=$!
sleep 1
kill -TERM $pid
kill -TERM $pid 2>/dev/null || true # it may be gone already
code=0
wait $pid || code=$?
[ $code = 143 ] || fail "two signals: ended with $code"

# Killed at its very end, when the last snapshot is there and the checkpoint before it has not gone: both are no news.
expect 75 "$SPH2D" run "$TINY" -q --no-frames -s run.until=0.2 -o end --max-wall 0.001s
cp end/checkpoint.h5 old.h5
expect 0 "$SPH2D" resume end -q --no-frames && cp -r end at_end
cp old.h5 end/checkpoint.h5
expect 0 "$SPH2D" resume end --no-frames && says 'is complete' && same at_end end

# A folder belongs to one session at a time.
if command -v flock >/dev/null; then
    expect 73 flock by_INT "$SPH2D" resume by_INT && says 'another sph2d'
fi

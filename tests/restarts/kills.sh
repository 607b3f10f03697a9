#!/usr/bin/env bash
# A run that is killed by SIGKILL at random moments: each file under its final name is whole, at any time, and resume
# comes to the folder of a run that was never killed.
#
# kills.sh SPH2D DIR KILLS [SEED]
# Snapshots and frames come so often that most of the time goes into writing. SCENE: another scene than tests/cli/tiny.scene.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
SPH2D=$(realpath -e "$1") wanted=$3
RANDOM=${4:-1}
rm -rf "$2" && mkdir -p "$2" && cd "$2"
unset LP_NUM_THREADS
export LC_ALL=C

scene=("${SCENE:-$here/../cli/tiny.scene}" -s run.until=0.1 -s run.snapshots.per_second=1000 -s run.frames.per_second=200)
draw=()
if "$SPH2D" --version | grep -q '^rendering *none'; then draw=(--no-frames); fi

fail() {
    printf 'FAIL: %s\n' "$*" >&2
    cat log >&2
    exit 1
}

# whole_files: all that came since the last look. A temporary file may be there, and its name says so.
whole_files() {
    local file new snapshots=()
    mapfile -t new < <(find parts -type f -newer seen ! -name '.*.tmp.*' | sort)
    touch next
    for file in "${new[@]}"; do
        case $file in
        *.h5) snapshots+=("$file") ;;
        *.csv)
            [ ! -s "$file" ] || [ -z "$(tail -c 1 "$file")" ] || fail "$file ends within a line"
            awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$file" || fail "$file has lines of different lengths"
            [ ! -s "$file" ] || [ "$(head -n 1 "$file")" = "$(head -n 1 "whole/${file#parts/}")" ] ||
                fail "$file has another header"
            ;;
        *.png) [ "$(tail -c 8 "$file" | od -An -tx1)" = ' 49 45 4e 44 ae 42 60 82' ] || fail "$file is cut off" ;;
        *) fail "nobody writes $file" ;;
        esac
        [ "$file" = parts/checkpoint.h5 ] || [ -e "whole/${file#parts/}" ] || fail "no run leaves $file"
    done
    looked=$((looked + ${#new[@]}))
    [ ${#snapshots[@]} = 0 ] || "$SPH2D" info "${snapshots[@]}" >description 2>log || fail 'a snapshot is torn'
    mv next seen
}

# session ARGUMENTS...: a part of a run, killed unless it ends before; its exit code is in $code.
session() {
    "$SPH2D" "$@" -q "${draw[@]}" >log 2>&1 &
    pid=$!
    sleep "$(awk "BEGIN { print 0.005 + 0.5 * $seconds * $RANDOM / 32768 }")"
    kill -KILL $pid 2>/dev/null || true
    code=0
    { wait $pid || code=$?; } 2>>log
}

begun=$EPOCHREALTIME
"$SPH2D" run "${scene[@]}" -o whole -q "${draw[@]}" >log 2>&1 || fail 'the run that nobody kills'
seconds=$(awk "BEGIN { print $EPOCHREALTIME - $begun }")
kills=0 runs=0 anew=0 looked=0
while [ $kills -lt "$wanted" ]; do
    rm -rf parts && mkdir parts && touch -d '2000-01-01' seen
    code=66
    while [ $code != 0 ]; do
        if [ -e parts/snapshot_000000.h5 ]; then
            session resume parts -j $((1 + RANDOM % 2))
        else # killed before there was anything to go on from
            session run "${scene[@]}" -o parts -j $((1 + RANDOM % 2)) -f
            anew=$((anew + 1))
        fi
        case $code in
        0) ;;
        137) kills=$((kills + 1)) ;;
        *) fail "a session ends with $code" ;;
        esac
        whole_files
    done
    runs=$((runs + 1))
    diff -r whole parts >log || fail 'the folder is another'
done
echo "kills: $kills in $runs runs, which began $anew times; $looked files looked at, all whole"

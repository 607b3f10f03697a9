#!/bin/sh
# Runs a command whose processes may use so many seconds of CPU time each; by the clock it may take ten times as long,
# for what waits for ever: limit.sh SECONDS COMMAND...
#
# Where that is not enough, the last line on stderr says so, and the exit code is 124. CK_TIMEOUT_MULTIPLIER makes both
# limits so many times as long.
seconds=$(($1 * ${CK_TIMEOUT_MULTIPLIER:-1}))
shift
code=0
# shellcheck disable=SC3045 # dash has it
(ulimit -S -t $seconds && exec timeout -k 10 $((10 * seconds)) "$@") || code=$?
case $code in
124) passed="$((10 * seconds)) s by the clock" ;;
137) passed="$((10 * seconds)) s by the clock, or it was killed" ;;
152) passed="$seconds s of CPU time" ;;
*) exit $code ;;
esac
echo "limit of $passed: $*; CK_TIMEOUT_MULTIPLIER=5 gives five times as much" >&2
exit 124

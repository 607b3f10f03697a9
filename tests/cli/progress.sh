#!/bin/sh
# Progress: a bar on a terminal, plain lines elsewhere; colours only where they are wanted.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
escape=$(printf '\033')
set -- run "$TINY" --no-frames

expect 0 "$SPH2D" "$@" -o lines
says '^sph2d:  50 %  .* left  t 0.2'
[ "$(grep -c ' left  t ' err)" -ge 9 ] || fail 'not a line each tenth of the way'
[ "$(grep -c ' left  t ' err)" -le 12 ] || fail 'too many lines'
grep -q "$escape" err && fail 'escape sequences in a file'
expect 0 "$SPH2D" "$@" -o never --progress never
grep -q ' left  t ' err && fail 'progress all the same'
expect 0 "$SPH2D" "$@" -o json --json
number='-\{0,1\}[0-9][0-9.e+-]*'
says "^{\"severity\": \"progress\", \"ratio\": 0.5[0-9]*, \"elapsed_seconds\": $number, \"remaining_seconds\": $number, \
\"time\": 0.2[0-9]*, \"until\": 0.4, \"steps\": [0-9]*, \"particles\": [0-9]*}$"
[ "$(grep -c '"severity": "progress"' err)" -ge 9 ] || fail 'not an object each tenth of the way'
grep -q ' left  t ' err && fail 'a text in place of numbers'
expect 0 "$SPH2D" "$@" -o quiet --json --quiet && silent
expect 0 "$SPH2D" "$@" -o forced --json --progress always && says '"severity": "progress", "ratio": 1, '
if can_draw; then
    expect 0 "$SPH2D" render json -o drawn --json --size 64x64
    says '"severity": "progress", .*, "frames_drawn": 11, "frames": 11}'
fi
expect 0 "$SPH2D" "$@" -o always --progress always -s run.until=4 && says '\[=*>* *\] .* left'

script -qec true /dev/null >/dev/null 2>&1 </dev/null || exit 77 # no such command, or no pseudo-terminals here
# in_terminal FILE COMMAND: what the command prints in a pseudo-terminal.
in_terminal() {
    script -qec "$2" /dev/null >"$1" </dev/null || fail "$2"
}
export TERM=xterm
# Long enough for a bar, which appears after a tenth of a second.
quoted="'$SPH2D' run '$TINY' --no-frames -s run.until=2"
in_terminal bar "$quoted -o bar_folder"
grep -q "$escape\[K\[=*>" bar || fail 'no bar on a terminal'
grep -q ' %  .* left  t ' bar || fail 'no time left'
TERM=dumb
in_terminal dumb "$quoted -o dumb_folder"
grep -q "$escape" dumb && fail 'escape sequences on a dumb terminal'
grep -q 'sph2d:  50 %' dumb || fail 'no lines on a dumb terminal'
TERM=xterm
for way in colour NO_COLOR no-color; do
    case $way in
    NO_COLOR) command="NO_COLOR=1 '$SPH2D' check missing" ;;
    no-color) command="'$SPH2D' check --no-color missing" ;;
    *) command="'$SPH2D' check missing" ;;
    esac
    script -qec "$command" /dev/null >$way.out </dev/null || true
    grep -q 'error\[F201\]' $way.out || fail "$way: no message"
    if grep -q "$escape\[1;31m" $way.out; then [ $way = colour ]; else [ $way != colour ]; fi || fail "$way"
done

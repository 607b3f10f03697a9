#!/bin/bash
# A scene from the standard input: the same run as from its file, messages with its place, and whatever else may come
# through there.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# given FILE CODE COMMAND...: as expect, with the file as the standard input; it may be a folder or a device.
given() {
    input=$1 wanted=$2 code=0
    shift 2
    "$@" <"$input" >out 2>err || code=$?
    [ "$code" = "$wanted" ] || fail "$* <$input ended with $code, not $wanted"
}

# Through a pipe, in pieces, and from a file that stands at its end already.
expect 0 "$SPH2D" run "$TINY" -o named --no-frames -q
for threads in 1 2; do
    code=0
    { head -c 100 "$TINY" && sleep 0.2 && tail -c +101 "$TINY"; } |
        "$SPH2D" run - -o piped --no-frames -q -f -j $threads >out 2>err || code=$?
    [ $code = 0 ] || fail "a piped scene ended with $code"
    silent && same named piped
done
given "$TINY" 0 "$SPH2D" check - && prints '^scene *tiny: no errors' && silent
given "$TINY" 0 "$SPH2D" run - --dry-run --set spacing=0.1 && prints '^particles  *24 '
# shellcheck disable=SC2016 # the inner shell expands it
expect 65 bash -c 'exec 3<"$TINY"; cat <&3 >/dev/null; "$SPH2D" check - <&3' && says '^<stdin>: error\[S100\].*it is empty'

# Its snapshots have it, so that a run goes on without it.
rm -rf piped && given "$TINY" 0 "$SPH2D" run - -o piped --no-frames -q --set run.until=0.2
expect 0 "$SPH2D" resume piped --no-frames -q --set run.until=0.4

# Messages have its place; with --json, too.
printf 'domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nspacign: 2\n' >wrong.yaml
for command in 'check -' 'run - -o none'; do
    # shellcheck disable=SC2086
    given wrong.yaml 65 "$SPH2D" $command && says "^<stdin>:3:1: error\[S101\].*spacign" && empty
done
given wrong.yaml 65 "$SPH2D" check - --json && says '"file": "<stdin>", "line": 3, "column": 1' && absent none
given "$TINY" 65 "$SPH2D" check - --set spacing=-1 && says '^--set spacing=-1: error\[S104\]'

# Paths in it are relative to the current folder.
mkdir -p here/tables && printf 't,y\n0,0\n1,0.1\n' >here/tables/lift.csv && printf 'x,y\n0.1,0.1\n' >here/points.csv
cat >here/files.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
particles: points.csv
method: {sound_speed: 10}
obstacles: [{box: {min: [0.5, 0.2], max: [0.8, 0.5]}, motion: {file: tables/lift.csv}}]
END
(cd here && given files.yaml 0 "$SPH2D" check - && given files.yaml 0 "$SPH2D" run - -o ran -q) || fail 'files beside it'
given here/files.yaml 66 "$SPH2D" check - && says '^<stdin>:5:70:.*error\[F201\].*lift.csv'

# Without -o the folder has the name of the scene, when that can be one's.
given "$TINY" 0 "$SPH2D" run - --no-frames && says "outputs go to the folder 'tiny'" && same named tiny
given "$TINY" 73 "$SPH2D" run - --no-frames && says "'tiny' exists" && says 'another with -o'
expect 0 "$SPH2D" run "$TINY" --no-frames --force -q && silent && same named tiny
sed 's/^name: .*/name: a title/' "$TINY" | given /dev/stdin 0 "$SPH2D" run - --no-frames -q && present 'a title'
sed '/^name: /d' "$TINY" | given /dev/stdin 64 "$SPH2D" run - --no-frames && says '-o DIR; the scene has no .name.'
for name in ../up a/b .hidden -q ''; do
    sed "s|^name: .*|name: '$name'|" "$TINY" | given /dev/stdin 64 "$SPH2D" run - --no-frames
    says "-o DIR; the scene's name, '$name', cannot be one's"
done
absent ../up && absent .hidden && absent scene

# Nothing, noise, too much, a folder, no standard input at all.
given /dev/null 65 "$SPH2D" run - -o none && says '^<stdin>: error\[S100\].*it is empty'
head -c 100000 /dev/urandom >noise && given noise 65 "$SPH2D" run - -o none && says '^<stdin>:[0-9]*:[0-9]*: error\[S100\]'
given /dev/zero 65 "$SPH2D" check - && says "'<stdin>' is too long"
given / 66 "$SPH2D" check - && says "error\[F201\]: cannot read '<stdin>': Is a directory"
# shellcheck disable=SC2016 # the same
expect 66 bash -c '"$SPH2D" check - <&-' && says "error\[F201\]: cannot read '<stdin>'"
absent none
# A file of that name, and commands for which it stands for nothing.
cp "$TINY" ./- && expect 0 "$SPH2D" check ./- -q && rm ./-
expect 64 "$SPH2D" study - && says 'the standard input cannot be a study'
expect 66 "$SPH2D" info - && says F201

# A signal while it waits for the rest ends it at once.
mkfifo slow
sleep 60 >slow &
writer=$!
env --default-signal=INT "$SPH2D" run - -o none <slow 2>err &
pid=$!
sleep 0.5 && kill -INT $pid && code=0 && { wait $pid || code=$?; }
[ $code = 130 ] || fail "an interrupted wait ended with $code"
kill $writer && absent none

# A terminal is told what it is waited for.
command -v python3 >/dev/null || exit 0
"$SPH2D_ROOT/tests/limit.sh" 60 python3 - "$SPH2D" "$TINY" <<'END' || fail 'a terminal'
import os, pty, subprocess, sys
for extra, told in ([], True), (["-q"], False):
    controller, terminal = pty.openpty()
    process = subprocess.Popen([sys.argv[1], "check", "-", *extra], stdin=terminal, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    os.close(terminal)
    with open(sys.argv[2], "rb") as scene:
        os.write(controller, scene.read() + b"\n\x04")
    said = process.communicate()[1]
    assert process.returncode == 0, said
    assert ("reading the scene from the terminal; Ctrl-D" in said) == told, said
END

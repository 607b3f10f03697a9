#!/bin/sh
# Bad scenes: each gets a sentence, with its place, and 65 or 66; nothing is written.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

# bad CODE PATTERN: the scene on stdin is refused by check and by run alike.
bad() {
    cat >scene.yaml
    expect "$1" "$SPH2D" check scene.yaml && says "$2" && empty
    cp err err.check
    expect "$1" "$SPH2D" run scene.yaml -o folder && same err err.check
    absent folder
}
good='domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
run: {until: 0}
'
blocks='blocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]
'
expect 0 "$SPH2D" check "$TINY" && silent

printf '%sspacign: 2\n%s' "$good" "$blocks" | bad 65 '^scene.yaml:4:1: error\[S101\].*spacign'
says "did you mean 'spacing'"
printf '%sgravity: down\n%s' "$good" "$blocks" | bad 65 '^scene.yaml:4:10: error\[S103\]'
printf '%swalls: sprung\n%s' "$good" "$blocks" | bad 65 '^scene.yaml:4:8: error\[S103\]'
printf '%sspacing: 0.2\n%s' "$good" "$blocks" | bad 65 '^scene.yaml:4:1: error\[S102\]'
printf '%sgravity: [0, .nan]\n%s' "$good" "$blocks" | bad 65 '^scene.yaml:4:14: error\[S104\]'
printf 'domain: {min: [0, 0], max: [1, 1]}\nspacing: -1\n%s' "$blocks" | bad 65 '^scene.yaml:2:10: error\[S104\]'
printf 'spacing: 1\n%s' "$blocks" | bad 65 'error\[S105\]: domain'
printf '%sblocks: [{box: {min: [0, 0], max: [2, 0.5]}}]\n' "$good" | bad 65 'scene.yaml:4:.*error\[S107\]'
printf '%sblocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}, {box: {min: [0.2, 0.2], max: [0.6, 0.6]}}]\n' "$good" |
    bad 65 'scene.yaml:4:.*error\[S108\]'
printf '%s' "$good" | bad 65 'error\[S109\]'
printf 'domain: {min: [0, 0], max: [1, 1]}\nspacing: 1e-6\n%s' "$blocks" | bad 65 'error\[S110\]'
printf '%s%s' "$good" "$blocks" | sed 's/until: 0/until: 0, frames: {per_second: 1, style: points, color: sped}/' |
    bad 65 "run.frames.color: 'sped'"
says 'speed, .*Pressures'
printf 'domain: [\n' | bad 65 'error\[S100\]'
printf '' | bad 65 'error\[S100\]'
head -c 100000 /dev/urandom | bad 65 'error\[S100\]'
[ "$(LC_ALL=C tr -d '\n\t\040-\176\200-\377' <err | wc -c)" = 0 ] || fail 'control characters reach the terminal'
# All faults at once.
printf 'domian: 1\nspacing: -1\nfluid: {density: water}\n' | bad 65 'S101' && says S104 && says S103 && says S105

for where in check run; do
    if [ $where = check ]; then o=; else o='-o folder'; fi
    # shellcheck disable=SC2086
    expect 66 "$SPH2D" $where missing.yaml $o && says 'F201.*missing.yaml'
    # shellcheck disable=SC2086
    expect 66 "$SPH2D" $where / $o && says 'F201'
done
if [ "$(id -u)" != 0 ]; then
    cp "$TINY" secret.yaml && chmod 000 secret.yaml
    expect 66 "$SPH2D" check secret.yaml && says 'ermission'
fi

# Overrides are checked like the file.
expect 65 "$SPH2D" check "$TINY" --set run.untli=2 && says "run.untli=2.*S101"
expect 65 "$SPH2D" check "$TINY" --set spacing=-2 && says 'S104'
expect 0 "$SPH2D" check "$TINY" -s run.until=0.1 -s 'blocks[0].velocity=[1, 0]' && prints 't = 0.1 s'

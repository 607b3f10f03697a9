#!/bin/sh
# The manual pages know every option, exit code, message code and key that the command itself does, and the scenes of the
# pages run.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
page=$SPH2D_ROOT/cli/sph2d.1

version=$("$SPH2D" --version | sed -n '1s/^sph2d \([0-9.]*\).*/\1/p')
{
    sed -n 's/^version: //p' "$SPH2D_ROOT/CITATION.cff"
    sed -n '1s/.*(\(.*\)).*/\1/p' "$SPH2D_ROOT/debian/changelog"
    sed -n 's/.*sph2d-\([0-9.]*\)\.tar\.xz.*/\1/p' "$SPH2D_ROOT/docs/installing.md"
} >versions
[ "$(uniq -c versions | xargs)" = "3 $version" ] ||
    fail "CITATION.cff, debian/changelog, docs/installing.md: another version than $version: $(tr '\n' ' ' <versions)"

for command in $("$SPH2D" --help | sed -n 's/^  \([a-z]*\) .*/\1/p'); do
    grep -q "^\.It Cm $command$" "$page" || fail "the man page has no '$command'"
    "$SPH2D" "$command" --help | sed -n 's/^  .*--\([a-z-]*\).*/\1/p' >>options
done
sort -u options | while read -r option; do
    grep -q "Fl -$option\>" "$page" || fail "the man page has no --$option"
done
"$SPH2D" help exit | while read -r code rest; do
    grep -q "^\.It $code$" "$page" || fail "the man page has no exit code $code ($rest)"
done
"$SPH2D" help scene.md | sed -n '/^| kind | columns/,/^$/s/^| \([a-z]*\) |.*/\1/p' | grep -v '^kind$' >kinds
[ "$(wc -l <kinds)" -gt 10 ] || fail 'no kinds of probes'
while read -r kind; do
    sed -n '/^\.Ss Probes$/,/^\.El$/p' "$page" | grep -q "^\.It Cm $kind$" || fail "the man page has no probe $kind"
done <kinds
"$SPH2D" help codes | while read -r code text; do
    grep -A1 "^\.It $code$" "$page" | grep -qi "^${text}.$" || fail "the man page has another $code: $text"
done
"$SPH2D" help init | sed -n '/^templates:/,/^$/s/^  \([a-z_]*\) .*/\1/p' >templates
[ "$(wc -l <templates)" -gt 2 ] || fail 'no templates'
while read -r template; do
    grep -q "\<$template\>" "$page" || fail "the man page has no template $template"
done <templates

# What is generated is what `make scene-docs` would write, and the rest of the pages has the known flows.
scenes=$SPH2D_ROOT/docs/scenes.md
scene_page=$SPH2D_ROOT/cli/sph2d-scene.5
sed '1,/^<!-- keys -->$/d; /^<!-- end of keys -->$/,$d' "$scenes" >scenes.md
"$SPH2D" help scene.md | diff scenes.md - >&2 || fail "docs/scenes.md: the keys have changed; make scene-docs"
sed '1,/^\.\\" keys$/d; /^\.\\" end of keys$/,$d' "$scene_page" >scene.5
"$SPH2D" help scene.5 | diff scene.5 - >&2 || fail "sph2d-scene.5: the keys have changed; make scene-docs"
"$SPH2D" help scene | sed -n 's/^ *flow  *a known flow; one of none, \(.*\); default none$/\1/p' | tr -d , | tr ' ' '\n' >flows
[ "$(wc -l <flows)" -gt 5 ] || fail 'no flows'
while read -r flow; do
    grep -q "^| \`$flow\` |" "$scenes" || fail "docs/scenes.md has no flow $flow"
    grep -q "^\.It Cm $flow$" "$scene_page" || fail "sph2d-scene.5 has no flow $flow"
done <flows

# The first scene of each page is whole, six lines or less; what follows is added to it.
scenes_of() { # FILE BEGIN END: its examples as 1.yaml, 2.yaml
    rm -f ./*.yaml
    awk -v from="$2" -v to="$3" '$0 ~ to { inside = 0 } inside { print >(n ".yaml") } $0 ~ from { ++n; inside = 1 }' "$1"
    if [ ! -s 1.yaml ] || [ ! -s 2.yaml ] || [ "$(wc -l <1.yaml)" -gt 6 ]; then fail "$1 has no two scenes"; fi
    expect 0 "$SPH2D" check 1.yaml
    expect 0 "$SPH2D" run 1.yaml -o run --force --no-frames --quiet -s run.until=0.02
    cat 2.yaml >>1.yaml
    expect 0 "$SPH2D" check 1.yaml --json -s 'blocks[0].box.min=[0.4, 0.1]' -s 'blocks[0].box.max=[1.2, 0.6]'
}
scenes_of "$scenes" '^```yaml$' '^```$'
scenes_of "$scene_page" '^\.Bd -literal' '^\.Ed$'

# The library's page names every header, has a whole program, which is the example, and a piece that compiles.
library=$SPH2D_ROOT/cli/libsph2d.3
for header in "$SPH2D_ROOT"/include/sph2d/*.h; do
    name=sph2d/$(basename "$header")
    [ "$name" = sph2d/export.h ] || grep -q "^\.It In $name$" "$library" || fail "libsph2d.3 has no $name"
done
awk '/^\.Sh EXAMPLES/ { on = 1 } on && /^\.Ed/ { inside = 0 } inside { gsub(/\\e/, "\\"); print >(n ".c") }
    on && /^\.Bd/ { ++n; inside = 1 }' "$library"
sed -n '/^#include/,$p' "$SPH2D_ROOT/examples/embed.c" | diff - 1.c >&2 ||
    fail 'the program of libsph2d.3 is not examples/embed.c'
{
    printf '#include <sph2d/io.h>\nsph2d_status made(sph2d_report report, sph2d_sim *sim)\n{\nsph2d_status status;\n'
    cat 2.c
    printf 'return status;\n}\n'
} >piece.c
! command -v cc >/dev/null || cc -I"$SPH2D_ROOT/include" -Wall -Werror -fsyntax-only piece.c

# "referenced manual not found" is said of pages that are not installed.
if command -v mandoc >/dev/null; then
    for file in "$SPH2D_ROOT"/cli/*.[135]; do
        mandoc -Tlint "$file" | grep -v 'referenced manual not found' >lint && fail "mandoc: $(cat lint)"
        mandoc -Tascii "$file" >/dev/null
    done
fi

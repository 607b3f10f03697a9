#!/bin/sh
# The plan of a scene, as a table and as JSON; init writes scenes that pass it.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" check "$TINY"
silent
for row in scene active particles 'support radius' 'sound speed' compression 'time step' steps memory snapshots frames \
    time; do
    prints "^$row  *[^ ]"
done
prints 'sources: 1, drains: 1, obstacles: 1, interactions: 1, probes: 3'
expect 0 "$SPH2D" check "$TINY" --json && lines 1
for key in scene particles wall_particles support_radius sound_speed sound_speed_formula compression \
    impact_compression time_step time_step_limit steps memory_bytes snapshots frames disk_bytes seconds cpu_seconds; do
    prints "\"$key\": "
done
if command -v python3 >/dev/null; then
    python3 -c 'import json; print(json.load(open("out"))["particles"])' | grep -qx 96 || fail 'not JSON'
fi
expect 0 "$SPH2D" check "$TINY" --quiet && empty
expect 0 "$SPH2D" run "$TINY" --dry-run && prints '^particles'
[ "$(echo ./*)" = './err ./out' ] || fail 'check writes files'

if can_draw; then
    expect 0 "$SPH2D" check "$TINY" --preview first.png
    head -c 8 first.png | od -An -tx1 | grep -q '89 50 4e 47' || fail 'the preview is no PNG'
    expect 73 "$SPH2D" check "$TINY" --preview missing/first.png
else
    expect 69 "$SPH2D" check "$TINY" --preview first.png && absent first.png
fi

# init: every template passes check; nothing is overwritten without --force.
"$SPH2D" help init | sed -n '/^templates:/,/^$/s/^  \([a-z_]*\) .*/\1/p' >templates
while read -r template; do
    expect 0 "$SPH2D" init "$template" --template "$template" && says "$template/scene.yaml"
    expect 0 "$SPH2D" check "$template/scene.yaml" && prints "^scene *$template"
    grep -q '^# between particles \[m\]; above 0; must be given$' "$template/scene.yaml" || fail 'no comments'
done <templates
expect 73 "$SPH2D" init dam_break && says F207
echo mine >dam_break/scene.yaml
expect 73 "$SPH2D" init dam_break && grep -qx mine dam_break/scene.yaml
expect 0 "$SPH2D" init dam_break --force && expect 0 "$SPH2D" check dam_break/scene.yaml
expect 0 "$SPH2D" init one.yaml -q && silent && expect 0 "$SPH2D" check one.yaml && prints '^scene *one'
expect 73 "$SPH2D" init one.yaml/two
expect 73 "$SPH2D" init missing/folder/name

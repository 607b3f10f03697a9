#!/bin/sh
# The plan of a scene, as a table and as JSON; init writes scenes that pass it.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" check "$TINY"
silent
for row in scene active particles area 'support radius' 'sound speed' compression 'time step' steps memory snapshots frames \
    time; do
    prints "^$row  *[^ ]"
done
prints 'sources: 1, drains: 1, obstacles: 1, interactions: 1, probes: 3'
expect 0 "$SPH2D" check "$TINY" --json && lines 1
for key in scene particles wall_particles area_asked area_placed support_radius sound_speed sound_speed_formula compression \
    capillary_compression impact_compression time_step time_step_limit steps memory_bytes snapshots frames disk_bytes seconds cpu_seconds; do
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

# A wall drawn the wrong way round is turned, liquid on both sides is asked about, liquid in the layers has its place.
wall() {
    cat >wall.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.02
fluid: water
method: {name: wcsph}
obstacles:
  - line: [[0.2, 0], [0.2, 0.5]]
    liquid: $1
blocks:
  - box: {min: [$2, 0], max: [0.6, 0.4]}
END
}
wall auto 0.2
expect 0 "$SPH2D" check wall.yaml && prints '^area  *0.16 m^2 requested, 0.16 m^2 placed (+0.00 %)'
wall auto 0.1
expect 65 "$SPH2D" check wall.yaml && says '^wall.yaml:6:11: error\[S106\]: obstacles\[0\].line: liquid lies on both'
# shellcheck disable=SC2016 # the backquotes are what it says
says 'hint: `liquid: both` makes it a solid 0.06 m thick'
wall both 0.1
expect 0 "$SPH2D" check wall.yaml && prints '^area  *0.176 m^2 requested, 0.176 m^2 placed (+0.00 %)'
wall left 0.2
expect 65 "$SPH2D" check wall.yaml && says '^wall.yaml:6:11: error\[S108\]: obstacles\[0\].line: .* layers of boundary particles'
# shellcheck disable=SC2016 # the same
says 'try `liquid: right`'

# With a source the number of steps and the time are those of the whole run, not of its beginning: the time within a
# factor of two, since other jobs disturb the processor.
cat >jet.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.02
method: {name: wcsph}
sources: [{at: [0.3, 0.8], direction: [1, 0], width: 0.1, speed: 1}]
run: {until: 3}
END
expect 0 "$SPH2D" check jet.yaml --json --threads 1
sed 's/.*"steps": \([0-9.e+]*\).*"cpu_seconds": \([0-9.e+-]*\).*/\1 \2/' out >wanted
expect 0 "$SPH2D" run jet.yaml -o jet --json --threads 1
sed 's/.*"step_cpu_seconds": \([0-9.e+-]*\).*"steps": \([0-9]*\).*/\2 \1/' out | paste wanted - >both
awk '{ exit !($1 > 0.8 * $3 && $1 < 1.2 * $3 && $2 > $4 / 2 && $2 < 2 * $4) }' both || fail "a jet: $(cat both)"

# So are those of few particles, of which no coarser form can be run, and of bodies that meet walls, which a run without
# contacts would see leave.
cat >few.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
method: {name: constraint}
blocks: [{box: {min: [0.3, 0.4], max: [0.7, 0.8]}}]
run: {until: 0.5}
END
cat >thrown.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
method: {name: constraint}
blocks: [{box: {min: [0, 0], max: [1, 0.2]}}]
bodies: [{box: {min: [0.3, 0.4], max: [0.7, 0.8]}, density: 5000, velocity: [0, -20]}]
run: {until: 0.2}
END
for scene in few thrown; do
    expect 0 "$SPH2D" check $scene.yaml --json --threads 1
    sed 's/.*"steps": \([0-9.e+]*\).*/\1/' out >wanted
    expect 0 "$SPH2D" run $scene.yaml -o $scene --json --threads 1
    sed 's/.*"steps": \([0-9]*\).*/\1/' out | paste wanted - >both
    awk '{ exit !($1 > 0.9 * $2 && $1 < 1.1 * $2) }' both || fail "$scene: $(cat both)"
done

# Surface tension compresses a small drop more than the sound speed is made for: check says so, and of a finer one nothing.
cat >drop.yaml <<END
domain: {min: [0, 0], max: [0.01, 0.01]}
spacing: 2e-4
gravity: [0, 0]
fluid: {surface_tension: 0.0728}
blocks: [{disc: {center: [0.005, 0.005], radius: 0.001}}]
run: {until: 0.01}
END
expect 0 "$SPH2D" check drop.yaml && says 'fluid.surface_tension: it compresses the thinnest block by 2.5 %' &&
    prints '^  *2.5 % by surface tension'
expect 0 "$SPH2D" check drop.yaml -s spacing=5e-5 && silent && prints '^  *0.625 % by surface tension'

# Along a period nothing stops what gravity accelerates; a layer that its walls hold flows as fast as they let it.
cat >fall.yaml <<END
domain: {min: [0, 0], max: [0.1, 0.1]}
boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}
spacing: 0.005
blocks: [{box: {min: [0, 0], max: [0.1, 0.1]}}]
fluid: {dynamic_viscosity: 0}
run: {until: 1}
END
expect 0 "$SPH2D" check fall.yaml && says 'gravity: along a period nothing but friction stops the liquid: it may reach 9.81 m/s'
expect 0 "$SPH2D" check fall.yaml -s 'gravity=[0, 0]' -s 'blocks[0].velocity=[1, 0]' && silent
expect 0 "$SPH2D" check fall.yaml -s fluid.dynamic_viscosity=100 && silent

# Particles that a blow throws out in the first millionth of a run are not taken to leave like that to its end: each of
# its steps computes hundreds of them.
cat >blow.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.025
blocks: [{box: {min: [0, 0], max: [1, 0.4]}}]
bodies: [{box: {min: [0.2, 0.5], max: [0.4, 0.6]}, density: 500, velocity: [0, -1e6]}]
run: {until: 0.2}
END
expect 0 "$SPH2D" check blow.yaml --json --threads 1
sed 's/.*"steps": \([0-9.e+]*\).*"cpu_seconds": \([0-9.e+-]*\).*/\1 \2/' out |
    awk '{ exit !($2 > 1e-5 * $1) }' || fail "a blow: $(cat out)"

# Many particles are checked by fewer, in seconds and little memory; more than there is memory for are refused.
cat >large.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.0003
blocks: [{box: {min: [0, 0], max: [0.5, 0.9]}}]
END
# shellcheck disable=SC3045 # dash and bash have it
(ulimit -v 4000000 && expect 0 "$SPH2D" check large.yaml --json --threads 1) && says 'a spacing .* times as large'
sed 's/.*"particles": \([0-9]*\), "wall_particles": \([0-9]*\).*/\1 \2/' out |
    awk '{ exit !($1 > 4.95e6 && $1 < 5.05e6 && $2 > 49000 && $2 < 51000) }' || fail "a large scene: $(cat out)"
expect 65 "$SPH2D" check large.yaml -s spacing=1e-8 && says 'particles need .* of memory' && says 'larger spacing'

# What no coarser form can stand for is read, not tried: walls as long as a road. A thousand posts in a pond take no
# longer than one.
cat >road.yaml <<END
domain: {min: [0, 0], max: [3, 110946]}
spacing: 0.025
blocks: [{box: {min: [0.2, 0.5], max: [0.8, 1.1]}}]
run: {until: 6}
END
# shellcheck disable=SC3045 # every shell here has it
(ulimit -v 2000000 && expect 0 "$SPH2D" check road.yaml) && says 'its start was not tried' && prints '^particles  *about'
expect 0 "$SPH2D" check road.yaml --json && prints '"particles": [0-9]*'
{
    sed 's/0.5, 0.9/1, 0.2/; s/0.0003/0.0025/' large.yaml
    echo 'obstacles:'
    awk 'BEGIN { for (i = 0; i < 1000; ++i) printf "  - circle: {center: [%.4f, %.4f], radius: 0.008}\n",
        0.016 + 0.03125 * (i % 32), 0.016 + 0.03125 * int(i / 32) }'
} >posts.yaml
expect 0 "$SPH2D" check posts.yaml && says 'a spacing .* times as large'

# Its trial steps end where the run does: a guard that fires beyond that is none of its business.
set -- "$TINY" -s method.time_step=0.004
expect 1 "$SPH2D" run "$@" -q --no-frames -s run.until=0.3 -o beyond
for until in 0.002 0.05; do
    expect 0 "$SPH2D" run "$@" -q --no-frames -s run.until=$until -o until_$until
    expect 0 "$SPH2D" check "$@" -s run.until=$until && prints '^time  *about'
done
expect 0 "$SPH2D" check "$@" -s run.until=0.15 -j 1

# init: every template passes check; nothing is overwritten without --force.
"$SPH2D" help init | sed -n '/^templates:/,/^$/s/^  \([a-z_]*\) .*/\1/p' >templates
while read -r template; do
    expect 0 "$SPH2D" init "$template" --template "$template" && says "$template/scene.yaml"
    expect 0 "$SPH2D" check "$template/scene.yaml" && prints "^scene *$template"
    grep -q '^# between particles \[m\]; above 0; must be given$' "$template/scene.yaml" || fail 'no comments'
done <templates
# A command that is printed to be copied goes through a shell as it is.
# shellcheck disable=SC2016 # it shall not be expanded
for name in 'my tank' 'a "quoted" $HOME `x`'; do
    # shellcheck disable=SC2016 # eval expands it
    expect 0 "$SPH2D" init "$name" && says 'next: sph2d check' && eval "$(sed -n 's/.*next: sph2d/"$SPH2D"/p' err) >plan"
    grep -q 'no errors' plan || fail "the command for '$name' does not check it"
done
expect 73 "$SPH2D" init dam_break && says F207
echo mine >dam_break/scene.yaml
expect 73 "$SPH2D" init dam_break && grep -qx mine dam_break/scene.yaml
(ulimit -f 1 && ! "$SPH2D" init dam_break --force 2>/dev/null) && grep -qx mine dam_break/scene.yaml
expect 0 "$SPH2D" init dam_break --force && expect 0 "$SPH2D" check dam_break/scene.yaml
expect 0 "$SPH2D" init one.yaml -q && silent && expect 0 "$SPH2D" check one.yaml && prints '^scene *one'
expect 73 "$SPH2D" init one.yaml/two
expect 73 "$SPH2D" init missing/folder/name

#!/bin/sh
# Help and version go to stdout and end with 0; a bad command line ends with 64 and a way out.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 0 "$SPH2D" --help && prints 'usage: sph2d COMMAND' && silent
expect 0 "$SPH2D" -h
expect 0 "$SPH2D" help
for command in $("$SPH2D" --help | sed -n 's/^  \([a-z]*\) .*/\1/p'); do
    expect 0 "$SPH2D" "$command" --help && prints "usage: sph2d $command"
    expect 0 "$SPH2D" help "$command" && prints "usage: sph2d $command" && ! grep -q "(null)" out
    # before any other work
    expect 0 "$SPH2D" "$command" --version && prints '^sph2d [0-9]'
done
expect 0 "$SPH2D" --version
prints '^sph2d [0-9]*\.[0-9]*\.[0-9]*$' && prints 'MIT' && prints '^HDF5 *[0-9]' && prints '^instruction sets *baseline'
expect 0 "$SPH2D" -V --json && prints '^{"name": "sph2d", "version": "'
expect 0 "$SPH2D" help exit && lines 13 && prints '^  75  EX_TEMPFAIL'
expect 0 "$SPH2D" help codes && prints '^S104  '
expect 0 "$SPH2D" help openings && prints '^openings:  *parts of sides' && prints '^  - name ' && prints '^    velocity '
"$SPH2D" help scene >all && "$SPH2D" help openings >some
sed -n '/^openings:/,/^obstacles:/p' all | sed '$d' | cmp - some || fail 'other words for openings'
expect 0 "$SPH2D" help spacing && lines 1
expect 0 "$SPH2D" help scene && prints 'dynamic_viscosity .*\[Pa s\]; at least 0; default 0.001'


# What completions of shells ask: keys with the items of a scene's lists, of any scene where there is none.
tab=$(printf '\t')
expect 0 "$SPH2D" help completions "$TINY" && prints "^key${tab}obstacles\[0\].liquid${tab}auto left right both inside$"
! grep -q 'obstacles\[1\]' out || fail 'an obstacle that the scene has not'
prints "^key${tab}fluid${tab}none water " && prints "^key${tab}spacing${tab}-$"
mkfifo pipe
for none in '' missing pipe "$SPH2D"; do expect 0 "$SPH2D" help completions "$none" && prints "^key${tab}blocks\[0\].box.min" && silent; done
mkdir folder
expect 0 "$SPH2D" help completions folder && lines 1 && prints "^key${tab}run.until${tab}-$"
expect 64 "$SPH2D" help completions folder folder && says 'one topic'
rm -r folder pipe

expect 0 "$SPH2D" help materials && prints '^water  *998.2  *0.0010016  *0.07274  *IAPWS'
prints '^blood  *1051  *see below  *0.0526  *human, at 37 C; Cho & Kensey 1991'
prints '^blood  *carreau, dynamic_viscosity 0.056, infinite_viscosity 0.00345, relaxation_time 3.313, index 0.3568$'
prints '^mud  *herschel_bulkley, yield_stress 9.11, consistency 2.25, index 1$'
# every material that a scene may name is in the table, with a source, and makes a scene
"$SPH2D" help scene | sed -n 's/^  *material .*one of none, \([a-z_, ]*\);.*/\1/p' | tr -d ',' | tr ' ' '\n' >named
[ "$(wc -l <named)" = 14 ] || fail 'not fourteen materials'
while read -r material; do
    "$SPH2D" help materials | grep -q "^$material  *[0-9].*[12][90][0-9][0-9]\|^$material  *[0-9].*\(IAPWS\|table\)" ||
        fail "no $material"
    cat >material.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
fluid: $material
blocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]
END
    expect 0 "$SPH2D" check material.yaml --quiet && empty
done <named
# one without a single viscosity is not for muller, unless it is given one
echo 'method: muller' >>material.yaml
expect 65 "$SPH2D" check material.yaml
says '^material.yaml:3:8: error\[S111\]: fluid.material: mud is herschel_bulkley'
# shellcheck disable=SC2016 # the backquotes are what it says
says 'or add `model: newtonian` with a `dynamic_viscosity`'
expect 65 "$SPH2D" check material.yaml -s fluid.model=newtonian && says 'fluid.dynamic_viscosity: must be given: mud is'
expect 0 "$SPH2D" check material.yaml -s fluid.model=newtonian -s fluid.dynamic_viscosity=20 --quiet
rm material.yaml named

# every method with its walls, and the keys that not every method has
expect 0 "$SPH2D" help methods && prints '^wcsph with variational operators (the default)$'
prints '^  walls  *spring, heavy, reflect$' && prints '^  method.tolerance  *constraint$'
for method in wcsph constraint pcisph muller; do prints "^$method"; done

expect 64 "$SPH2D" && says "Try 'sph2d --help'"
expect 64 "$SPH2D" rnu && says "unknown command 'rnu'; did you mean 'run'"
expect 64 "$SPH2D" xyzzy && says "unknown command 'xyzzy'"
expect 64 "$SPH2D" --json run x && says 'options come after the command'
expect 64 "$SPH2D" help chekc && says "did you mean 'check'"
expect 64 "$SPH2D" help xyzzy && says "unknown topic 'xyzzy'$"
expect 64 "$SPH2D" help run check && says 'one topic at a time'
expect 64 "$SPH2D" run
says 'a scene file must be given' && says "Try 'sph2d run --help'"
expect 66 "$SPH2D" run x && says "cannot open 'x'"
expect 64 "$SPH2D" run x y -o z
expect 64 "$SPH2D" run --frce x && says "unknown option '--frce'; did you mean '--force'"
expect 64 "$SPH2D" run -qxz x && says "unknown option '-x'"
expect 64 "$SPH2D" run --size 3x3 && says 'not an option of this command'
expect 64 "$SPH2D" run x -o && says "'-o' needs an argument"
expect 64 "$SPH2D" run x --output && says "'--output' needs an argument"
expect 64 "$SPH2D" run --force=1 x && says "'--force' takes no argument"
for bad in -j0 -j1025 -jx '-j 2x' --isa=mmx --max-wall=3x --max-wall=0 --max-wall=-1h --max-wall= --progress=no --gl=x \
    --set=a --set==1; do
    expect 64 "$SPH2D" run x -o y "$bad"
done
for bad in --size=10x10 --size=100 --size=100x --size=99999x9 --style=x --look=x --background=x --view=1,1,0,2 --view=0,0,1 --isolines=x --arrows=x --streamlines=x --radius=0 --radius=nan --color=x --range=1 \
    --range=2,1 --range=a,b; do
    expect 64 "$SPH2D" render x -o y "$bad"
done
expect 64 "$SPH2D" render -o y
expect 64 "$SPH2D" render x
expect 64 "$SPH2D" resume
expect 64 "$SPH2D" resume x --set fluid.density=3 && says 'only run.until'
expect 64 "$SPH2D" info
expect 64 "$SPH2D" init
expect 64 "$SPH2D" init x --template drip && says "did you mean 'drop'"
expect 64 "$SPH2D" init x --template xyzzy && says "no template 'xyzzy'$"
expect 64 "$SPH2D" check --json && says '^{"severity": "error", .*"message": "a scene file must be given"}$'
# -- ends the options
expect 66 "$SPH2D" check -- --help && says "'--help'"
absent x && absent y

#!/bin/sh
# Shapes from a drawing: found beside the scene, refused with file and line, not needed to resume.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

mkdir scenes
cp "$SPH2D_ROOT"/tests/restarts/scenes/drawn.* scenes
expect 0 "$SPH2D" check scenes/drawn.yaml
expect 66 "$SPH2D" check scenes/drawn.yaml --set 'drains=[{svg: none.svg#a}]'
says "drains\[0\].svg: cannot open 'scenes/none.svg'"
expect 65 "$SPH2D" check scenes/drawn.yaml --set 'drains=[{svg: drawn.svg#stonee}]'
says "scenes/drawn.svg: .*there is no 'stonee'; there are water, hole, stone, lip, boat"
sed 's/M 130 62 q/M 130 62 b/' scenes/drawn.svg >scenes/other.svg
expect 65 "$SPH2D" check scenes/drawn.yaml --set 'obstacles=[{svg: other.svg#lip}]'
says "scenes/other.svg:7:3: .*the path of 'lip': 'b' is no command after 'M 130 62 b'"
# What has a hole is no outline, and one that crosses itself is refused where the scene names it.
sed 's/H 112/Z M 90 55 H 100 V 60 Z/' scenes/drawn.svg >scenes/other.svg
expect 65 "$SPH2D" check scenes/drawn.yaml --set 'bodies=[{svg: other.svg#boat, density: 500}]'
says "'boat': a second part begins"
sed 's/H 112/L 88 80 V 70 L 112 60/' scenes/drawn.svg >scenes/other.svg
expect 65 "$SPH2D" check scenes/drawn.yaml --set 'bodies=[{name: boat, svg: other.svg#boat, density: 500}]'
says 'bodies\[0\].svg: a polygon must not cross or touch itself'

# A scene that is given out has polygons, and a stopped run goes on without the drawing.
expect 0 "$SPH2D" run scenes/drawn.yaml -o whole -q
code=0
"$SPH2D" run scenes/drawn.yaml -o parts -q --max-wall 0.001s >out 2>err || code=$?
[ $code = 75 ] || fail "stopped run ended with $code"
rm scenes/*.svg
expect 0 "$SPH2D" resume parts -q && same whole parts

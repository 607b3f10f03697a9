#!/bin/bash
# Long: completion in interactive shells on a pseudo terminal: bash with and without the package bash-completion, and zsh, as
# far as they are installed. What is offered is what the help of the command has.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
command -v python3 >/dev/null || exit 77

mkdir -p files/folder/inner 'files/two words' files/run
cd files || exit 1
touch scene.yaml data.json 'my scene.yaml' "it's.yaml" 'a=b:c.yml' $'b\xc3\xa4che.yaml' notes.txt snapshot_000000.h5 picture.png \
    folder/deep.yaml
touch folder/energy.csv folder/gauge.csv
cat >tank.yaml <<END
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.1
blocks: [{box: {min: [0, 0], max: [0.4, 0.4]}}, {circle: {center: [0.7, 0.7], radius: 0.2}}]
obstacles: [{name: gate, line: [[0.5, 0.6], [0.5, 1]]}]
END
mkdir ../bin ../home && ln -s "$SPH2D" ../bin/sph2d && cp scene.yaml ../home/at_home.yaml
PATH=$PWD/../bin:$PATH HOME=$PWD/../home LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 \
    python3 "$SPH2D_ROOT/tests/cli/completions.py" "$SPH2D_ROOT/cli/completions" || fail 'completions'

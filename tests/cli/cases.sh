#!/bin/sh
# Long: the cases of examples/ at low resolution: each error below a bound that it keeps with little to spare.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

for study in "$SPH2D_ROOT"/tests/cases/*.yaml; do
    case=$(basename "$study" .yaml)
    [ -f "$SPH2D_ROOT/examples/$case/study.yaml" ] || fail "examples/$case has no study"
    expect 0 "$SPH2D" study "$study" --progress never
    prints '^| row '
done
for study in "$SPH2D_ROOT"/examples/*/study.yaml; do
    case=$(basename "$(dirname "$study")")
    [ -f "$SPH2D_ROOT/tests/cases/$case.yaml" ] || fail "case $case is not tested"
done

#!/usr/bin/env bash
# A term that a scene does not name costs it nothing: terms.sh BENCH BARE
#
# BARE is the same program from a build without these terms: gradients of density, tensile control, shifting and Morris'
# viscosity. A scene that names none of them may execute 1 % more instructions.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
failed=0
for scene in lean lean-mixed; do
    with=$("$here/instructions.sh" "$1" $scene | awk '{ print $2 }')
    without=$("$here/instructions.sh" "$2" $scene | awk '{ print $2 }')
    awk -v scene=$scene -v with="$with" -v without="$without" 'BEGIN {
        more = 100 * (with / without - 1)
        printf "%-11s %d instructions a particle and step, %d in a build without the terms: %+.2f %%\n", scene, with,
            without, more
        exit !(more <= 1)
    }' || failed=1
done
exit $failed

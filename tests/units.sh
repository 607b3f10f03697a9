#!/usr/bin/env bash
# All unit tests, a suite a process: units.sh CHECK_ALL FOLDER JOBS
#
# What failed, and the sum over all suites, are printed last, as Check prints them. FOLDER gets what each suite printed.
set -euo pipefail
checks=$1 folder=$2 jobs=$3
rm -rf "$folder" && mkdir -p "$folder"
export checks folder
suites=$("$checks" --list)
# shellcheck disable=SC2016 # the inner shell expands it
xargs -P "$jobs" -n 1 sh -c '"$checks" "$0" >"$folder/$0.log" 2>&1 || echo "$0" >>"$folder/failed"' <<<"$suites"
cd "$folder"
[ ! -e failed ] || sort failed | while read -r suite; do
    grep -vE '^Running suite|^[0-9]+%: Checks: ' "$suite.log" || echo "suite $suite ended without a word"
done
# A suite that was killed has no sum: it is an error.
awk -F '[:,]' -v suites="$(wc -w <<<"$suites")" '
    /^[0-9]+%: Checks: / { ++sums; checks += $3; failures += $5; errors += $7 }
    END {
        errors += suites - sums
        checks += suites - sums
        printf "%d%%: Checks: %d, Failures: %d, Errors: %d\n", 100 * (1 - (failures + errors) / checks), checks, failures, errors
        exit failures + errors > 0
    }' ./*.log
[ ! -e failed ]

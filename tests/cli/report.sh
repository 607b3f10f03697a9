#!/bin/sh
# Long: the page of all studies, from one of them: table for the docs, links, a section, going on.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

printf '# a comment\nfree_flight/study 0.5 points speed\n' >studies
report() {
    expect 0 env STUDIES="$PWD/studies" "$SPH2D_ROOT/tests/report/report.sh" "$SPH2D" page
}
report && prints '^free_flight$' && prints '/page/index.html$'
rows=$(awk 'END { print NR - 1 }' page/free_flight/study.csv)
[ "$rows" -gt 0 ] || fail 'no rows'
awk -F'|' -v rows="$rows" 'NR > 2 && !(NF == 10 && $4 ~ /[0-9]/ && $6 > 0 && $7 > 0 && $8 > 0) { exit 1 }
    END { exit !(NR == rows + 2) }' page/cases.md || fail 'cases.md has not a row each, with numbers'
for part in '<h1>' '<section id="free_flight">' '<h2>free_flight</h2>' 'href="#free_flight"' '</html>'; do
    grep -q "$part" page/index.html || fail "no $part in the page"
done
if [ -f page/free_flight/error_time.svg ]; then
    grep -q 'src="data:image/svg+xml;base64,' page/index.html || fail 'the plot is not inside'
fi
cp page/cases.md before
report
cmp -s page/cases.md before || fail 'rows that were there are not the same'
[ "$(find . -type f ! -path './page/*' ! -name out ! -name err | sort | tr '\n' ' ')" = './before ./studies ' ] ||
    fail 'files beside the page'

# A study that fails is a section that says so, and fails the report.
mkdir -p examples
printf 'nothing/study -\n' >studies
expect 1 env STUDIES="$PWD/studies" "$SPH2D_ROOT/tests/report/report.sh" "$SPH2D" page
says 'failed or missed a bound: 1'
grep -q 'This study failed' page/index.html || fail 'no word of the failure'

# Lists the mutants of C files, one a line: file, line, column, length, old text, new text, separated by tabs.
#
# Every number becomes a tenth larger (0 becomes 1), every sum a difference and the reverse, every minus in front of a term
# goes. Comments, strings, preprocessor lines, loop headers, enumerations, indices, tests of kinds and sizes of memory are
# left alone: they hold no formula.
function emit(column, old, new)
{
    printf "%s\t%d\t%d\t%d\t%s\t%s\n", FILENAME, FNR, column, length(old), old, new
}
function blank(n,    s)
{
    s = sprintf("%" n "s", "")
    return s
}
FNR == 1 { comment = 0; skip = 0 }
{
    line = $0
    # Comments and strings become blanks, so that columns stay.
    out = ""
    while (length(line) > 0) {
        if (comment) {
            end = index(line, "*/")
            if (end == 0) { out = out blank(length(line)); line = ""; break }
            out = out blank(end + 1); line = substr(line, end + 2); comment = 0
        } else if (match(line, /\/\*|"([^"\\]|\\.)*"/)) {
            if (substr(line, RSTART, 2) == "/*") {
                out = out substr(line, 1, RSTART - 1) "  "; line = substr(line, RSTART + 2); comment = 1
            } else {
                out = out substr(line, 1, RSTART - 1) blank(RLENGTH); line = substr(line, RSTART + RLENGTH)
            }
        } else { out = out line; line = "" }
    }
    if (out ~ /^ *#|for \(|SPH2D__FOR_|enum|^_Static_assert|case |switch|#pragma|sizeof|alloc\(|resize\(|release\(|reserve\(|^ *};?$/) next
    rest = out; at = 1
    while (match(rest, /(^|[^A-Za-z0-9_.])[0-9]+(\.[0-9]*)?(e-?[0-9]+)?/)) {
        start = RSTART; size = RLENGTH
        if (substr(rest, start, 1) !~ /[0-9]/) { ++start; --size }
        before = substr(rest, 1, start - 1); number = substr(rest, start, size); after = substr(rest, start + size, 1)
        column = at + start - 1
        if (substr(out, 1, column - 1) !~ /\[[^\]]*$|(\{|[ ,=?])0$|\{$/ && after !~ /[A-Za-z_.]/ &&
            !(number == "0" && substr(out, column - 1, 3) ~ /\{0\}/) &&
            !(number == "0" && substr(out, 1, column - 1) ~ /[><=]=? $/) )
            emit(column, number, number == "0" ? "1" : "(" number " * 1.1)")
        at += start + size - 1; rest = substr(out, at)
    }
    for (column = 2; column < length(out); ++column) {
        three = substr(out, column, 3); four = substr(out, column, 4)
        if (four == " += ") emit(column + 1, "+=", "-=")
        else if (four == " -= ") emit(column + 1, "-=", "+=")
        else if (three == " + ") emit(column + 1, "+", "-")
        else if (three == " - ") emit(column + 1, "-", "+")
        else if (substr(out, column, 2) ~ /[(,=? ]-/ && substr(out, column + 2, 1) ~ /[A-Za-z0-9(]/ &&
                 substr(out, 1, column) !~ /[A-Za-z0-9_)\]]$/)
            emit(column + 1, "-", " ")
    }
}

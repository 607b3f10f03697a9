# Prints the string literals of C sources, one in a line; those in a row, but for white space and comments, as one.
function end_of_row() {
    if (literal != "")
        print literal
    literal = ""
}
FNR == 1 { end_of_row() }
/^[ \t]*#include/ { next }
{
    line = $0
    while (line != "") {
        if (comment) {
            at = index(line, "*/")
            comment = !at
            line = at ? substr(line, at + 2) : ""
        } else if (match(line, /^[ \t\\]+/) || match(line, /^\/\/.*/)) {
            line = substr(line, RLENGTH + 1)
        } else if (line ~ /^\/\*/) {
            comment = 1
            line = substr(line, 3)
        } else if (match(line, /^"([^"\\]|\\.)*"/)) {
            literal = literal substr(line, 2, RLENGTH - 2)
            line = substr(line, RLENGTH + 1)
        } else {
            end_of_row()
            line = match(line, /^'([^'\\]|\\.[0-9a-f]*)'/) ? substr(line, RLENGTH + 1) : substr(line, 2)
        }
    }
}
END { end_of_row() }

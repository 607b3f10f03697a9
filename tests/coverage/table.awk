# Merges what gcov tells of all objects and prints the table:
#     gcov -t -b -c -r OBJECTS | awk -f table.awk -v missing=FILE
#
# A line, branch or function counts once for each place in the source, however many objects have it: it is taken if it
# is in any of them. Copies of a branch are told apart by their rank in their line. Calls are not branches, nor are
# edges that only exceptions take.
BEGIN {
    LINES = 90
    BRANCHES = 80
}

function percent(part, whole) { return whole ? 100 * part / whole : 100 }
function row(name, at,    where) {
    printf "%-24s %6d %6d %5.1f %%   %6d %6d %5.1f %%   %5d %5d\n", name, lines[at], ran[at],
        percent(ran[at], lines[at]), branches[at], taken[at], percent(taken[at], branches[at]), functions[at],
        called[at]
}
# Adds to a file, its folder and its part.
function add(count, file,    folder, part) {
    folder = part = file
    sub(/\/[^\/]*$/, "", folder)
    sub(/\/.*/, "", part)
    ++count[file]
    ++count["/" folder]
    ++count["//" part]
    if (!(file in files)) files[file] = "/" folder
    folders["/" folder] = folder
}

match($0, /^ *-: *0:Source:/) {
    file = substr($0, RLENGTH + 1)
    wanted = file ~ /^(src|cli)\//
    name = ""
    next
}
!wanted { next }
/^function / {
    name = $2
    sub(/\..*/, "", name)
    at = file "\t" name
    if (!(at in function_calls)) function_calls[at] = 0
    function_calls[at] += $4 > 0
    next
}
/^branch / {
    at = file "\t" line "\t" rank++
    if (/\(throw\)/) next
    if (!(at in branch_runs)) branch_runs[at] = 0
    if (/ taken [1-9]/) branch_runs[at] = 1
    next
}
/^ *[-#=0-9]+\*?: *[0-9]+:/ {
    split($0, field, ":")
    line = field[2] + 0
    rank = 0
    if (line == 0 || field[1] ~ /-$/) next
    at = file "\t" line
    if (!(at in line_runs)) line_runs[at] = 0
    if (field[1] ~ /[1-9]/) line_runs[at] = 1
    text = $0
    sub(/^[^:]*:[^:]*:/, "", text)
    source[at] = text
}

END {
    for (at in line_runs) {
        split(at, part, "\t")
        add(lines, part[1])
        if (line_runs[at]) add(ran, part[1])
        else printf "%s:%d: line: %s\n", part[1], part[2], source[at] >missing
    }
    for (at in branch_runs) {
        split(at, part, "\t")
        add(branches, part[1])
        if (branch_runs[at]) add(taken, part[1])
        else if (line_runs[part[1] "\t" part[2]])
            printf "%s:%d: branch %d: %s\n", part[1], part[2], part[3], source[part[1] "\t" part[2]] >missing
    }
    for (at in function_calls) {
        split(at, part, "\t")
        add(functions, part[1])
        if (function_calls[at]) add(called, part[1])
        else printf "%s:0: function: %s\n", part[1], part[2] >missing
    }
    printf "%-24s %6s %6s %7s   %6s %6s %7s   %5s %5s\n", "", "lines", "run", "", "branch", "taken", "", "funcs",
        "called"
    sort = "LC_ALL=C sort"
    for (at in folders)
        printf "%-24s %6d %6d %5.1f %%   %6d %6d %5.1f %%   %5d %5d\n", folders[at], lines[at], ran[at],
            percent(ran[at], lines[at]), branches[at], taken[at], percent(taken[at], branches[at]), functions[at],
            called[at] | sort
    close(sort)
    row("src, all of it", "//src")
    row("cli, all of it", "//cli")
    printf "\nfiles with less than %d %% of lines or %d %% of branches:\n", LINES, BRANCHES
    for (file in files)
        if (percent(ran[file], lines[file]) < LINES || percent(taken[file], branches[file]) < BRANCHES)
            printf "  %-44s %4d lines %5.1f %%   %4d branches %5.1f %%\n", file, lines[file],
                percent(ran[file], lines[file]), branches[file], percent(taken[file], branches[file]) | sort
    close(sort)
    bad = 0
    for (part_of in lines)
        if (part_of ~ /^\/\// && (percent(ran[part_of], lines[part_of]) < LINES ||
            percent(taken[part_of], branches[part_of]) < BRANCHES)) {
            printf "coverage: %s is below the bounds\n", substr(part_of, 3)
            bad = 1
        }
    exit bad
}

# SPDX-License-Identifier: MIT
# study.csv without its times, and without the front, which follows from them: what every run of a study has the same.
{
    while (match($0, /"[^"]*"/)) { # a name has commas
        name = substr($0, RSTART + 1, RLENGTH - 2)
        gsub(/,/, ";", name)
        $0 = substr($0, 1, RSTART - 1) name substr($0, RSTART + RLENGTH)
    }
    count = split($0, cell, ",")
    line = ""
    for (i = 1; i <= count; ++i) {
        if (NR == 1) left_out[i] = cell[i] ~ /^(front|cpu \[s\]|wall \[s\]|start \[s\]|probes \[s\]|particle-steps\/s)$/
        if (!left_out[i]) line = line "," cell[i]
    }
    print line
}

# gnuplot plots.gp
# Draws plots.dat: blocks of time, error and key, the front first, then lines with a name of their own, then the others.
{{settings}}
if (!exists('before')) before = ''
if (!exists('after')) after = ''

set encoding utf8
set datafile separator "\t"
set format '%g'
set grid lt 1 lw 1 lc rgb '#dddddd'
set border 3
set tics nomirror
set key tmargin left vertical Left reverse noenhanced maxcols 1
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set ylabel 'error: '.judge noenhanced

# Lines without a name are thin and grey.
set linetype 99 lc rgb '#bbbbbb'
colour(i) = i > named ? 99 : i
size(i) = i > named ? 0.5 : 1
width(i) = i > named ? 0.5 : 2

# By itself a range below a decade has one number or none: the narrower it is, the more there are in a decade.
steps(least, most) = most < 10 * least ? '1 1.5 2 3 4 5 7' : most < 1e4 * least ? '1 2 5' : '1'
stats 'plots.dat' using ($1 > 0 ? $1 : NaN) nooutput prefix 'TIME'
stats 'plots.dat' using 2 nooutput prefix 'ERROR'
if (pictures > 1) { stats 'plots.dat' using ($3 > 0 ? $3 : NaN) nooutput prefix 'ALONG' }
if (target < ERROR_min) { ERROR_min = target }
if (target > ERROR_max) { ERROR_max = target }
set logscale xy
set autoscale fix
set ytics (1)
do for [d = -15:9] { do for [step in steps(ERROR_min, ERROR_max)] { set ytics add (real(step) * 10.0**d) } }
if (ERROR_min == ERROR_max) { set yrange [ERROR_min / 2:ERROR_min * 2] } # gnuplot finds no range for one number

do for [p = 1:pictures] {
    least = p == 1 ? TIME_min : ALONG_min
    most = p == 1 ? TIME_max : ALONG_max
    if (least == most) { set xrange [least / 2:most * 2] } else { set xrange [*:*]; set autoscale xfix }
    set xtics (1)
    do for [d = -15:9] { do for [step in steps(least, most)] { set xtics add (real(step) * 10.0**d) } }
    set xlabel (p == 1 ? 'CPU time of stepping [s]' : along) noenhanced
    do for [kind in 'svg png'] {
        if (kind eq 'svg') { set terminal svg size 600,480 dynamic enhanced font 'sans-serif,13' background 'white' }
        if (kind eq 'png') { set terminal pngcairo size 1140,840 enhanced font 'sans-serif,13' fontscale 1.1 }
        set output before.word('error_time error_along', p).'.'.kind.after
        if (p == 1) {
            plot for [i = 1:lines] 'plots.dat' index i using 1:2 with linespoints \
                    pt 7 ps size(i) lw width(i) lc colour(i) title columnheader(1), \
                'plots.dat' index 0 using 1:2 with steps lw 2 lc rgb '#222222' title 'front', \
                target with lines dt 2 lc rgb '#888888' title wanted
        } else {
            plot for [i = 1:lines] 'plots.dat' index i using 3:2 with linespoints \
                    pt 7 ps size(i) lw width(i) lc colour(i) title columnheader(3), \
                target with lines dt 2 lc rgb '#888888' title wanted
        }
        unset output
    }
}

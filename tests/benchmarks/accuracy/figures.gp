# SPDX-License-Identifier: BSD-3-Clause
# Draws what offmap_accuracy wrote: gnuplot -e "folder='...'" figures.gp
set terminal svg size 900,640 font "sans,13" background rgb "white"
set encoding utf8
set datafile separator "\t"
array method[3] = ["paper", "probabilistic", "aligned"]
array colour[3] = ["#7f7f7f", "#1f77b4", "#d62728"]
scanner(i) = i == 0 ? "181 x 181" : "VLP-16"

do for [i=0:1] {
    removal = sprintf("%s/removal-%d.tsv", folder, i)
    set output sprintf("%s/removal-%d.svg", folder, i)
    set multiplot title "Removal over the noise of heading and position, ".scanner(i)
    set grid ytics lc rgb "#dddddd"
    set lmargin 9
    set rmargin 3
    set xrange [-0.5:19.5]
    set size 1,0.46
    set origin 0,0.49
    set key bottom left
    set format x ""
    set ylabel "mapped removed [%]"
    set yrange [*:100]
    plot for [m=1:3] removal using 1:(column(1 + 2*m)) with linespoints pt 7 ps 0.5 lw 2 \
        lc rgb colour[m] title method[m]
    set size 1,0.5
    set origin 0,0
    unset key
    set xtics rotate by -60 font ",10"
    set ylabel "unmapped removed [%]"
    set yrange [0:*]
    plot for [m=1:3] removal using 1:(column(2 + 2*m)):xtic(2) with linespoints pt 7 ps 0.5 lw 2 \
        lc rgb colour[m] notitle
    unset multiplot
    reset
    set encoding utf8
    set datafile separator "\t"

    set output sprintf("%s/stand_off-%d.svg", folder, i)
    standoff = sprintf("%s/stand_off-%d.tsv", folder, i)
    set title "Points kept of objects before a wall, ".scanner(i)
    set key inside right bottom
    set grid ytics lc rgb "#dddddd"
    set logscale x
    set xtics norotate font ",12" (3, 5, 7, 10, 15, 20, 30, 50)
    set xrange [2.7:55]
    set xlabel "distance from the wall [cm]"
    set ylabel "points kept [%]"
    set yrange [*:100.5]
    plot for [m=1:3] standoff using 1:(column(1 + m)) with linespoints pt 7 ps 0.5 lw 2 \
        lc rgb colour[m] title method[m].", 1°, 3 cm", \
        for [m=1:3] standoff using 1:(column(4 + m)) with linespoints pt 6 ps 0.5 lw 2 dt 2 \
        lc rgb colour[m] title method[m].", all levels"
    reset
    set encoding utf8
    set datafile separator "\t"
}

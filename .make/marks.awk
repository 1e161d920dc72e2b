# marks.awk - write the table of marks and its page, and print the table. Each line of the input has eight fields, which
# are separated by tabs: exercise, student, mark, verdict, number of the picture or '-', what to look at, whose text is the
# same, and one more thing to look at. The lines are sorted by student.
#
#   awk -F '\t' -v csv=FILE -v page=FILE -v exercises='03_1 03_2' -f table.awk -f marks.awk

BEGIN {
    wanted = split(exercises, exercise, " ")
    printf "student" >csv
    for (e = 1; e <= wanted; e++)
        printf ",%s,%s,%s,%s", exercise[e], cell(exercise[e] " same as"), cell(exercise[e] " look at"), cell(exercise[e] " remark") >csv
    print "" >csv
    print "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Marks</title>" >page
    print "<style>body{font-family:sans-serif}table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.4em;vertical-align:top;text-align:left}img{width:20em;display:block}.wrong{background:#fdd}</style>" >page
    print "<table><tr><th>student<th>exercise<th>mark<th>same as<th>look at<th>handed in<th>right" >page
}

# Add to the text of a cell. A student may hand in several files for an exercise.
function add(cells, key, text, between)
{
    cells[key] = cells[key] (cells[key] == "" || text == "" ? "" : between) text
}

{
    if (!($2 in seen)) {
        seen[$2]
        student[++students] = $2
    }
    key = $2 SUBSEP $1
    add(mark, key, $3, " ")
    look = $6 ($6 != "" && $8 != "" ? " | " : "") $8
    add(same, key, $7, " | ")
    add(flags, key, look, " | ")
    add(remark, key, $4, " | ")
    total[$3]++
    alike += $7 != ""
    flagged += look != ""
    pictures = $5 == "-" ? "<td><td>" : sprintf("<td><img src=\"%d.png\" alt=\"handed in\"><td><img src=\"%d.right.png\" alt=\"right\">", $5, $5)
    printf "<tr class=\"%s\"><td>%s<td>%s<td>%s: %s<td>%s<td>%s%s\n", $3, html($2), $1, $3, html($4), html($7), html(look), pictures >page
}

END {
    for (s = 1; s <= students; s++) {
        printf "%s", cell(student[s]) >csv
        text = ""
        for (e = 1; e <= wanted; e++) {
            key = student[s] SUBSEP exercise[e]
            m = key in mark ? mark[key] : "missing"
            printf ",%s,%s,%s,%s", m, cell(same[key]), cell(flags[key]), cell(remark[key]) >csv
            text = text sprintf("  %-8s", m)
        }
        print "" >csv
        printf "%-24s%s\n", student[s], text
    }
    printf "%d students; answers: %d right, %d wrong; %d almost the same as another, %d to look at\n", students, total["right"], total["wrong"], alike, flagged
}

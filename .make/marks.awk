# marks.awk - write the table of marks and its page, and print the table. Each line of the input has seven fields, which
# are separated by tabs: exercise, student, mark, verdict, number of the picture or '-', checksum of the text, file. The
# lines are sorted by student.
#
#   awk -F '\t' -v csv=FILE -v page=FILE -v exercises='03_1 03_2' -f table.awk -f marks.awk

{ line[NR] = $0 }
!(($1, $6, $2) in had) {
    had[$1, $6, $2]
    who[$1, $6] = who[$1, $6] (who[$1, $6] == "" ? "" : ", ") $2
    count[$1, $6]++
}
END {
    wanted = split(exercises, exercise, " ")
    printf "student" >csv
    for (e = 1; e <= wanted; e++)
        printf ",%s,%s", exercise[e], cell(exercise[e] " remark") >csv
    print "" >csv
    print "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Marks</title>" >page
    print "<style>body{font-family:sans-serif}table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.4em;vertical-align:top;text-align:left}img{width:20em;display:block}.wrong{background:#fdd}.copied{background:#ffd}</style>" >page
    print "<table><tr><th>student<th>exercise<th>mark<th>handed in<th>right" >page
    for (i = 1; i <= NR; i++) {
        split(line[i], f, "\t")
        if (count[f[1], f[6]] > 1 && f[3] != "copied") {
            f[3] = "copied"
            f[4] = "the same text: " who[f[1], f[6]] "; " f[4]
        }
        if (!(f[2] in seen)) {
            seen[f[2]] = 1
            student[++students] = f[2]
        }
        twice = (f[2], f[1]) in mark
        mark[f[2], f[1]] = twice ? mark[f[2], f[1]] " " f[3] : f[3]
        remark[f[2], f[1]] = (twice ? remark[f[2], f[1]] " | " : "") f[4]
        total[f[3]]++
        pictures = f[5] == "-" ? "<td><td>" : sprintf("<td><img src=\"%d.png\" alt=\"handed in\"><td><img src=\"%d.right.png\" alt=\"right\">", f[5], f[5])
        printf "<tr class=\"%s\"><td>%s<td>%s<td>%s: %s%s\n", f[3], html(f[2]), f[1], f[3], html(f[4]), pictures >page
    }
    for (s = 1; s <= students; s++) {
        printf "%s", cell(student[s]) >csv
        text = ""
        for (e = 1; e <= wanted; e++) {
            key = student[s] SUBSEP exercise[e]
            m = key in mark ? mark[key] : "missing"
            printf ",%s,%s", m, cell(remark[key]) >csv
            text = text sprintf("  %-8s", m)
        }
        print "" >csv
        printf "%-24s%s\n", student[s], text
    }
    printf "%d students; answers: %d right, %d wrong, %d copied\n", students, total["right"], total["wrong"], total["copied"]
}

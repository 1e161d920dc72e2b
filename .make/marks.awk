# marks.awk - write the table of `make marks` and its page, and print the marks. summary.awk and feedback.awk read the same
# lines after it. Their fields, separated by tabs, are: 1 exercise, 2 student, 3 mark, 4 verdict, 5 number of the picture
# or '-', 6 that of its difference or '-', 7 results, a + or - for each comparison, 8 what to look at, 9 whose text is the
# same, 10 one more thing to look at. The lines are sorted by student. Those without a student come first: they have the
# results of the unsolved exercises, and as verdict the names of the comparisons, separated by |.
#
#   awk -F '\t' -v csv=FILE -v page=FILE -v exercises='03_1 03_2' -v weights='03_1=5' -v style='excel' -v list=FILE \
#       -v unknown=FILE -f table.awk -f marks.awk
#
# weights gives the points of a right answer, by default 1. list is an output of list.awk, or empty; unknown receives the
# students who are not in it. Each word of style is one of comma, semicolon, tab, which separate the cells, and excel,
# which stands for what Excel expects: semicolons, decimal commas, a byte order mark, and line ends of Windows.

function row(text)
{
    printf "%s%s", text, excel ? "\r\n" : "\n" >csv
}

# Points, as the style asks for them.
function number(value,    text)
{
    text = points(value)
    if (excel && separator == ";")
        sub(/[.]/, ",", text)
    return text
}

# The number of a student's line in the list, or 0. The names of Moodle's folders are those of the students, followed by
# _ and a number.
function listed(name,    key)
{
    key = tolower(name)
    if (!(key in line_of))
        sub(/_[0-9]+(_.*)?$/, "", key)
    return key in line_of ? line_of[key] : 0
}

function read_list(    line, i, n, part)
{
    getline identifier <list
    while ((getline line <list) > 0) {
        n = split(line, part, "\t")
        id[++lines] = part[1]
        name_of[lines] = part[2]
        for (i = 3; i <= n; i++)
            if (!(part[i] in line_of))
                line_of[part[i]] = lines
            else if (line_of[part[i]] != lines)
                line_of[part[i]] = 0 # several students
    }
}

function held(results)
{
    return gsub(/[+]/, "", results)
}

BEGIN {
    separator = style ~ /semicolon/ ? ";" : style ~ /tab/ ? "\t" : style ~ /comma/ || style !~ /excel/ ? "," : ";"
    excel = style ~ /excel/
    if (list != "")
        read_list()
    wanted = split(exercises, exercise, " ")
    titles = "student" (list == "" ? "" : separator cell(identifier)) separator "points"
    for (e = 1; e <= wanted; e++) {
        full[exercise[e]] = 1
        titles = titles separator exercise[e]
        for (i = 1; i <= split("points,same as,look at,remark", title, ","); i++)
            titles = titles separator cell(exercise[e] " " title[i])
    }
    for (i = split(weights, weight, " "); i > 0; i--) {
        split(weight[i], part, "=")
        full[part[1]] = part[2]
    }
    printf "%s", excel ? "\357\273\277" : "" >csv
    row(titles)
    print "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Marks</title>" >page
    print "<style>body{font-family:sans-serif}table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.4em;vertical-align:top;text-align:left}img{width:20em;display:block}.wrong{background:#fdd}</style>" >page
    print "<table><tr><th>student<th>exercise<th>mark<th>points<th>same as<th>look at<th>handed in<th>right<th>difference" >page
}

# Add to the text of a cell. A student may hand in several files for an exercise.
function add(cells, key, text, between)
{
    cells[key] = cells[key] (cells[key] == "" || text == "" ? "" : between) text
}

function picture(file, words)
{
    return "<td>" (file ~ /^-/ ? "" : sprintf("<img src=\"%s.png\" alt=\"%s\">", file, words))
}

$2 == "" {
    given[$1] = held($7)
    compared[$1] = split($4, part, "|")
    for (i = 1; i <= compared[$1]; i++)
        comparison[$1, i] = part[i]
    next
}

# A wrong answer earns points if more comparisons hold than for the unsolved exercise.
{
    gained = held($7) - given[$1]
    earned = full[$1] * ($3 == "right" ? 1 : gained > 0 ? gained / (compared[$1] - given[$1]) : 0)
    look = $8 ($8 != "" && $10 != "" ? " | " : "") $10
}

{
    if (!($2 in seen)) {
        seen[$2]
        student[++students] = $2
    }
    key = $2 SUBSEP $1
    add(mark, key, $3, " ")
    add(same, key, $9, " | ")
    add(flags, key, look, " | ")
    add(remark, key, $4, " | ")
    if (!(key in best) || earned > best[key])
        best[key] = earned
    total[$3]++
    alike += $9 != ""
    flagged += look != ""
    printf "<tr class=\"%s\"><td>%s<td>%s<td>%s: %s<td>%s of %s<td>%s<td>%s%s%s%s\n", $3, html($2), $1, $3, html($4), points(earned), points(full[$1]), html($9), html(look), \
        picture($5, "handed in"), picture($5 ".right", "right"), picture($6 ".difference", "difference") >page
}

# Write the row of a student, who may have handed in nothing. Learning platforms read "-" as "no grade".
function write_student(name, identity,    e, key, m, sum, line, text)
{
    for (e = 1; e <= wanted; e++) {
        key = name SUBSEP exercise[e]
        m = key in mark ? mark[key] : "missing"
        sum += best[key]
        line = line separator m separator (key in mark ? number(best[key]) : "-") separator cell(same[key]) separator cell(flags[key]) separator cell(remark[key])
        text = text sprintf("  %-8s", m)
    }
    row(cell(name) (list == "" ? "" : separator cell(identity)) separator number(sum) line)
    printf "%-24s%s  %s\n", name, text, points(sum)
}

# An identifier must be neither empty nor that of somebody else: Moodle may give the points to the student in the row
# above. It refuses the name of a folder, and prints it.
END {
    for (s = 1; s <= students; s++) {
        at = list == "" ? 0 : listed(student[s])
        if (list != "" && (!at || at in found))
            print student[s] >unknown
        write_student(student[s], at && !(at in found) ? id[at] : student[s])
        found[at]
    }
    for (s = 1; s <= lines; s++)
        if (!(s in found)) {
            absent++
            write_student(name_of[s], id[s])
        }
    printf "%d students; answers: %d right, %d wrong; %d almost the same as another, %d to look at\n", students + absent, total["right"], total["wrong"], alike, flagged
}

# list.awk - read a list of students, a CSV file with a title above each column. The first line of the output is the title
# of the column that identifies a student: the one that the environment variable `wanted` names, or else the first whose
# title speaks of mail, or else of a number or an ID. Without such a column, the only line is a tab and all titles. Each
# further line has the fields identifier, name, and all texts by which the student may be known, in lower case: each cell,
# and the first two other columns together, in both orders. Fields are separated by tabs. table.awk defines fields().

function signs(sign)
{
    return split($0, part, sign)
}

BEGIN { wanted = tolower(ENVIRON["wanted"]) }
{ sub(/\r$/, "") }
NR == 1 {
    if (substr($0, 1, 3) == "\357\273\277")
        $0 = substr($0, 4)
    separator = ","
    if (signs(";") > signs(separator))
        separator = ";"
    if (signs("\t") > signs(separator))
        separator = "\t"
}
# A cell in quotes may contain line breaks.
{
    whole = open ? whole " " $0 : $0
    quotes = whole
    open = gsub(/"/, "", quotes) % 2
    if (open || whole == "")
        next
    columns = fields(whole, separator, cell_of)
}
!titled {
    titled = 1
    for (i = columns; i > 0; i--) {
        title = tolower(cell_of[i])
        if (wanted != "" ? title == wanted : title ~ /mail/)
            by = i
        else if (wanted == "" && title ~ /(^|[^a-z])(id|number|num|nr|no)([^a-z]|$)|num[^ ]*ro|matri/)
            second = i
        titles = cell_of[i] (titles == "" ? "" : ", ") titles
    }
    if (!by)
        by = second
    print by ? cell_of[by] : "\t" titles
    if (!by)
        exit
    next
}
{
    line = ""
    n = 0
    for (i = 1; i <= columns; i++)
        if (cell_of[i] != "") {
            line = line "\t" tolower(cell_of[i])
            if (i != by && n < 2)
                other[++n] = cell_of[i]
        }
    name = n ? other[1] : cell_of[by]
    if (n == 2) {
        name = name " " other[2]
        line = line "\t" tolower(name "\t" other[2] " " other[1] "\t" other[2] ", " other[1])
    }
    print cell_of[by] "\t" name line
}

# likeness.awk - find the answers of a class that have almost the same text, whatever their names. Each text of the input
# begins with \001 and a line of three fields, which are separated by tabs: what it is ("course", "chapter", "solution" or
# "answer"), its exercise, and for an answer its student. A chapter is the unsolved exercise; its last field is what is
# said of an answer that is no more than that, such as "the chapter, unchanged". For each answer, prints a line of two
# fields: whose text is the same ("the published solution" and the other students, or nothing), and what is said of it.
#
# An answer that includes a published solution is the same as that, whatever else it contains.
#
# A text is its set of windows, rows of SIZE tokens without comments and blanks. A name that the text itself declares
# becomes its number within the window, so new names change nothing. Windows that occur anywhere in the course do not
# count, nor do, between students, those that many of them have: an exercise or a lecturer may have dictated these. A text
# with fewer than LEAST windows is like no other, because honest students who change one number, or a few, do so in the
# same way: a number alone is part of SIZE windows.

BEGIN {
    RS = "\001"
    SIZE = 8
    LEAST = 48
    SAME = 0.9 # of the windows of the text that has more
    MANY = 4 # students, and a quarter of those who hand in the exercise, may share a window that counts
    words("return else case in out inout const uniform flat precision highp mediump lowp struct static if for while")
}

# Words that may precede a name without declaring it.
function words(text,    list, i)
{
    for (i = split(text, list, " "); i > 0; i--)
        word[list[i]]
}

# Split a text into token[1] to token[tokens].
function scan(text,    line, lines, i, rest)
{
    lines = split(text, line, "\n")
    tokens = 0
    for (i = 1; i <= lines; i++)
        for (; line[i] != ""; line[i] = substr(line[i], 1001)) # removing tokens from a long line would take very long
            for (rest = substr(line[i], 1, 1000); rest != ""; rest = substr(rest, RLENGTH + 1)) {
                if (match(rest, /^[ \t\r\f\v]+/))
                    continue
                if (!match(rest, /^[A-Za-z_][A-Za-z_0-9]*/) && !match(rest, /^([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?[A-Za-z]*/))
                    RLENGTH = 1
                token[++tokens] = substr(rest, 1, RLENGTH)
            }
}

# Find the names that the text declares: a word after another one, such as a type, and those after a comma in the same
# declaration.
function find_declared(    i, t, before, list, depth)
{
    split("", declared)
    list = -1 # the depth of the declaration that is not at its end, or -1
    for (i = 1; i <= tokens; i++) {
        t = token[i]
        before = token[i - 1]
        depth += (t ~ /^[([{]$/) - (t ~ /^[])}]$/)
        if (t ~ /^[;{]$/ || depth < list)
            list = -1
        if (t !~ /^[A-Za-z_]/ || i == 1)
            continue
        if (before ~ /^[A-Za-z_]/ && !(before in word) && !(t in word)) {
            declared[t]
            list = depth
        } else if (before == "," && list == depth && token[i + 1] !~ /^[A-Za-z_]/)
            declared[t]
    }
}

# Some tokens as one text.
function window(first, size,    i, t, names, number, text)
{
    for (i = first; i < first + size; i++) {
        t = token[i]
        if (t in declared && token[i - 1] != ".") {
            if (!(t in number))
                number[t] = ++names
            t = "$" number[t]
        }
        text = text " " t
    }
    return text
}

NR == 1 { next } # before the first \001
{
    end = index($0, "\n")
    split(substr($0, 1, end - 1), field, "\t")
    text = substr($0, end + 1)
    gsub(/\/\*([^*]|\*+[^*\/])*\*+\/|\/\/[^\n]*/, " ", text)
    gsub(/\\\r?\n/, "", text)
    if (field[1] == "answer") {
        includes[answers + 1] = text ~ /(^|\n)[ \t]*#[ \t]*include[ \t]*"[^"\n]*solutions\//
        extends[answers + 1] = text ~ /(^|\n)[ \t]*#[ \t]*include[ \t]*"([^"\n]*\/)?[0-9][0-9]_[a-z][^"\n\/]*[.]frag"/
    }
    gsub(/(^|\n)[ \t]*#[ \t]*include[ \t]*"[^\n]*/, "\n", text)
    token[0] = ""
    scan(text)
    token[tokens + 1] = ""
    find_declared()
    if (field[1] == "chapter") {
        chapter[field[2]] = window(1, tokens)
        unchanged[field[2]] = field[3]
        next
    }
    for (i = 1; i + SIZE <= tokens + 1; i++) {
        part = window(i, SIZE)
        if (field[1] == "course")
            course[part]
        else if (!(part in course)) {
            if (field[1] == "solution")
                key = "solution" SUBSEP field[2]
            else
                key = answers + 1
            if (!((key, part) in has)) {
                has[key, part]
                own[key, ++count[key]] = part
                if (field[1] == "answer" && !((field[2], field[3], part) in counted)) {
                    counted[field[2], field[3], part]
                    sharing[field[2], part]++
                }
            }
        }
    }
    if (field[1] == "answer") {
        answers++
        exercise[answers] = field[2]
        student[answers] = field[3]
        whole[answers] = window(1, tokens)
        if (!((field[2], field[3]) in counted)) {
            counted[field[2], field[3]]
            class[field[2]]++
        }
    }
}

# True if both texts have enough windows, and almost all of them in common.
function same(a, b, of_a, of_b,    i, spare)
{
    if (of_a < of_b)
        return same(b, a, of_b, of_a)
    spare = (1 - SAME) * of_a # windows of the longer text that the other one may lack
    if (of_b < LEAST)
        return 0
    for (i = 1; i <= of_a && spare >= 0; i++)
        spare -= !((b, own[a, i]) in has)
    return spare >= 0
}

END {
    for (a = 1; a <= answers; a++) {
        solution = "solution" SUBSEP exercise[a]
        published[a] = includes[a] || same(a, solution, count[a], count[solution])
    }
    # The windows that many students have are left out.
    for (a = 1; a <= answers; a++) {
        kept = 0
        for (i = 1; i <= count[a]; i++) {
            n = sharing[exercise[a], own[a, i]]
            if (n <= MANY || n <= class[exercise[a]] / 4)
                own[a, ++kept] = own[a, i]
        }
        count[a] = kept
    }
    for (a = 1; a <= answers; a++) {
        split("", named)
        like = published[a] ? "the published solution" : ""
        for (b = 1; b <= answers; b++)
            if (exercise[a] == exercise[b] && student[a] != student[b] && !(student[b] in named) && !(published[a] && published[b]) && same(a, b, count[a], count[b])) {
                named[student[b]]
                like = like (like == "" ? "" : ", ") student[b]
            }
        print like "\t" (whole[a] != "" && whole[a] == chapter[exercise[a]] || whole[a] == "" && extends[a] && !includes[a] ? unchanged[exercise[a]] : "")
    }
}

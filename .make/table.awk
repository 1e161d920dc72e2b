# table.awk - text in the tables that scripts write for other programs, or read.

# A cell of a CSV file. A spreadsheet must not take it for a formula, and it looks behind blanks. PHP's reader, which
# Moodle uses, takes \" for a quote within the cell, so no backslash comes directly before a quote.
function cell(text)
{
    gsub(/[[:cntrl:]]/, " ", text)
    if (text ~ /^ *([-=+@]|＝|＋|－|＠)/)
        text = "'" text
    gsub(/\\"/, "\\ \"", text)
    sub(/\\$/, "\\ ", text)
    gsub(/"/, "\"\"", text)
    return "\"" text "\""
}

# Split a line of a CSV file into list[1] to list[n], and return n. Control characters become blanks.
function fields(line, separator, list,    n, i, c, quoted)
{
    n = 1
    list[1] = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        if (c == "\"" && quoted && substr(line, i + 1, 1) == "\"") {
            list[n] = list[n] c
            i++
        } else if (c == "\"")
            quoted = !quoted
        else if (c == separator && !quoted)
            list[++n] = ""
        else
            list[n] = list[n] (c ~ /[[:cntrl:]]/ ? " " : c)
    }
    for (i = 1; i <= n; i++)
        gsub(/^ +| +$/, "", list[i])
    return n
}

# Points, with at most two decimals.
function points(number,    text)
{
    text = sprintf("%.2f", number)
    sub(/[.]?0+$/, "", text)
    return text
}

# Text in HTML or XML.
function html(text)
{
    gsub(/[[:cntrl:]]/, " ", text)
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

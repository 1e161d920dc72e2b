# table.awk - text in the tables that scripts write for other programs.

# A cell of a CSV file. A spreadsheet must not take it for a formula, and it looks behind blanks.
function cell(text)
{
    gsub(/[[:cntrl:]]/, " ", text)
    if (text ~ /^ *([-=+@]|＝|＋|－|＠)/)
        text = "'" text
    gsub(/"/, "\"\"", text)
    return "\"" text "\""
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

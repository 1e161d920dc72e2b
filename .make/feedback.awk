# feedback.awk - write a page for each student, folder/feedback/NAME.html, which contains the pictures of the folder and
# names nobody else.
#
#   awk -F '\t' -v folder=FOLDER ... -f table.awk -f marks.awk -f feedback.awk

# A name for a file on any system.
function file_name(student,    text, n, unique)
{
    text = student
    gsub(/[[:cntrl:]\/\\:*?"<>|]/, "_", text)
    sub(/^[-. ]/, "_", text)
    sub(/[. ]+$/, "_", text)
    if (text == "" || length(text) > 200)
        text = "student"
    unique = text
    for (n = 2; tolower(unique) in taken; n++)
        unique = text " " n
    taken[tolower(unique)]
    return unique
}

function embed(file, words,    command, line)
{
    command = "base64 <'" folder "/" file ".png'"
    printf "<figure><img alt=\"\" src=\"data:image/png;base64," >feedback
    while ((command | getline line) > 0)
        printf "%s", line >feedback
    close(command)
    printf "\"><figcaption>%s</figcaption></figure>\n", words >feedback
}

function in_words(verdict)
{
    if (sub(/^does not run: /, "", verdict))
        return "Your file does not run. The first message is: <code>" html(verdict) "</code>"
    if (sub(/^does not compile: /, "", verdict))
        return "Your program does not compile. The first message is: <code>" html(verdict) "</code>"
    if (sub(/^does not end: /, "", verdict))
        return "Your file takes too long: " html(verdict) ". Perhaps a loop never ends."
    if (verdict ~ /of the pixels differ/ && verdict !~ /^matches/)
        return "Your picture differs from the solution's: " html(verdict) "."
    return html(toupper(substr(verdict, 1, 1)) substr(verdict, 2)) "."
}

$2 != named {
    if (feedback != "")
        close(feedback)
    named = $2
    feedback = folder "/feedback/" file_name($2) ".html"
    print "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>" html($2) "</title>" >feedback
    print "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}figure{display:inline-block;vertical-align:top;width:28em;max-width:100%;margin:.5em}img{width:100%}figcaption{color:#555}.fails{font-weight:bold}</style>" >feedback
    print "<h1>" html($2) "</h1>" >feedback
}
{
    printf "<h2>Exercise %s: %s, %s of %s points</h2>\n<p>%s</p>\n", $1, $3, points(earned), points(full[$1]), in_words($4) >feedback
    if ($3 == "wrong" && $7 ~ /[+]/) {
        print "<p>Compared with the solution:</p><ul>" >feedback
        for (i = 1; i <= compared[$1]; i++)
            print (substr($7, i, 1) == "+" ? "<li>right: " : "<li class=\"fails\">wrong: ") html(comparison[$1, i]) >feedback
        print "</ul>" >feedback
    }
    if ($5 != "-")
        embed($5, "your picture")
    if ($6 != "-")
        embed($6 ".difference", "The difference: grey where your picture is right, lighter where it is too light, darker where it is too dark.")
}

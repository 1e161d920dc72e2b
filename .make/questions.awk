# questions.awk - convert the questions of docs/questions.txt for a learning platform, with -v form=gift or -v form=xml
# (Moodle's XML); table.awk defines html(), and bom is a byte order mark. On the command line, the pages of the chapters precede the questions, because their titles name the
# categories. Fails if a question is malformed.

function fail(why) {
    printf "make: %s:%d: %s\n", FILENAME, FNR, why > "/dev/stderr"
    failed = 1
    exit 1
}

function gift(text) {
    gsub(/[[:cntrl:]]/, " ", text)
    gsub(/[\\~=#{}:]/, "\\\\&", text)
    return text
}

function category() {
    split(id, part, ".")
    if (part[1] "" == chapter "")
        return
    if (!(part[1] in title))
        fail("chapter " part[1] " has no page")
    chapter = part[1]
    if (form == "gift")
        printf "$CATEGORY: $course$/Ray marching/%s\n\n", title[chapter]
    else
        printf "<question type=\"category\"><category><text>$course$/Ray marching/%s</text></category></question>\n", html(title[chapter])
}

function question(    i) {
    if (id == "")
        return
    if (right != 1 || count < 3)
        fail("question " id " needs exactly one right answer and at least two wrong ones")
    category()
    if (form == "gift") {
        printf "::%s::[plain]%s {\n", id, gift(words)
        for (i = 1; i <= count; i++)
            printf "%s%s#%s\n", (mark[i] == "+" ? "=" : "~"), gift(answer[i]), gift(why[i])
        print "}\n"
    } else {
        printf "<question type=\"multichoice\"><name><text>%s</text></name>\n", id
        printf "<questiontext format=\"plain_text\"><text>%s</text></questiontext>\n", html(words)
        print "<defaultgrade>1</defaultgrade><single>true</single><shuffleanswers>true</shuffleanswers><answernumbering>abc</answernumbering>"
        for (i = 1; i <= count; i++)
            printf "<answer fraction=\"%d\" format=\"plain_text\"><text>%s</text><feedback format=\"plain_text\"><text>%s</text></feedback></answer>\n",
                (mark[i] == "+" ? 100 : 0), html(answer[i]), html(why[i])
        print "</question>"
    }
}

BEGIN {
    if (form == "xml")
        print "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>"
}
FNR == 1 && index($0, bom) == 1 { $0 = substr($0, length(bom) + 1) } # some editors for Windows begin with it
{ sub(/\r$/, "") }
FILENAME ~ /[.]md$/ { if (FNR == 1) title[substr($2, 1, 2)] = substr($0, 3); next }
/^#( |$)/ || /^$/ { next }
/^## / {
    question()
    id = $2
    words = substr($0, length($2) + 5)
    count = right = 0
    if (id !~ /^[0-9][0-9]\.[0-9]+$/ || words == "" || id in seen)
        fail("a question begins with ## CHAPTER.NUMBER and its text, as in ## 03.1 Why?, and each number occurs once")
    seen[id] = 1
    next
}
/^[+-] ./ && id != "" {
    mark[++count] = substr($0, 1, 1)
    at = index($0, " // ")
    answer[count] = at ? substr($0, 3, at - 3) : substr($0, 3)
    why[count] = at ? substr($0, at + 4) : "That is right."
    right += mark[count] == "+"
    if ((mark[count] == "+") == (at > 0))
        fail("a wrong answer needs a reason after //; the right answer must have none")
    next
}
{ fail("this is neither a question (##), nor an answer (+ or -), nor a comment (#)") }
END {
    if (!failed)
        question()
    if (failed)
        exit 1
    if (form == "xml")
        print "</quiz>"
}

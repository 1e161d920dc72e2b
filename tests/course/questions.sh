#!/bin/bash
# questions.sh - tests docs/questions.txt: five questions for each chapter, whose right answers cannot be guessed from
# their position or length. It also reads back the files that `make questions` writes, with parsers of GIFT and of XML.
# shellcheck disable=SC2154,SC2016 # open_scratch sets scratch; the dollar signs are awk's or GIFT's
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch

check_empty() { # NAME FILE
    check "$1" [ ! -s "$2" ] || sed 's/^/# /' "$2"
}

# ---- The source ----

# Write a line for each question: its number, the number of its answers, and the positions of the right answer and of
# the longest answer.
awk '
    function done() { if (id != "") print id, n, right, longest; n = right = most = 0 }
    /^## / { done(); id = $2 }
    /^[+-] / {
        text = $0; sub(/ \/\/ .*/, "", text)
        n++
        if (/^[+]/) right = n
        if (length(text) > most) { most = length(text); longest = n }
    }
    END { done() }' docs/questions.txt >"$scratch/list"
for page in docs/[0-9][0-9]_*.md; do
    chapter=$(basename "$page" | cut -c 1-2)
    printf '%s.%d\n' "$chapter" 1 "$chapter" 2 "$chapter" 3 "$chapter" 4 "$chapter" 5
done >"$scratch/wanted"
cut -d ' ' -f 1 "$scratch/list" | diff - "$scratch/wanted" >"$scratch/difference"
check_empty 'each chapter has its five questions, in order' "$scratch/difference"
at_most_half() { awk "$1 { n++ } END { exit !(n <= NR / 2) }" "$scratch/list"; }
for place in 1 2 3; do
    check "the right answer is at position $place in at most half of the questions" at_most_half "\$3 == $place"
done
check 'the right answer is the longest one in at most half of the questions' at_most_half '$3 == $4'

# ---- What is written ----

# Print the contents of a question file, one item per line. Each line begins with the word question, right, wrong or
# why.
said_by_source() { # FILE
    awk -F ' // ' '
        /^## / { print "question", substr($0, 4) }
        /^[+] / { print "right", substr($0, 3); print "why That is right." }
        /^- / { print "wrong", substr($1, 3); print "why", $2 }' "$1"
}

# Print the contents of a GIFT file, read character by character: after a backslash, a character has no special meaning.
said_by_gift() { # FILE
    awk '
        function say(kind) { gsub(/^[ \n]+|[ \n]+$/, "", text); print kind, text; text = "" }
        /^\$CATEGORY: / || /^$/ { next }
        {
            line = $0 "\n"
            for (i = 1; i <= length(line); i++) {
                c = substr(line, i, 1)
                if (c == "\\") { i++; text = text substr(line, i, 1) }
                else if (inside && c ~ /[=~}]/) { if (answers++) say("why"); kind = c == "=" ? "right" : "wrong"; if (c == "}") inside = 0 }
                else if (inside && c == "#") say(kind)
                else if (substr(line, i, 2) == "::" && !inside) { i++; if (named++ % 2) { name = text; text = "" } }
                else if (c == "{") { sub(/^\[plain\]/, "", text); text = name " " text; say("question"); inside = 1; answers = 0 }
                else text = text c
            }
        }' "$1"
}

# Print the contents of an XML file, read tag by tag. The opened tags must be closed in reverse order.
said_by_xml() { # FILE
    awk 'BEGIN { RS = "<" }
        NR == 1 || /^\?/ { next }
        {
            at = index($0, ">"); tag = substr($0, 1, at - 1); text = substr($0, at + 1)
            name = tag; sub(/[ \/].*/, "", name)
            if (tag ~ /^\//) {
                if (substr(tag, 2) != open[depth]) { print "not closed: " open[depth]; exit }
                depth--
                next
            }
            open[++depth] = name
            if (name == "question") { kind = tag; names = 0 }
            if (name == "answer") answer = tag ~ /fraction="100"/ ? "right" : "wrong"
            if (name != "text" || kind ~ /category/) next
            gsub(/&lt;/, "<", text); gsub(/&gt;/, ">", text); gsub(/&amp;/, "\\&", text)
            parent = open[depth - 1]
            if (parent == "name") number = text
            else if (parent == "questiontext") print "question", number, text
            else print (parent == "answer" ? answer : "why"), text
        }
        END { if (depth) print "not closed: " open[depth] }' "$1"
}

writes() { # SOURCE
    QUESTIONS=$1 QUESTIONS_FOLDER=$scratch/written .make/questions.sh >"$scratch/said" 2>&1
}
reads_back() { # SOURCE FORM
    "said_by_$2" "$scratch/written/ray-marching.$2" | diff "$scratch/source" - >"$scratch/difference" && return
    head -n 6 "$scratch/difference" | sed 's/^/# /'
    return 1
}

check 'make questions writes two files' writes docs/questions.txt
said_by_source docs/questions.txt >"$scratch/source"
check 'the source has 110 questions or more' [ "$(grep -c '^question' "$scratch/source")" -ge 110 ]
check 'the GIFT file has the contents of the source' reads_back docs/questions.txt gift
check "Moodle's XML file has the contents of the source" reads_back docs/questions.txt xml
categories() { [ "$(grep -c "$1" "$scratch/written/ray-marching.$2")" = "$(find docs -name '[0-9][0-9]_*.md' | wc -l)" ]; }
check 'the GIFT file has a category for each chapter' categories '^\$CATEGORY: \$course\$/Ray marching/[0-9][0-9] ' gift
check 'the XML file has a category for each chapter' categories 'type="category">.*Ray marching/[0-9][0-9] ' xml

# Characters with a special meaning in GIFT, in XML or in awk.
cat >"$scratch/signs.txt" <<'END'
## 00.1 Is {a} = b ~ c::c & d < e > f \g # h: "i"?
+ 2 ~ 1: {=} \ & <b>
- a::b & \& // &amp; #1 is ~ {x}
- c // d
END
check 'special characters are written' writes "$scratch/signs.txt"
said_by_source "$scratch/signs.txt" >"$scratch/source"
check 'special characters are read back from GIFT' reads_back "$scratch/signs.txt" gift
check 'special characters are read back from XML' reads_back "$scratch/signs.txt" xml

# A file that is refused leaves the last good files as they are, and nothing beside them.
refuses() { # NAME WORDS TEXT
    printf '%b' "$3" >"$scratch/bad.txt"
    check "a file of questions is refused for $1, and the last good files stay" eval "! writes '$scratch/bad.txt' && grep -q -e '$2' '$scratch/said' && [ \"\$(wc -l <'$scratch/said')\" = 1 ] && diff -r '$scratch/good' '$scratch/written'"
}
good='## 00.1 a?\n+ b\n- c // d\n- e // f\n'
check 'a good question is accepted' eval "printf '$good' >'$scratch/good.txt' && writes '$scratch/good.txt' && cp -R '$scratch/written' '$scratch/good'"
by_windows() { # an editor for Windows begins with a byte order mark and ends lines with carriage returns
    { printf '\357\273\277' && sed "s/\$/$(printf '\r')/" "$scratch/good.txt"; } >"$scratch/windows.txt"
    writes "$scratch/windows.txt" && diff -r "$scratch/good" "$scratch/written"
}
check 'a file of questions from an editor for Windows is accepted' by_windows
refuses 'no right answer' '00.1 needs exactly one right' "${good/+ b/- b // c}"
refuses 'a wrong answer without a reason' 'bad.txt:3: a wrong answer needs a reason' "${good/ \/\/ d/}"
refuses 'a reason for the right answer' 'bad.txt:2: .* the right answer must have none' "${good/+ b/+ b // c}"
refuses 'only one wrong answer' '00.1 needs' "${good/- e \/\/ f\\n/}"
refuses 'a number that occurs twice' 'bad.txt:5: .* each number occurs once' "$good$good"
refuses 'a chapter that does not exist' 'chapter 77 has no page' "${good/00.1/77.1}"
refuses 'a line of an unknown kind' 'bad.txt:5: this is neither' "${good}so\n"
absent() { ! writes "$scratch/absent.txt" && grep -q "no such file" "$scratch/said"; }
check 'a missing file of questions is refused' absent
plan

# words.awk - print four numbers for a chapter's page: the words of its story (everything before its parameters,
# experiments or exercises, whichever come first), those of its proofs, the minutes that a reader of the story spends on
# other things than words, and the number of the story's words above its first figure that can be dragged (-1 if there
# is none). The minutes are one for each figure, each question and each thing to try, and a half for each displayed
# formula and each listing. Words are counted in prose only: not in listings, tables, pictures, captions, comments or
# folds, and not in the French summary. A formula inside a sentence counts as one word, a displayed formula as none.

# A line without its formulas: x replaces each one that begins inside a sentence. sign is the sign that ends the formula
# in which the line begins, or "".
function without_formulas(line,    text, at)
{
    gsub(/`[^`]*[$][^`]*`/, "x", line)
    while (match(line, /[$][$]?/)) {
        at = substr(line, RSTART, RLENGTH)
        if (sign == "") {
            text = text substr(line, 1, RSTART - 1) (at == "$" ? "x" : "")
            sign = at
        } else if (at == sign)
            sign = ""
        line = substr(line, RSTART + RLENGTH)
    }
    return sign == "" ? text line : text
}

BEGIN { dragged = -1 }
part == "" && !folded && (/^make run FIGURE/ || /^[*]Predict[.][*]/ || /^[*][*]Try it[.][*][*]/) { extra += 1 }
part == "" && !folded && !fenced && (/^[$][$]/ || /^<!-- code:/) { extra += 0.5 }
part == "" && dragged < 0 && (/^make run FIGURE/ || /^!.*-figure-/) { dragged = words["story"] + 0 }
/^ *```/ { fenced = !fenced; next }
fenced || /^<!--/ || /^([|]|>|!\[|[*][*]Time[.][*][*])/ || /^[*][^*].*[^*][*]$/ { next }
/^<details>/ { folded = 1 }
/^<\/details>/ { folded = 0; next }
folded { next }
/^## (Parameters|Experiments|Exercises)/ { part = "rest" }
/^## / && part != "" { part = $2 == "Proofs" ? "proofs" : "rest" }
{
    $0 = without_formulas($0)
    words[part == "" ? "story" : part] += NF
}
END { print words["story"] + 0, words["proofs"] + 0, extra + 0, dragged }

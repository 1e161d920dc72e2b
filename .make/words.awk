# words.awk - print the number of words in the story of a chapter's page (everything before its parameters, experiments
# or exercises, whichever come first) and in its proofs. Only prose is counted: no listings, tables, pictures, comments
# or folds, and not the French summary.

/^ *```/ { fenced = !fenced; next }
fenced || /^<!--/ || /^(\||>|!\[|\*\*Time\.\*\*)/ { next }
/^<details>/ { folded = 1 }
/^<\/details>/ { folded = 0; next }
folded { next }
/^## (Parameters|Experiments|Exercises)/ { part = "rest" }
/^## / && part != "" { part = $2 == "Proofs" ? "proofs" : "rest" }
{ words[part == "" ? "story" : part] += NF }
END { print words["story"] + 0, words["proofs"] + 0 }

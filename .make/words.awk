# words.awk - how long a chapter's page is to read: prints the words of its story (all in front of
# its parameters or, where it has none, of its experiments) and those of its proofs. Counted is prose: no listing, table, picture or comment, nothing
# folded, and not the summary in French.

/^ *```/ { fenced = !fenced; next }
fenced || /^<!--/ || /^(\||>|!\[|\*\*Time\.\*\*)/ { next }
/^<details>/ { folded = 1 }
/^<\/details>/ { folded = 0; next }
folded { next }
/^## (Parameters|Experiments|Exercises)/ { part = "rest" }
/^## / && part != "" { part = $2 == "Proofs" ? "proofs" : "rest" }
{ words[part == "" ? "story" : part] += NF }
END { print words["story"] + 0, words["proofs"] + 0 }

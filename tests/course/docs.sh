#!/bin/bash
# docs.sh [PAGE...] - tests that all pages, or those given, agree with the project: their listings, links, pictures,
# parameters, commands and solutions exist and match the sources. Without arguments, it also tests that each check finds
# a mistake, and how the tool that writes the listings fails.
# shellcheck disable=SC2016 # the backticks are Markdown's
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
shopt -s nullglob
pages=(README.md docs/*.md)
chapters=()
for source in chapters/[0-9][0-9]_*.c; do
    stem=${source#chapters/}
    chapters+=("${stem%.c}")
done

# judge NAME COMPLAINTS: the test passes if there are no complaints.
judge() {
    if [ -z "$2" ]; then ok "$1"; else not_ok "$1" "$(tr '\n' ';' <<<"$2")"; fi
}

# ---- What a page contains ----

# Print the prose of a page as lines 'LINE:text', without fenced blocks and, unless the second argument is 'code',
# without inline code.
prose_of() { # PAGE [code]
    awk -v keep="${2-}" '
        /^ *```/ { fenced = !fenced; next }
        fenced { next }
        { if (keep == "") gsub(/`[^`]*`/, ""); print FNR ":" $0 }' "$1"
}

# Print the fenced lines of a page, with each line that ends in \ joined to the next, and each piece of inline code on a
# separate line.
code_of() { # PAGE
    awk '
        /^ *```/ { fenced = !fenced; next }
        fenced && /\\$/ { sub(/\\$/, ""); printf "%s ", $0; next }
        fenced { print; next }
        { n = split($0, part, "`"); for (i = 2; i < n; i += 2) print part[i] }' "$1"
}

# Print the targets of a page's links and pictures as lines 'LINE:target', without those on other sites.
links_of() { # PAGE
    prose_of "$1" | awk '{
        line = $0; sub(/:.*/, "", line)
        text = $0
        while (match(text, /\]\([^)]*\)/)) {
            print line ":" substr(text, RSTART + 2, RLENGTH - 3)
            text = substr(text, RSTART + RLENGTH)
        }
        text = $0
        while (match(text, /(src|href)="[^"]*"/)) {
            target = substr(text, RSTART, RLENGTH); gsub(/^[a-z]*="|"$/, "", target)
            print line ":" target
            text = substr(text, RSTART + RLENGTH)
        }
    }' | grep -v -E '^[0-9]+:(https?|mailto):'
}

# Print the anchors that GitHub derives from a page's headings.
anchors_of() { # PAGE
    prose_of "$1" code | sed 's/^[0-9]*://' | awk '/^#+ / {
        sub(/^#+ +/, ""); sub(/ +$/, "")
        $0 = tolower($0)
        gsub(/[][!"#$%&\047()*+,.\/:;<=>?@\\^`{|}~]/, "")
        gsub(/ /, "-")
        print $0 (seen[$0]++ ? "-" (seen[$0] - 1) : "")
    }'
}

# True if a page has an anchor. The anchors of each page of the project are determined only once.
has_anchor() { # PAGE ANCHOR
    local kept=$scratch/anchors.${1//\//,}
    [[ $1 != "$scratch"* && -e $kept ]] || anchors_of "$1" >"$kept"
    grep -q -x -F -e "$2" "$kept"
}

# True if a shader or a file that it includes declares a uniform.
declares() { # FILE NAME
    local name
    [ -e "$1" ] || return 1
    grep -q "^uniform  *[a-z0-9]*  *$2;" "$1" || sed -n 's/^#include "\([^"]*\)".*/\1/p' "$1" | {
        while read -r name; do
            ! { declares "chapters/$name" "$2" || declares "shaders/$name" "$2"; } || exit 0
        done
        exit 1
    }
}

# True if a picture of a page has a point, or a parameter to which a link gives a value: #ball, #most=12. The picture is
# a figure, or the chapter's if the link gives a value; or, after an @, the one that the link names, #spread=0.1@above.
has_value() { # PAGE NAME[=VALUE[@PICTURE]]
    local picture stem what file asked=${2#*@} name=${2%%=*}
    [[ $2 == *@* ]] || asked='figure-[a-z_-]*'
    if [ "$asked" = chapter ] || [[ $2 == *=* && $2 != *@* ]]; then
        ! declares "chapters/$(basename "$1" .md).frag" "$name" || return 0
    fi
    grep -o "[0-9][0-9]_[a-z_]*-$asked\\.png" "$1" | sort -u | while read -r picture; do
        stem=${picture%%-*} what=${picture#*-}
        awk -v stem="$stem" -v what="${what%.png}" '$1 == stem && $2 == what { file = "chapters/" stem ".frag"; for (i = 3; i < NF; i++) if ($i == "-f") file = $(i + 1); print file }' tests/pictures/images.txt
    done | sort -u | while read -r file; do
        if [[ $2 == *@* ]]; then declares "$file" "$name" && echo found; else grep -q "^uniform  *[a-z0-9]*  *$name;" "$file" && echo found; fi
    done | grep -q found
}

# ---- Checks of a page: each function prints one line for each mistake ----

bad_links() { # PAGE
    local line target path file folder=.
    [[ $1 != */* ]] || folder=${1%/*}
    links_of "$1" | while IFS=: read -r line target; do
        path=${target%%#*}
        file=$1
        [ -z "$path" ] || file=$folder/$path
        if [ ! -e "$file" ]; then
            echo "$1:$line: $target does not exist"
        elif [[ $target == *#* && $file == *.md ]] && ! has_anchor "$file" "${target#*#}" && ! { [ -z "$path" ] && has_value "$1" "${target#*#}"; }; then
            echo "$1:$line: $target: no heading has this anchor, and no figure of the page has such a point or parameter"
        fi
    done
}

listed_pictures=" engine_5 $(awk '!/^#/ && NF >= 2 { printf "%s ", $1 ($2 == "-" ? "" : "-" $2) }' tests/pictures/images.txt)"

bad_pictures() { # PAGE
    local line target name
    grep -n '!\[\](' "$1" | sed "s|^|$1:|; s|\$|: the picture has no alternative text|"
    links_of "$1" | grep -E '\.(png|jpg|svg)(#|$)' | while IFS=: read -r line target; do
        name=${target##*/}
        [[ $target == *figures/*.svg ]] && [ -e "docs/figures/${name%.svg}.c" ] && continue
        [[ $target == *tests/references/*.png && $listed_pictures == *" ${name%.png} "* ]] ||
            echo "$1:$line: $target is neither in tests/pictures/images.txt nor drawn by a program of docs/figures/"
    done
}

# GitHub's Markdown removes the backslash of \, \; \! \: \{ \} \| \\ before the formula is read. Only a block that
# begins with ```math keeps these backslashes.
bad_formulas() { # PAGE
    prose_of "$1" | awk -v page="$1" '
        {
            line = $0; sub(/:.*/, "", line)
            text = $0; sub(/^[0-9]*:/, "", text)
            n = split(text, part, /\$\$?/)
            for (i = 1; i <= n; i++) {
                if (open && part[i] ~ /\\[,;!:{}|\\]|\\operatorname|\\newcommand|\\def[^a-z]/)
                    print page ":" line ": GitHub does not render this formula: " part[i]
                if (i < n)
                    open = !open
            }
        }
        END { if (open) print page ": a formula is not closed" }'
}

# A chapter's page has a summary in French, which is five lines long, below the heading L'essentiel.
bad_summary() { # PAGE
    awk '
        /^#+ L.essentiel *$/ { found = 1; next }
        found == 1 && NF && /^#/ { exit }
        found == 1 && NF { lines++ }
        found == 1 && !NF && lines { exit }
        END { if (lines != 5) print "the French summary has " lines + 0 " lines instead of 5" }' "$1"
}

unnamed_parameters() { # STEM
    "$BUILD/$1" --list | awk -v page="docs/$1.md" '
        NR == FNR { if (FNR > 1 && NF) name[$1]; next }
        { while (match($0, /[A-Za-z0-9_]+/)) { word[substr($0, RSTART, RLENGTH)]; $0 = substr($0, RSTART + RLENGTH) } }
        END { for (n in name) if (!(n in word)) print n " is not in " page }' - "docs/$1.md"
}

# Each exercise has a difficulty, a folded hint and a folded solution, and, if chapters/solutions/ has its solution, the
# command that checks it. There are at least three exercises.
bad_exercises() { # PAGE
    local name
    name=$(basename "$1" .md)
    awk -v number="${name%%_*}" -v solutions="$(echo chapters/solutions/"$name"_*.{frag,diff})" '
        function judge(    k) {
            if (!exercise)
                return
            k = exercise; gsub(/[^0-9]/, "", k)
            if (!hint || !solution)
                print "exercise " exercise " has no " (hint ? "solution" : "hint")
            if (solutions ~ "_" k "[.](frag|diff)" && !checked)
                print "exercise " exercise " has no line make check EXERCISE=" number "_" k
        }
        /^## / { judge(); exercise = 0; here = /^## Exercises/ }
        here && $0 ~ "^make check EXERCISE=" number "_" (exercise + 0) " " { checked = 1 }
        here && /^\*\*[0-9]+\./ {
            judge(); count++; exercise = substr($1, 3); hint = solution = checked = 0
            if ($0 !~ /^\*\*[0-9]+\. [(](easy|medium|hard)[)] [^*]*[.?!]\*\*/)
                print "exercise " exercise " does not begin with **K. (easy|medium|hard) Title.**"
        }
        here && /<summary>Hint</ { hint = 1 }
        here && /<summary>Solution</ { solution = 1 }
        END { judge(); if (count < 3) print "there are only " count + 0 " exercises" }' "$1"
}

# A fold (<details>) is an answer, a hint or a solution, and its tags are on separate lines between empty lines. Each
# prediction and each experiment is followed by a folded answer.
bad_folds() { # PAGE
    awk '
        function judge() { if (asked) print asked ": has no folded answer"; asked = "" }
        /^ *```/ { fenced = !fenced }
        fenced { last = $0; next }
        /<\/?(details|summary)/ {
            if (/^<details><summary>(Answer|Hint|Solution)<\/summary>$/ && !open) {
                open = FNR
                if (/Answer/) asked = ""
            } else if (/^<\/details>$/ && open && last == "") open = 0
            else print "line " FNR ": not a fold of the usual form: " $0
            last = $0
            next
        }
        open == FNR - 1 && open && $0 != "" { print "line " FNR ": no empty line below the summary" }
        open { last = $0; next }
        /^#/ { judge(); experiments = /^## Experiments/ }
        /^\*Predict\.\*/ || (experiments && /^\*\*[0-9]+\./) { judge(); asked = "line " FNR }
        { last = $0 }
        END { judge(); if (open) print "line " open ": a fold is not closed" }' "$1"
}

# A chapter's page has all its parts in order. Its story (the text before the parameters) has at most 3800 words, of
# which at most 300 come before the first figure to drag, and at most three listings below 'From formula to code'.
bad_form() { # PAGE
    local wanted='' name=${1##*/} of_story
    grep -q '^### In short$' "$1" || echo "has no section 'In short'"
    grep -q '^<!-- time -->$' "$1" || echo "has no reading time"
    wanted='What to remember,From formula to code,What changed,Parameters,Experiments,Exercises,Proofs,What the report does,Pitfalls,Sources,'
    ! grep -q '^## What the workshop does$' "$1" || wanted=${wanted/report/workshop}
    ! grep -q '^## What the article does$' "$1" || wanted=${wanted/report/article}
    [[ $name != 00_* ]] || wanted='What to remember,Experiments,Exercises,'
    read -r -a of_story < <(awk -f .make/words.awk "$1")
    [ "${of_story[0]}" -le 3800 ] || echo "its story has ${of_story[0]} words; at most 3800 are allowed"
    ((of_story[3] >= 0 && of_story[3] <= 300)) || echo "has no figure to drag among the first 300 words"
    awk '/^## / { code = /^## From formula to code/; if (/^## Parameters/) exit }
        code && /^<!-- code:/ { n++ }
        END { if (n > 3) print "has " n " listings below From formula to code; at most 3 are allowed" }' "$1"
    awk '/^## What to remember/ { found = 1 } /^### (In short|L.essentiel)/ && !found { print $0 " comes before What to remember" }' "$1"
    bad_captions "$1"
    crowded "$1"
    awk -v wanted="$wanted" '
        /^ *```/ { fenced = !fenced }
        !fenced && /^## / {
            title = substr($0, 4)
            if (next_part == "") next_part = substr(wanted, 1, index(wanted, ",") - 1)
            if (index(title, next_part) == 1 && next_part != "") {
                wanted = substr(wanted, length(next_part) + 2); next_part = ""
            }
        }
        END { if (wanted != "") print "these parts are missing or out of order: " wanted }' "$1"
}

# A picture that is a paragraph by itself has a caption below it: one line of emphasised text. Only the first picture of
# a page needs none, because the story begins below it.
bad_captions() { # PAGE
    awk '
        function judge() { if (bare) print "line " bare ": the picture has no caption below it"; bare = 0 }
        /^ *```/ { fenced = !fenced }
        bare && FNR > bare + 1 { if (/^[*][^*].*[^*][*]$/ && !/^[*]Predict/) bare = 0; judge() }
        !fenced && /^!\[.*\)$/ && pictures++ { bare = FNR }
        END { judge() }' "$1"
}

# Print the places where text was lost or doubled: paragraphs that begin with a small letter or end without a full stop,
# though no formula, listing, list or table interrupts a sentence there, and runs of twelve words that follow each other
# within forty lines.
torn() { # PAGE
    awk '
        function judge() {
            if (unended && $0 !~ /^([$][$]|```|[|<]|- |[0-9]+[.] )/) print "line " unended ": a paragraph ends in the middle of a sentence"
            unended = 0
        }
        function close_paragraph() {
            if (text !~ /^$|^([#|>!<]|[$][$]|[*][*](Hint|Solution))/ && text !~ /([.:?!)*∎]|[$][$]|square[$]|<br>)$/) unended = begun
            text = ""
        }
        function seek_double(    n, i, k, word, run) {
            n = split($0, word, " ")
            for (i = 1; i <= n; i++) {
                last[count++ % 12] = word[i]
                run = ""
                for (k = count - 12; k >= 0 && k < count; k++) run = run " " last[k % 12]
                if (run in seen && FNR - seen[run] < 40 && FNR > told + 5) print "line " (told = FNR) ": printed twice:" run
                if (run != "") seen[run] = FNR
            }
        }
        /^ *```/ {
            if (!fenced) { close_paragraph(); judge() }
            fenced = !fenced
            interrupted = 1
            next
        }
        fenced { next }
        /^$/ { close_paragraph(); next }
        /^[<!]/ { close_paragraph(); judge(); interrupted = /^<!--/; next }
        {
            judge()
            if (text == "") {
                begun = FNR
                if (/^[a-z]/ && !interrupted) print "line " FNR ": a paragraph begins in the middle of a sentence"
            }
            text = text == "" ? $0 : text " " $0
            interrupted = /[$][$]$/
            if (/^([|#]|[$][$])/ || text ~ /^[*][^*]/) count = 0
            else seek_double()
        }
        END { close_paragraph(); judge() }' "$1"
}

# Print the paragraphs of a story with more than twelve numbers. A point in brackets or a formula counts as one number,
# and the number of a chapter, section or key as none.
crowded() { # PAGE
    awk '
        function numbers(text,    part, n, i) {
            gsub(/`[^`]*`|\]\([^)]*\)|[$][$][^$]*[$][$]/, " ", text)
            gsub(/([Cc]hapter|[Ss]ection|[Ff]igure|[Pp]roof|[Ee]xercise|[Ee]xperiment|[Kk]ey)s? [0-9.]+( (to|and) [0-9.]+)?/, " ", text)
            n = split(text, part, "$")
            text = ""
            for (i = 1; i <= n; i++) {
                if (i % 2 == 0) {
                    gsub(/[_^](\{[^}]*\}|.)|frac *[0-9][0-9]/, "", part[i])
                    part[i] = part[i] ~ /[0-9]/ ? " 1 " : " "
                }
                text = text part[i]
            }
            gsub(/\([-0-9., °]+\)/, " 1 ", text)
            return gsub(/[0-9]+([.,][0-9]+)*/, "", text)
        }
        function judge(    n) {
            n = numbers(paragraph)
            if (n > 12) print "line " begun ": a paragraph with " n " numbers; at most 12 are allowed"
            paragraph = ""
        }
        /^## (Parameters|Experiments|Exercises)/ { exit }
        /^ *```/ { fenced = !fenced }
        fenced || /^( *```|[|]|#|!|<|>|- |$|[*][*]Time)/ { judge() }
        fenced || /^( *```|[|]|#|!|<|>|$|[*][*]Time)/ { next }
        { if (paragraph == "") begun = FNR; paragraph = paragraph " " $0 }
        END { judge() }' "$1"
}

# matches PAGE READER PATTERN [i]: prints the first three matching lines of READER's output for the page; i ignores
# case.
matches() { "$2" "$1" | grep "-E${4-}" -e "$3" | sed "s|^|$1:|" | head -n 3; }
lines_of() { grep -n '' "$1"; }

# These checks find the remains of an unfinished merge; an unusual notation for lengths and products; short options,
# which mean nothing to a new reader; and phrases that are wrong English, which pages may mention only in quotes.
bad_merges() { matches "$1" lines_of '^[0-9]+:(<<<<<<<|>>>>>>>) '; }
bad_notation() { matches "$1" lines_of '\\(langle|rangle|lVert|rVert|Vert|\|)'; }
bad_options() { matches "$1" code_of '(^|[ /])build/[0-9][^|>]* -[a-z]( |$)|^-[a-z] '; }
bad_phrases() { matches "$1" prose_of "(^|[^'])\\b(in place of|under an angle|anew|as it were|(as|by|for|of|to) who) " i; }

# Report what is still to be written on a page: sentences of the template, and figures and exercises that do not exist.
unwritten() { # PAGE
    local name
    grep -nxF -f <(awk 'length > 40 && !/[@`#|<]/' .make/chapter/chapter.md) "$1"
    code_of "$1" | sed -n 's/^make run FIGURE=\([0-9][^ `]*\).*/\1/p' | while read -r name; do
        [ -e "chapters/figures/$name.frag" ] || echo "FIGURE=$name: there is no chapters/figures/$name.frag"
    done
    code_of "$1" | sed -n 's/^make check EXERCISE=\([0-9]*_[0-9]*\) .*/\1/p' | sort -u | while read -r name; do
        compgen -G "chapters/solutions/${name%_*}_*_${name#*_}.frag" >/dev/null || echo "EXERCISE=$name: there is no solution of that number in chapters/solutions/"
    done
}

# Report the French terms in a page's parentheses that the glossary lacks.
untranslated() { # PAGE
    prose_of "$1" | grep -o '([*][^*]*[*]' | sed 's/^([*]//; s/[*]$//; s/, /\n/g' | awk -F ' *[|] *' -v page="$1" '
        function words(text) { # a plural counts as its singular
            gsub(/[-*,()]/, " ", text)
            text = " " text " "
            gsub(/s? +/, " ", text)
            return text
        }
        NR == FNR { french[FNR] = words($3); terms = FNR; next }
        {
            found = 0
            for (i = 1; i <= terms && !found; i++)
                found = index(french[i], words($0))
            if (!found) print page ": (" $0 ") is not in docs/glossary.md"
        }' docs/glossary.md -
}

# The glossary has at least 100 terms in order, each of them once, with a French name, a definition and a link to the
# section that introduces the term.
bad_glossary() { # PAGE
    awk -F ' *[|] *' '
        /^## Symbols/ { exit }
        /^[|] / && !/^[|] (English|---)/ {
            term = tolower($2); gsub(/[^a-z0-9]+/, " ", term)
            if (term "" <= last) print $2 ": out of order, or listed twice"
            if ($3 !~ /^[*]..*[*]$/) print $2 ": has no French name"
            if ($5 == "" || $6 !~ /^\[([0-9][0-9]|engine)\]\(/) print $2 ": no definition, or no link to its section"
            last = term; count++
        }
        END { if (count < 100) print "there are only " count + 0 " terms" }' "$1"
}

# Each lab of the guide for teachers has all its parts. The labs are in order, and none of the first six is missing.
bad_labs() { # PAGE
    awk '
        function judge(i) {
            for (i = 1; lab && i <= 4; i++)
                if (!(part[i] in has)) print lab ": has no part " part[i]
            split("", has)
        }
        BEGIN { split("*Predict.* *Show.* *Work.* *Exit_question.*", part, " ") }
        { gsub(/Exit question/, "Exit_question") }
        /^##/ { judge(); lab = "" }
        /^### Lab / {
            lab = $0
            if ($3 + 0 != last + 1 && ($3 + 0 <= last || last < 6)) print "lab " last " is followed by lab " $3
            last = $3 + 0
        }
        /^- / { has[$2] = 1 }
        END { judge(); if (last < 6) print "the last lab is " last + 0 }' "$1"
}

# A chapter's page has a command that shows two pictures side by side in a window, a wrong one and the right one.
lacks_pair() { # PAGE
    code_of "$1" | grep -qE '^build/[0-9].* --compare( |$)' || echo "$1: no command has --compare"
}

# Print the shaders that belong to a chapter but are not named on its page.
unnamed_shaders() { # STEM
    local file number=${1%%_*} text
    text=$(<"docs/$1.md")
    for file in chapters/{solutions,experiments,figures}/"$number"_*.frag \
        $([ "$number" != 00 ] || echo chapters/first_steps/[!e]*.frag); do
        [[ $text == *"$file"* ]] || echo "$file is not in docs/$1.md"
    done
}

targets=" $(sed -n 's/^\([a-z][-a-z0-9]*\):.*/\1/p' Makefile | tr '\n' ' ')"

# Each command of a chapter's program is tried with --list added. The program then reads all options, the shader and the
# values of its parameters, but renders nothing. A shader that the reader writes, such as 'my.frag', is replaced with
# the chapter's shader. A command with the comment '# refused' must be refused.
bad_commands() { # PAGE
    local command target
    code_of "$1" | grep -E '(^|[;&|(] *)(build/[0-9]|make [a-z]|[A-Z]+=)' | sed 's/ && /\n/g; s/[;|].*//' |
        while IFS= read -r command; do
            case $command in
            [A-Z]*=*) # a variable that later commands use; anything after its value would be executed
                [[ $command =~ ^[A-Z_]+=[^\ ]*\ *$ || $command =~ ^[A-Z_]+=\'[^\']*\'\ *$ || $command =~ ^[A-Z_]+=\"[^\"]*\"\ *$ ]] ||
                    { echo "$1: $command: no variable may be set in front of a command" && continue; }
                eval "$command"
                ;;
            make\ [a-z]*)
                target=${command#make }
                [[ $targets == *" ${target%% *} "* ]] || echo "$1: $command: no such target"
                ;;
            build/[0-9]*'# refused'*)
                ! try_command "${command%% #*}" >/dev/null 2>&1 || echo "$1: $command: not refused"
                ;;
            build/[0-9]*)
                target=${command%%[<>]*}
                try_command "${target%% #*}" >"$scratch/said" 2>&1 ||
                    echo "$1: $command: $(head -n 1 "$scratch/said")"
                ;;
            esac
        done
}

try_command() { # COMMAND
    local -a words=() given=()
    eval "words=($1)" || return 1
    local program=$BUILD/${words[0]#build/} word="" before=""
    [ -x "$program" ] || { echo "no such program" && return 1; }
    for word in "${words[@]:1}"; do
        if [[ $before == -f || $before == --shader ]] && [[ $word == *.frag && $word != */* ]]; then
            word=chapters/${program##*/}.frag
        fi
        given+=("$word")
        before=$word
    done
    case " ${given[*]} " in
    *\ --help\ * | *\ --version\ * | *\ --print-shader\ *) "$program" "${given[@]}" ;;
    *) "$program" "${given[@]}" --list ;;
    esac
}

# The last line of a probe's output on a page must be the last line that the command prints. Below several commands,
# their last lines follow in the same order.
bad_outputs() { # PAGE
    local command shown
    awk '
        /^ *```/ { fenced = !fenced; if (/```sh/) shown = asked = 0; next }
        fenced && /^ *build\/.* --probe / {
            sub(/^ */, "")
            if (shown) shown = asked = 0
            command[++asked] = $0
        }
        fenced && /^ *# .*; colour: / && sub(/^ */, "") && shown < asked { print command[++shown]; print }' "$1" |
        while IFS= read -r command && IFS= read -r shown; do
            eval "set -- $(sed -E 's/ (-o|--output) +[^ ]+//; s/ *[|] *tail -n 1$//' <<<"$command")" # a test writes no picture
            command=$BUILD/${1#build/}
            shift
            same_line "$("$command" "$@" 2>&1 | tail -n 1)" "$shown" || echo "$command $*: does not print '$shown'"
        done
}

# True if two last lines of a probe agree. Each channel of the colour may differ by one, because another driver may
# round differently.
same_line() { # A B
    [ "${1%colour: *}" = "${2%colour: *}" ] && awk -v a="${1##*: }" -v b="${2##*: }" 'BEGIN {
        n = split(a, x, ", "); split(b, y, ", ")
        for (i = 1; i <= n; i++) if ((x[i] - y[i]) ^ 2 > 1) exit 1
    }'
}

# ---- The pages ----

check_pages() {
    local page stem
    for page in "${pages[@]}"; do
        judge "$page: listings and tables match the sources" \
            "$(.make/listings.sh --check "$page" 2>&1)"
        judge "$page: links, pictures and anchors exist" "$(bad_links "$page")"
        judge "$page: pictures are tested references" "$(bad_pictures "$page")"
        judge "$page: has no merge conflict markers" "$(bad_merges "$page")"
        judge "$page: no text is lost or printed twice" "$(torn "$page")"
        judge "$page: GitHub renders its formulas" "$(bad_formulas "$page")"
        judge "$page: commands are accepted by their programs" "$(bad_commands "$page")"
        judge "$page: probes print the last line that the page shows" "$(bad_outputs "$page")"
        judge "$page: lengths and products have the usual notation" "$(bad_notation "$page")"
        judge "$page: options are spelt out" "$(bad_options "$page")"
        judge "$page: has no phrase that is always wrong" "$(bad_phrases "$page")"
    done
    for stem in "${chapters[@]}"; do
        if [ ! -e "docs/$stem.md" ]; then
            not_ok "docs/$stem.md" "the chapter has no page"
            continue
        fi
        judge "docs/$stem.md: has a French summary of five lines" "$(bad_summary "docs/$stem.md")"
        judge "docs/$stem.md: its French terms are in the glossary" "$(untranslated "docs/$stem.md")"
        judge "docs/$stem.md: names every parameter" "$(unnamed_parameters "$stem")"
        judge "docs/$stem.md: shows two pictures side by side" "$(lacks_pair "docs/$stem.md")"
        judge "docs/$stem.md: names every shader of its chapter" "$(unnamed_shaders "$stem")"
        judge "docs/$stem.md: its exercises have checks, hints and solutions" "$(bad_exercises "docs/$stem.md")"
        judge "docs/$stem.md: its folds have the usual form, and each question has its answer" \
            "$(bad_folds "docs/$stem.md")"
        judge "docs/$stem.md: has the form of a page" "$(bad_form "docs/$stem.md")"
        judge "docs/$stem.md: nothing is still to be written" "$(unwritten "docs/$stem.md")"
    done
}

# ---- The checks themselves: each must find a mistake ----

# refuses NAME TEXT CHECK: the check must complain about a page with this text. What a check accepts is tested by the
# pages themselves.
refuses() {
    mkdir -p "$scratch/docs" "$scratch/tests"
    ln -sfn "$PWD/tests/references" "$scratch/tests/references"
    printf '%s\n' "$2" >"$scratch/docs/page.md"
    check "a page is refused for $1" test -n "$("$3" "$scratch/docs/page.md")"
}

check_checks() {
    local probe='build/01_normal_colouring --probe 320,180'
    refuses 'an anchor without a heading' $'# One two\n[a](#one-two) [b](#one-three)' bad_links
    refuses 'a word that lights no point' $'![a](../tests/references/01_normal_colouring-figure-march.png)\n[a](#eye) [b](#nose)' bad_links
    refuses 'a value for no parameter' $'![a](../tests/references/00_first_scene-figure-march.png)\n[a](#most=12) [b](#least=12)' bad_links
    judge 'a value may name a picture, whose shader includes the parameter' "$(printf '![a](../tests/references/03_shadows-sun.png)\n[a](#focalLength=2@sun)\n' >"$scratch/docs/page.md"; bad_links "$scratch/docs/page.md")"
    refuses 'a value for a picture that does not have it' $'![a](../tests/references/03_shadows-sun.png)\n[a](#tint=2@sun)' bad_links
    refuses 'a value for a picture that the page does not show' $'![a](../tests/references/03_shadows-sun.png)\n[a](#focalLength=2@low)' bad_links
    refuses 'a picture that no test renders' '![a](../tests/references/gone.png)' bad_pictures
    refuses 'an exercise without a solution' "$(sed '0,/<summary>Solution/s//<summary>Hint/' docs/03_shadows.md)" bad_exercises
    refuses 'a question without an answer' '*Predict.* Why?' bad_folds
    judge 'the page of a new chapter has the form of a page' "$(bad_form .make/chapter/chapter.md)"
    refuses 'parts out of order' "$(sed 's/^## Proofs/## Lemmas/' .make/chapter/chapter.md)" bad_form
    refuses 'a summary before its story' "$(sed 's/^### In short/&\n/; s/^!\[/### In short\n\n&/' .make/chapter/chapter.md)" bad_form
    refuses 'no figure among its first words' "$(sed '/^make run FIGURE/d' .make/chapter/chapter.md)" bad_form
    refuses 'more than three listings in a row' "$(sed '/^<!-- code:/{p;p;p}' .make/chapter/chapter.md)" bad_form
    refuses 'a story of more than 3800 words' "$(sed "/^## 1/s/\$/\n\n$(printf 'word %.0s' {1..3800})/" .make/chapter/chapter.md)" bad_form
    refuses 'a picture without a caption' $'![a](a.png)\n\n![b](b.png)\n\n*Predict.* Why?' bad_captions
    refuses 'a paragraph that begins in the middle of a sentence' $'The wall is\n\nhalf as light.' torn
    refuses 'a paragraph that ends in the middle of a sentence' $'The wall is\n\nThe floor is light.' torn
    refuses 'a sentence that is printed twice' "$(printf '%s\n\n' 'The wall is half as light as the floor, and the arcade is dark'{,.})" torn
    refuses 'thirteen numbers in a paragraph' '1 2 3 4 5 6 7 8 (9, 10) $11$ and $x_0 = 12$ or 13 and 14, not `16` or $x^2$' crowded
    printf '1 2 3 4 5 6 7 8 (9, 10) $11$ and $x_0 = 12$ or 13, not `16` or $x^2$\n\n' >"$scratch/twelve.md"
    judge 'twelve numbers in a paragraph are accepted' "$(crowded "$scratch/twelve.md")"
    refuses 'angle brackets for a product' '$\langle a, b \rangle$' bad_notation
    refuses 'a phrase that is always wrong' 'a mean in place of a sum' bad_phrases
    refuses 'a sentence of the template' "$(grep -n '' .make/chapter/chapter.md | sed -n 's/^6://p')" unwritten
    refuses 'a figure that does not exist' "$(printf '```sh\nmake run FIGURE=00_none\n```')" unwritten
    refuses 'an exercise without a solution' "$(printf '```sh\nmake check EXERCISE=00_9 FILE=my.frag\n```')" unwritten
    refuses 'a short option' "\`build/${chapters[0]} -t 2\`" bad_options
    refuses 'a French term that the glossary lacks' 'the ray (*rayon*), the **word** (*mot, rayon*)' untranslated
    refuses 'a term listed twice' "$(sed '/^| acne /p' docs/glossary.md)" bad_glossary
    refuses 'a lab without an exit question' "$(sed '0,/Exit question/s//Question/' docs/teaching.md)" bad_labs
    refuses 'a merge conflict marker' $'a\n<<<<<<< HEAD\nb' bad_merges
    refuses 'a formula that GitHub changes' 'so $a \\, b$ is' bad_formulas
    refuses 'a summary of four lines' $'## L\'essentiel\n\n> a\n> b\n> c\n> d\n\ntext' bad_summary
    refuses 'an unknown view' "\`build/${chapters[0]}\` then \`build/${chapters[0]} --view colours\`" bad_commands
    refuses 'an output that the command does not print' \
        $'```\n'"$probe"$'\n# hit; evaluations of the scene: 0; colour: 1, 2, 3\n```' bad_outputs
}

# ---- The tool that writes the listings, whose results are those of the pages ----

write_source() {
    cat >"$scratch/source.glsl" <<'END'
const float EDGE = 1.0; // a brace { in a comment

struct Pair {
    float a; // ;
};

float once(vec3 p);
EVERY(EDGE)

// What once is.
float once(vec3 p)
{
    return p.x;
}

float twice(float x) { return 2.0 * x; }
vec3 twice(vec3 x) { return 2.0 * x; }
END
}

# fails PAGE PATTERN OPTION...: the tool must fail with a message that matches, and leave the page unchanged.
fails() {
    local page=$1 pattern=$2
    shift 2
    cp "$page" "$page.before"
    ! .make/listings.sh "$@" "$page" >/dev/null 2>"$scratch/said" &&
        grep -q -e "$pattern" "$scratch/said" && cmp -s "$page" "$page.before"
}

rewrites() { # PAGE
    [ "$(.make/listings.sh "$1")" = "$1: listings rewritten" ]
}

check_tool() {
    local page=$scratch/tool.md source=$scratch/source.glsl
    write_source
    printf '<!-- code: %s gone -->\n' "$source" >"$page"
    check 'a listing of an unknown name fails' fails "$page" ':1: .*source.glsl: defines no gone'
    printf '\n<!-- code: %s twice -->\n' "$source" >"$page"
    check 'a listing of a name that is defined twice fails' fails "$page" ':2: .*defines twice more than once'
    printf '<!-- code: %s once -->\n' "$scratch/gone.glsl" >"$page"
    check 'a listing of a missing file fails' fails "$page" 'cannot be read'
    printf '<!-- code: %s -->\n' "$source" >"$page"
    check 'a malformed marker fails' fails "$page" 'malformed'
    printf '<!-- code: %s once -->\n```glsl\nfloat\n' "$source" >"$page"
    check 'a fence that is not closed fails' fails "$page" 'no end'
    printf '<!-- code: %s once -->\n```glsl\nstale\n```\n`once`\n' "$source" >"$page"
    check 'a stale listing fails --check' fails "$page" ':1: differs' --check
    check 'a stale listing is rewritten' rewrites "$page"
    sed -i.before 's/return p.x/return p.y/' "$source"
    check 'a source that changed fails --check' fails "$page" ':1: differs' --check

    printf '<!-- time -->\n%s\n\n*Predict.* Why?\n\n$$x =\n1$$\n\n## Exercises\n\n## Proofs\n\n%s\n' \
        "$(printf 'word $x + y$ %.0s' {1..900})" "$(printf 'word %.0s' {1..101})" >"$page"
    check 'a missing time is written' rewrites "$page"
    check 'the time follows from words, questions and formulas' grep -q -x \
        '[*][*]Time[.][*][*] 15 minutes with its figures and questions, 10 if you only read, and 5 more for the proofs[.]' "$page"
    printf '<!-- parameters: 99_nothing -->\n' >"$page"
    check 'a table of parameters of an unknown program fails' fails "$page" 'make first'
}

# ---- Listings are used ----

# unused NAME PATTERN TEXT: a page with this text must be refused with a message that matches.
unused() {
    printf '%b' "$3" >"$scratch/used.md"
    .make/listings.sh "$scratch/used.md" >/dev/null 2>&1
    ! .make/listings.sh --check "$scratch/used.md" >"$scratch/said" 2>&1
    check "a page is refused for $1" grep -q -e "$2" "$scratch/said"
}

# Print the functions and structs of the test's source that a page with these markers does not show.
unlisted() { # MARKER...
    printf '<!-- code: %s -->\n' "$@" >"$scratch/used.md"
    awk -v library="$scratch/source.glsl" -f .make/source.awk -f .make/listings_used.awk \
        "$scratch/used.md" 2>&1 | grep 'is on no page'
}

check_use() {
    local source=$scratch/source.glsl
    write_source
    unused 'a listing that its text never names' ':1: .* never names: `once`' \
        "<!-- code: $source once -->\n\nThat was once, in \`oncemore\`.\n"
    unused 'a listing that only a block names' 'never names: `once`' \
        "<!-- code: $source once -->\n\n\`\`\`sh\n\`once\`\n\`\`\`\n"
    unused 'a whole file that its text never names' 'never names: `source.glsl`' \
        "<!-- code: $source * -->\n\n\`once\`\n"
    unused 'a listing copied by hand' ':2: copied by hand from shaders/march.glsl:5' \
        'text\n```glsl\nstruct Hit {\n  bool found;\n\n};\n```\n'
    check 'a function and a struct that no page shows are found' test "$(unlisted "$source EDGE" |
        sed 's/.*: the //' | tr '\n' ',')" = \
        "$(printf '%s is on no page,' 'struct Pair' 'function once' 'function twice' 'function twice')"
    check 'a link that names a function counts as its listing' test -z "$(
        printf '[`once`](../%s) [`Pair`](../%s) [`twice`](../%s)\n' "$source" "$source" "$source" >"$scratch/used.md"
        awk -v library="$source" -f .make/source.awk -f .make/listings_used.awk "$scratch/used.md" 2>&1
    )"
    unused 'a link that names a function of another file' ':1: a link names `thrice`' "[\`thrice\`](../$source)\n"
}

if [ $# != 0 ]; then
    pages=("$@") chapters=()
    for page; do
        [[ $page != docs/[0-9][0-9]_* ]] || chapters+=("$(basename "$page" .md)")
    done
    check_pages
    plan
    exit
fi
check_pages
judge "docs/engine.md: its exercises have checks, hints and solutions" "$(bad_exercises docs/engine.md)"
judge "docs/engine.md: each question has its answer" "$(bad_folds docs/engine.md)"
judge "docs/engine.md: its French terms are in the glossary" "$(untranslated docs/engine.md)"
judge "docs/glossary.md: its terms are in order, with French names and sections" "$(bad_glossary docs/glossary.md)"
judge "docs/teaching.md: each lab has a prediction, a demonstration, work and an exit question" \
    "$(bad_labs docs/teaching.md)"
judge "every function and struct that the course teaches is on a page" \
    "$(.make/listings.sh --check 2>&1 | grep 'is on no page')"
replaced() { # prints the complaints of `make student` about sentences that it cannot replace
    local page
    for page in README.md docs/README.md; do
        awk -v name="$page" -v list=.make/student/replaced.txt -f .make/student/replace.awk "$page" 2>"$scratch/said" >/dev/null
        cat "$scratch/said"
    done
}
judge "the sentences that make student replaces exist" "$(replaced)"
lost_guesses() { # prints the lines of guesses.txt that are not the beginning of one question of their page
    local page words
    while IFS='|' read -r page words _; do
        awk -v words="$words" '
            function plain(text) {
                gsub(/\]\([^)]*\)|[][`*$ ]/, "", text) # without blanks, because formulas have some
                return text
            }
            function end() { if (question != "" && index(plain(question), plain(words)) == 1) found++; question = "" }
            /^$/ { end() }
            sub(/^\*Predict\.\*/, "") { question = $0; next }
            question != "" { question = question " " $0 }
            END { end(); if (found != 1) print FILENAME ": " words "begins " found + 0 " questions" }' "docs/${page% }.md"
    done < <(grep '^[0-9]' docs/web/guesses.txt)
}
judge "each line of guesses.txt begins one question" "$(lost_guesses)"
check_checks
check_tool
check_use
plan

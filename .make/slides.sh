#!/bin/sh
# slides.sh - `make slides`: typeset the scenes of a list as slides, build/slides.pdf. Each slide has the picture of a
# scene, with the scene's sentence below it.
#
# Environment: LIST, a list of scenes; the default is docs/lecture.txt.
set -u
. .make/scenes.sh

draw_scenes "${LIST:-docs/lecture.txt}" slides
folder=$new/slides

# Markdown's special characters are escaped, so that a sentence is printed as it is.
awk -F '\037' -v folder="$folder" '
    function plain(text) {
        gsub(/[][!-\/:-@\\^_`{-~]/, "\\\\&", text)
        return text
    }
    { printf "## %s\n\n![](%s/%02d.png){height=66mm}\\ \n\n%s\n\n", plain($2), folder, $1, plain($5) }' \
    "$folder/scenes" >"$new/slides.md" || exit 1
cat >"$new/head.tex" <<'END'
\setbeamertemplate{navigation symbols}{}
\setbeamertemplate{footline}{\hfill\usebeamercolor[fg]{page number in head/foot}\insertframenumber\hspace{3mm}\vspace{2mm}}
\setbeamertemplate{frametitle}{\vspace{2mm}\centering\small\insertframetitle\par}
\setbeamersize{text margin left=5mm,text margin right=5mm}
\AtBeginDocument{\centering\setlength{\parskip}{1.5mm}}
END
pandoc -t beamer -s "$new/slides.md" -o "$new/slides.pdf" --pdf-engine=xelatex --slide-level=2 -H "$new/head.tex" \
    -M title='Ray marching, step by step' -M lang=en-GB -V aspectratio=169 -V fontsize=10pt -V colorlinks=true \
    -V mainfont='TeX Gyre Heros' -V sansfont='TeX Gyre Heros' 2>"$new/log" ||
    fail 1 "the slides could not be typeset: $(grep -E -m 1 -A 2 '^!|Error' "$new/log" | tr '\n' ' ')"
if grep 'Missing character' "$new/log" | sort -u | grep . >&2; then
    fail 1 "$list: the font of the slides lacks these characters"
fi
keep slides slides.pdf || exit 1
echo "build/slides.pdf: $(pdfinfo build/slides.pdf | awk '/^Pages/ { print $2 " pages, " }')$(du -h build/slides.pdf | cut -f 1)"

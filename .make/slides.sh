#!/bin/sh
# slides.sh - `make slides`: typeset the scenes of a list as slides, build/slides.pdf. Each slide has the picture of a
# scene, with the scene's sentence below it.
#
# Environment: LIST, a list of scenes; the default is docs/lecture.txt.
set -u
export LC_ALL=C
. .make/scenes.sh

list=${LIST:-docs/lecture.txt}
folder=build/slides
rm -rf "$folder"
draw_scenes "$list" "$folder" || exit 1

# Markdown's special characters are escaped, so that a sentence is printed as it is.
awk -F '\037' -v folder="$folder" '
    function plain(text) {
        gsub(/[][!-\/:-@\\^_`{-~]/, "\\\\&", text)
        return text
    }
    { printf "## %s\n\n![](%s/%02d.png){height=66mm}\\ \n\n%s\n\n", plain($2), folder, $1, plain($5) }' \
    "$folder/scenes" >"$folder/slides.md" || exit 1
cat >"$folder/head.tex" <<'END'
\setbeamertemplate{navigation symbols}{}
\setbeamertemplate{footline}{\hfill\usebeamercolor[fg]{page number in head/foot}\insertframenumber\hspace{3mm}\vspace{2mm}}
\setbeamertemplate{frametitle}{\vspace{2mm}\centering\small\insertframetitle\par}
\setbeamersize{text margin left=5mm,text margin right=5mm}
\AtBeginDocument{\centering\setlength{\parskip}{1.5mm}}
END
if ! pandoc -t beamer -s "$folder/slides.md" -o build/slides.pdf --pdf-engine=xelatex --slide-level=2 -H "$folder/head.tex" \
    -M title='Ray marching, step by step' -M lang=en-GB -V aspectratio=169 -V fontsize=10pt -V colorlinks=true \
    -V mainfont='TeX Gyre Heros' -V sansfont='TeX Gyre Heros' 2>"$folder/log"; then
    echo "make: the slides could not be typeset: $(grep -E -m 1 -A 2 '^!|Error' "$folder/log" | tr '\n' ' ')" >&2
    exit 1
fi
if grep 'Missing character' "$folder/log" | sort -u | grep . >&2; then
    echo "make: $list: the font of the slides lacks these characters" >&2
    exit 1
fi
echo "build/slides.pdf: $(pdfinfo build/slides.pdf | awk '/^Pages/ { print $2 " pages, " }')$(du -h build/slides.pdf | cut -f 1)"

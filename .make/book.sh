#!/bin/bash
# book.sh - `make book`: typeset all pages as one PDF, build/book.pdf, with a table of contents and numbered figures.
# pandoc reads the pages, and XeLaTeX typesets them.
set -u
. .make/write.sh
. .make/pages.sh

begin build || exit 1

files=()
for page in $(pages); do
    name=$(basename "$page")
    pandoc -f gfm+tex_math_dollars -t json -M page="$name" --lua-filter .make/book.lua "$page" \
        -o "$new/${name%.md}.json" || exit 1
    files+=("$new/${name%.md}.json")
done

cat >"$new/head.tex" <<'END'
\usepackage{fvextra}
\DefineVerbatimEnvironment{Highlighting}{Verbatim}{breaklines,breakanywhere,commandchars=\\\{\}}
\RecustomVerbatimEnvironment{verbatim}{Verbatim}{breaklines,breakanywhere}
\fvset{breaklines=true,breakanywhere=true,fontsize=\small}
\newfontfamily{\symbolfont}{DejaVu Sans}
\providecommand{\lt}{<}
\providecommand{\gt}{>}
\AtBeginDocument{\renewcommand{\setminus}{\mathbin{\backslash}}}
\newsavebox{\formulabox}
\newcommand{\fitted}[1]{\sbox{\formulabox}{$\displaystyle #1$}%
  \ifdim\wd\formulabox>\linewidth\resizebox{\linewidth}{!}{\usebox{\formulabox}}\else\usebox{\formulabox}\fi}
\usepackage{float}
\floatplacement{figure}{H}
\emergencystretch=3em
END

# The paths of pictures in the pages are relative to docs/.
pandoc -s "${files[@]}" -o "$new/book.pdf" --pdf-engine=xelatex --resource-path=docs \
    --toc --toc-depth=2 --top-level-division=chapter --highlight-style=tango -H "$new/head.tex" \
    -M title='Ray marching, step by step' -M subtitle='A course in C and GLSL' -M lang=en-GB \
    -V documentclass=report -V papersize=a4 -V geometry:margin=24mm -V fontsize=10pt \
    -V mainfont='TeX Gyre Pagella' -V sansfont='TeX Gyre Heros' -V monofont='DejaVu Sans Mono' \
    -V monofontoptions='Scale=0.8' -V colorlinks=true 2>"$new/log" ||
    fail 1 "the book could not be typeset: $(grep -E -m 1 -A 2 '^!|Error' "$new/log" | tr '\n' ' ')"
# A character that the font lacks would leave a gap in the text.
if grep -q 'Missing character' "$new/log"; then
    grep 'Missing character' "$new/log" | sort -u >&2
    exit 1
fi
keep book.pdf || exit 1
echo "build/book.pdf: $(pdfinfo build/book.pdf | awk '/^Pages/ { print $2 " pages, " }')$(du -h build/book.pdf | cut -f 1)"

#!/bin/sh
# handouts.sh - `make handouts`: typeset the labs of docs/teaching.md for students, two pages each, as
# build/handouts.pdf, and their answers, a page for each lab, as build/handouts-answers.pdf.
set -u
. .make/write.sh

begin build || exit 1
cat >"$new/head.tex" <<'END'
\newfontfamily{\symbolfont}{DejaVu Sans}
\usepackage{amssymb}
\usepackage{graphicx}
\newcommand{\heading}[2]{\par\vspace{2mm}{\csname #1\endcsname\bfseries #2\par}\nopagebreak}
\newcommand{\writing}{\par\vspace{6mm}\noindent\hrulefill\par}
\setlength{\parskip}{2mm}
\setlength{\parindent}{0pt}
\raggedright
\emergencystretch=3em
\pagestyle{empty}
END

# make_pdf NAME OPTION...: make NAME.pdf.
make_pdf() {
    name=$1
    shift
    pandoc -s -f gfm+tex_math_dollars docs/teaching.md --lua-filter .make/handouts.lua "$@" -o "$new/$name.pdf" \
        --pdf-engine=xelatex -H "$new/head.tex" -M lang=en-GB -V documentclass=article -V papersize=a4 \
        -V geometry:margin=20mm -V fontsize=11pt -V mainfont='TeX Gyre Pagella' -V monofont='DejaVu Sans Mono' \
        -V monofontoptions='Scale=0.8' 2>"$new/log" ||
        fail 1 "the handouts could not be typeset: $(grep -E -m 1 -A 2 '^!|Error' "$new/log" | tr '\n' ' ')"
    if grep 'Missing character' "$new/log" | sort -u | grep . >&2; then
        fail 1 'docs/teaching.md or docs/questions.txt: the font of the handouts lacks these characters'
    fi
}

make_pdf handouts
make_pdf handouts-answers -M answers=true
keep handouts.pdf handouts-answers.pdf || exit 1
for name in handouts handouts-answers; do
    echo "build/$name.pdf: $(pdfinfo "build/$name.pdf" | awk '/^Pages/ { print $2 " pages" }')"
done

# student.awk - print a page without its folded answers and solutions, and without commands and markers that name a
# solution. Hints are kept. Consecutive empty lines that result become one.
/^ *<details><summary>(Answer|Solution)<\/summary>$/ { fold = 1 }
fold {
    if (/^ *<\/details>$/) fold = 0
    next
}
/^ *```/ { fence = !fence }
(fence || /^<!-- code:/) && /chapters\/solutions\// { next }
/^$/ && blank { next }
{ blank = /^$/; print }

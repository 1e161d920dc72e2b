# summary.awk - write a summary for the lecturer: for each exercise the marks, the mean of the points, and how often each
# comparison fails.
#
#   awk -F '\t' -v summary=FILE ... -f table.awk -f marks.awk -f summary.awk

{
    answers[$1]++
    marked[$1, $3]++
    sum_of[$1] += earned
    same_in[$1] += $9 != ""
    look_in[$1] += look != ""
    if ($4 ~ /^does not end/)
        endless[$1]++
    else if ($4 ~ /^does not/)
        silent[$1]++
    else
        for (i = 1; i <= compared[$1]; i++)
            fails[$1, i] += substr($7, i, 1) != "+"
}

function say(count, words)
{
    if (count)
        printf "  %4d  %s\n", count, words >summary
}

END {
    for (e = 1; e <= wanted; e++) {
        x = exercise[e]
        printf "%s%s: %d answers, %d right, %d wrong; on average %s of %s points\n", (e > 1 ? "\n" : ""), x, answers[x], marked[x, "right"], marked[x, "wrong"], \
            points(answers[x] ? sum_of[x] / answers[x] : 0), points(full[x]) >summary
        say(same_in[x], "almost the same as another")
        say(look_in[x], "to look at")
        say(silent[x], "do not run")
        say(endless[x], "do not end")
        # The comparisons, those that fail most often first.
        for (;;) {
            most = 0
            for (i = 1; i <= compared[x]; i++)
                if (fails[x, i] > fails[x, most] + 0)
                    most = i
            if (!most)
                break
            say(fails[x, most], "fail: " comparison[x, most])
            fails[x, most] = 0
        }
    }
}

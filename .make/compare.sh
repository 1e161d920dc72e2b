#!/bin/bash
# compare.sh - `make compare PICTURES='one.png two.png'`: print on one line how much two pictures differ. If they differ
# by more than rounding, a picture of the difference is left in build/compare.png.
#
# Environment: PICTURES. Exit status: 0 if the pictures are the same within the tolerance, 1 if they are not, 2 if they
# cannot be compared.
set -u -f
. .make/write.sh
difference=build/compare.png

# shellcheck disable=SC2206 # a name must not contain spaces
pictures=(${PICTURES-})
if [ ${#pictures[@]} != 2 ]; then
    fail 2 "which two pictures? For example: make compare PICTURES='one.png two.png'"
fi
for i in 0 1; do
    [[ ${pictures[i]} != -* ]] || pictures[i]=./${pictures[i]} # a name, not an option
    ! [ "${pictures[i]}" -ef $difference ] || fail 2 "${pictures[i]}: the picture of the difference would replace it: copy it to another place"
done
mkdir -p build
said=$(build/tests/compare --words "${pictures[@]}" "$difference" 2>&1)
status=$?
case $status$said in
2*) report "$said" ;;
*', most around '*) echo "$said: see $difference" ;;
*) echo "$said" && rm -f "$difference" ;;
esac
exit "$status"

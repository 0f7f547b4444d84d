#!/usr/bin/env bash
# docs/benchmarks.sh [NAME...]: makes docs/benchmarks.md and its plots (docs/images/bench-*.svg) of docs/benchmarks.in.md.
#
# Runs configs/bench/NAME.yaml for each NAME that the template has a command of, or only for those given here; the
# others' results are taken from out/bench, where they were left before. Lines of the template that stand for others:
#   @machine@              processor, program, device and driver
#   @command NAME@         the command that measured
#   @table NAME TITLE@     that table of its report, with what its columns mean
#   @notes NAME TITLE@     what that table's report says below it, alone
# A plot is a link to images/bench-NAME-PLOT.svg.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
template=docs/benchmarks.in.md

fail() {
    echo "docs/benchmarks.sh: $*" >&2
    exit 1
}

command_of() {
    echo "build/umbrage bench configs/bench/$1.yaml --out out/bench/$1 --markdown out/bench/$1.md --json out/bench/$1.json"
}

mapfile -t names < <(sed -nE 's/^@command (.+)@$/\1/p' "$template")
[ ${#names[@]} -gt 0 ] || fail "$template has no command"
for name in "${@:-${names[@]}}"; do
    printf '== %s\n' "$(command_of "$name")" >&2
    mkdir -p "out/bench/$name"
    $(command_of "$name") >/dev/null
done

# NAME TITLE: what stands below that heading of the report
section() {
    awk -v heading="## $2" '$0 == heading { on = found = 1; next } /^## / { on = 0 } on; END { exit !found }' \
        "out/bench/$1.md" || fail "out/bench/$1.md has no \"$2\""
}

machine() {
    local processor
    processor=$(sed -nE 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)
    echo "${processor:-$(uname -m)}, $(nproc) processors; $(grep -m 1 '^umbrage ' "out/bench/${names[0]}.md")"
}

document() {
    local line
    while IFS= read -r line; do
        if [ "$line" = @machine@ ]; then
            machine
        elif [[ $line =~ ^@command\ (.+)@$ ]]; then
            echo "    $(command_of "${BASH_REMATCH[1]}")"
        elif [[ $line =~ ^@table\ ([^ ]+)\ (.+)@$ ]]; then
            section "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
        elif [[ $line =~ ^@notes\ ([^ ]+)\ (.+)@$ ]]; then
            section "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" | sed -E '/^(\||- )/d' | cat -s
        elif [[ $line == @* ]]; then
            fail "$template: what is $line"
        else
            printf '%s\n' "$line"
        fi
    done <"$template"
}

document >out/bench/benchmarks.md
mkdir -p docs/images
rm -f docs/images/bench-*.svg
for plot in $(grep -oE 'images/bench-[^)]+\.svg' "$template"); do
    found=
    for name in "${names[@]}"; do
        file=out/bench/$name/${plot#"images/bench-$name-"}
        [ ! -f "$file" ] || { cp "$file" "docs/$plot" && found=yes; }
    done
    [ -n "$found" ] || fail "no bench made docs/$plot"
done
mv out/bench/benchmarks.md docs/benchmarks.md
echo "== docs/benchmarks.md" >&2

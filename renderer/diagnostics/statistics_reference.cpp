// SPDX-License-Identifier: Apache-2.0
// The page of terms, from the tables themselves.
#include <fmt/format.h>

#include "diagnostics/quantities.h"
#include "diagnostics/statistics_format.h"

namespace umbrage {
namespace {

std::string counterTables() {
    std::string text;
    for (std::size_t i = 0; i < kCounters.size(); ++i) {
        const CounterInfo& counter = kCounters[i];
        if (i == 0 || groupOf(i).name != groupOf(i - 1).name) {
            text += fmt::format("\n### {}\n\n{}\n\n| counter | unit | meaning | of several |\n|---|---|---|---|\n",
                                groupOf(i).name, groupOf(i).doc);
        }
        text += fmt::format("| `{}` | {} | {} | {} |\n", counter.name, counter.unit, counter.doc,
                            counter.numerator.empty() ? nameOf(counter.combine) : "ratio of the sums");
    }
    return text;
}

std::string quantityTable() {
    std::string text = "| quantity | unit | meaning | AOV |\n|---|---|---|---|\n";
    for (const QuantityInfo& quantity : kQuantities) {
        text += fmt::format("| `{}` | {} | {} | `{}` |\n", quantity.name, quantity.unit, quantity.doc, quantity.aov);
    }
    text += "\n| figure | meaning |\n|---|---|\n";
    for (const DistributionFigure& figure : kDistributionFigures) {
        text += fmt::format("| `{}` | {} |\n", figure.name, figure.doc);
    }
    return text;
}

}  // namespace

std::string statisticsReference() {
    return "# Statistics\n"
           "\n"
           "`umbrage schema --statistics --markdown` wrote this page, from the tables that write the files.\n"
           "\n"
           "A sequence with `statistics: {path: FILE.json}` writes its numbers for every frame; `diagnostics: "
           "{profile: "
           "true}` adds times.\n"
           "A number belongs to a frame, and in it to a light (its id), a shadow caster (its node path), a material, "
           "or "
           "a pair of them.\n"
           "\n## Counters\n\n"
           "One number a place. *Of several* says what the frames of a sequence, or the lights of a frame, become "
           "together.\n" +
           counterTables() +
           "\n## Quantities\n\n"
           "One number a pixel, kept as a distribution. Bins are 1 wide below 256, above there are 128 of them an "
           "octave: percentiles of\n"
           "whole numbers are exact below 256 and at most 0.8 % too small above.\n\n" +
           quantityTable() +
           "\n## Budgets\n\n"
           "A sequence with `statistics: {budgets: {FIGURE: LIMIT}}`, or `--budget FIGURE=LIMIT` on the command line, "
           "holds every frame to\n"
           "limits: `overdraw.p95: 6` is at most 6, `{min: 1, max: 6}` also at least 1; the limit itself is allowed. A "
           "figure is a counter, or a\n"
           "quantity with one of the figures above. Judged is the frame as a whole, its lights, casters and materials "
           "combined as *of several*\n"
           "says; `stencil.*`, which a whole frame has not, light by light (it reads counts, so the skips that change "
           "them are off). Where any frame breaks a budget, "
           "everything "
           "is still written, each\n"
           "broken budget has a line on stderr with the worst frame, its value and how far it is over, and the exit "
           "code is 1. A budget on\n"
           "what no frame has is broken too; so is a `min` where one frame lacks the number.\n"
           "\n"
           "`time.*` needs `diagnostics: {profile: true}`. `time.frame` has all that the run was asked for in it, so "
           "what shadows cost is\n"
           "`time.frame.ratio`: the picture alone with shadows to the picture without, rendered for it, in turn, by "
           "renderers of their own\n"
           "(which `memory.device` then counts); `diagnostics.repeats` steadies it. Budgets on time or memory alone "
           "count nothing, so they\n"
           "cost nothing else. No file is needed for a budget; those that are written have the results: JSON under "
           "`budgets`, the page as a\n"
           "table. `umbrage stats` judges them again of the frames it is given, with those of `--budget`, and of all "
           "parts that it merges.\n"
           "\n## Files\n\n"
           "**JSON** (`statistics.path: FILE.json`): a head (`sequence`, `version`, `device`, `clock`), the tables "
           "above, `budgets`, `frames`, and a\n"
           "`summary` of the sequence with totals, means, largest values and the ten casters with most fill. `umbrage "
           "schema --statistics`\n"
           "is its JSON Schema. Parts are nested: `frames[i].lights.ID.casters.PATH.values`.\n"
           "\n"
           "**CSV** (`FILE.csv`, or `umbrage stats FILE.json --csv FILE.csv`): tidy, "
           "`frame,light,caster,material,counter,unit,value`, one number\n"
           "a line. Empty fields mean the whole. A distribution is five lines: `overdraw.mean`, `overdraw.p50` and so "
           "on.\n"
           "\n"
           "**HTML** (`statistics.page: FILE.html`, or `umbrage stats FILE.json --html FILE.html`): one file, without "
           "network: curves over\n"
           "the frames, histograms, casters, tables to sort. Written by `umbrage render` it has a thumbnail of each "
           "frame.\n"
           "\n## Commands\n\n"
           "    umbrage stats FILE.json...                      # a table of each sequence\n"
           "    umbrage stats FILE.json --frames 10-20 --light 'Torch*' --counter 'overdraw.*'\n"
           "    umbrage stats shard*.json --merge ALL.json      # parts of one sequence\n"
           "    umbrage stats FILE.json --compare AFTER.json    # what changed\n"
           "    umbrage stats FILE.json --compare AFTER.json --tolerance 'overdraw.*=0.01'    # exit code 1 where "
           "more\n"
           "    umbrage stats FILE.json --plot FILE.svg --counter overdraw.fragments    # or FILE.png\n"
           "    umbrage stats FILE.json --csv FILE.csv --html FILE.html\n"
           "    umbrage stats FILE.json --budget overdraw.p95=6 --budget 'edges.silhouette={min: 1}'    # exit code 1 "
           "where not\n"
           "\n"
           "`--merge` takes different frames, or the same frame in several parts, but never two values for one "
           "place.\n"
           "\n"
           "Numbers in ms and MiB, and ratios of them, are measured and differ from run to run; all others are counts "
           "and must not. "
           "`--compare` marks a count\n"
           "with `*` where any frame differs. Measured numbers are paired frame by frame, and the ratio is the median "
           "of "
           "the frames' ratios; its\n"
           "95 % interval is that of the sign test (two order statistics, whatever the distribution), and only an "
           "interval without 1 is marked.\n"
           "Fewer than six frames have none. The frames of a run share a machine and its moods: repeat runs before you "
           "believe small changes.\n"
           "\n"
           "With `--tolerance GLOB=SHARE` the second file is judged by the first, column by column: the worst frame "
           "may "
           "be off by that share of\n"
           "the first's value, `skip` leaves columns out, and the last that matches counts. Other counts must be "
           "equal; "
           "what is measured is\n"
           "skipped. Frames or numbers that one of them lacks are differences.\n";
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
// golden: the rules of comparison.
#include "job/golden_rules.h"
#include "job/job_types.h"

namespace umbrage {
namespace {

/// A text without a default.
template <class S>
Field<S> needed(const std::string& key, const Type<std::string>& type, std::string S::*member,
                const std::string& meaning) {
    return fieldThrough<S, std::string>(
               key, type, [member](S& into, const std::string& value) { into.*member = value; }, meaning)
        .required();
}

Type<std::vector<GoldenLimit>> limits() {
    const auto limit = mapping<GoldenLimit>(
        "limit", "How far a metric may go. At least one of `fail` and `warn`.",
        {
            needed<GoldenLimit>("metric", choice(namesOf(kMetrics)), &GoldenLimit::metric, meaningsOf(kMetrics)),
            field<GoldenLimit>("fail", opinion(number()), &GoldenLimit::fail, "More than this (of psnr: less) fails")
                .unset("does not fail"),
            field<GoldenLimit>("warn", opinion(number()), &GoldenLimit::warn, "More than this (of psnr: less) warns")
                .unset("does not warn"),
        },
        [](const GoldenLimit& made, const YamlNode& node) {
            if (!made.fail && !made.warn) refuse(node, "the limit limits nothing", "add fail: NUMBER or warn: NUMBER");
        });
    using Entries = std::vector<std::pair<Located<std::string>, GoldenLimit>>;
    return converted<std::vector<GoldenLimit>>(dictionary(limit, "a mapping {name: limit}"),
                                               [](const Entries& entries, const YamlNode&) {
                                                   std::vector<GoldenLimit> made;
                                                   for (const auto& [name, entry] : entries) {
                                                       made.push_back(entry);
                                                       made.back().name = name.value;
                                                   }
                                                   return made;
                                               });
}

Type<std::vector<GoldenRule>> rules() {
    const auto rule = mapping<GoldenRule>(
        "golden rule", "What holds for some pictures. What it leaves out comes from the rules before it that match.",
        {
            field<GoldenRule>("tolerance", opinion(number(atLeast(0))), &GoldenRule::tolerance,
                              "What fraction and densest let pass in a channel")
                .unset("0"),
            field<GoldenRule>("window", opinion(integer(between(1, 4096))), &GoldenRule::window,
                              "Side of the window of densest")
                .in("pixels")
                .unset("11"),
            field<GoldenRule>("all", opinion(limits()), &GoldenRule::all, "Limits, every one of which must hold")
                .unset("max-abs 0"),
            field<GoldenRule>("any", opinion(limits()), &GoldenRule::any, "Limits, one of which suffices")
                .unset("none"),
            field<GoldenRule>("skip", text("a reason"), &GoldenRule::skip, "These are not compared, because ...")
                .unset("compared"),
            field<GoldenRule>("expectFailure", text("a reason"), &GoldenRule::expectFailure,
                              "These differ, because ...; if one does not, that fails")
                .unset("expected to pass"),
        });
    using Entries = std::vector<std::pair<Located<std::string>, GoldenRule>>;
    return converted<std::vector<GoldenRule>>(
        dictionary(rule, "a mapping {default, an AOV, or a glob of file names: rule}"),
        [](const Entries& entries, const YamlNode&) {
            std::vector<GoldenRule> made;
            for (const auto& [pattern, entry] : entries) {
                made.push_back(entry);
                made.back().pattern = pattern.value;
            }
            return made;
        });
}

Field<GoldenRules> rulesField() {
    return field<GoldenRules>("rules", rules(), &GoldenRules::rules,
                              "Limits by default, for an AOV, or for a glob of file names; later ones win")
        .unset("everything is equal");
}

Field<GoldenRules> devicesField() {
    const auto pair = mapping<GoldenPair>(
        "golden devices",
        "Goldens of one device and output of another: compared where `--other-device` allows it, by these rules alone. "
        "A device is its \"renderer, version, processor\" in manifest.json.",
        {
            needed<GoldenPair>("golden", text("a glob"), &GoldenPair::golden, "The goldens' device"),
            needed<GoldenPair>("output", text("a glob"), &GoldenPair::output, "The output's"),
            field<GoldenPair>("rules", rules(), &GoldenPair::rules, "As above").required(),
        });
    return field<GoldenRules>("devices", listOf(pair, "a list of pairs"), &GoldenRules::devices,
                              "What holds between two devices; the first that matches")
        .unset("0.2 % of the pixels may differ by more than 0.02, a quarter of those in a window; integers warn");
}

/// A share, or skip.
Type<std::optional<double>> tolerance() {
    const auto share = opinion(number(atLeast(0)));
    const auto skip = converted<std::optional<double>>(
        choice({"skip"}), [](const std::string&, const YamlNode&) { return std::optional<double>(); });
    Type<std::optional<double>> type = either(share, skip, [](const YamlNode&) { return true; });
    type.read = [share = share.read, skip = skip.read](const YamlNode& node, const std::string& name) {
        return numberOf(node) ? share(node, name) : skip(node, name);
    };
    return type;
}

Field<GoldenRules> statisticsField() {
    using Entries = std::vector<std::pair<Located<std::string>, std::optional<double>>>;
    const auto tolerances = converted<std::vector<StatisticsTolerance>>(
        dictionary(tolerance(), "a mapping {glob of counters and figures: share, or skip}"),
        [](const Entries& entries, const YamlNode&) {
            std::vector<StatisticsTolerance> made;
            for (const auto& [glob, share] : entries) made.push_back({glob.value, share});
            return made;
        });
    return field<GoldenRules>("statistics", tolerances, &GoldenRules::statistics,
                              "Shares of the golden's value that columns of statistics.json may be off by; later ones "
                              "win")
        .unset("counts are equal, what is measured is skipped");
}

}  // namespace

Type<JobGolden> goldenSettings() {
    const auto inRules = [](Field<GoldenRules> of) {
        Field<JobGolden> made{of.key, of.meaning, of.unit, of.byDefault, of.isRequired, of.text, of.schema, of.pages};
        made.read = [read = of.read](JobGolden& golden, const YamlNode& node) { read(golden.rules, node); };
        return made;
    };
    return mapping<JobGolden>(
        "golden", "Golden frames, for `umbrage compare` and `umbrage accept`.",
        {
            needed<JobGolden>("path", text("a path"), &JobGolden::path, "Their folder, from this file's folder"),
            inRules(rulesField()),
            inRules(devicesField()),
            inRules(statisticsField()),
        });
}

GoldenRules readGoldenRules(const std::filesystem::path& file) {
    static const Type<GoldenRules> type =
        mapping<GoldenRules>("golden rules", "A file of rules.", {rulesField(), devicesField(), statisticsField()});
    return type.read(parseYaml(contentsOf(file), file.string()), "the file");
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include "golden/compare_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "error.h"
#include "golden/compare_images.h"
#include "golden/compare_statistics.h"
#include "image/image.h"
#include "job/glob.h"
#include "job/yaml_tree.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

/// One picture to be looked at: where its two files are.
struct Pair {
    std::string name;
    ManifestImage image;
    fs::path golden, output;
    ImageRules rules;
};

ImageResult compareFiles(const Pair& pair) {
    ImageResult result;
    try {
        const bool equal = equalFiles(pair.golden, pair.output);
        const StoredImage output = codec().read(pair.output);
        result = equal ? compareImages(output, output, pair.rules, true)
                       : compareImages(codec().read(pair.golden), output, pair.rules);
    } catch (const Error& error) {
        result.outcome = Outcome::Unreadable;
        result.reason = error.what();
    }
    return result;
}

ImageResult resultOf(const Pair& pair, Outcome outcome, const std::string& reason) {
    ImageResult result;
    result.name = pair.name;
    result.aov = pair.image.aov;
    result.frame = pair.image.frame;
    result.outcome = outcome;
    result.reason = reason;
    return result;
}

/// In parallel; results come in the order of the pairs whatever the number of threads.
std::vector<ImageResult> compareAll(const std::vector<Pair>& pairs, const CompareOptions& options) {
    std::vector<ImageResult> results(pairs.size());
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::size_t done = 0;
    std::exception_ptr failed;
    const auto work = [&] {
        for (std::size_t i = next++; i < pairs.size(); i = next++) {
            try {
                ImageResult result = compareFiles(pairs[i]);
                result.name = pairs[i].name;
                result.aov = pairs[i].image.aov;
                result.frame = pairs[i].image.frame;
                results[i] = std::move(result);
            } catch (...) {
                const std::lock_guard lock(mutex);
                failed = std::current_exception();
                return;
            }
            const std::lock_guard lock(mutex);
            if (options.progress) options.progress(++done, pairs.size());
        }
    };
    {
        const unsigned wanted = options.threads > 0 ? unsigned(options.threads) : std::thread::hardware_concurrency();
        std::vector<std::jthread> threads;
        for (unsigned t = 1; t < std::max(1u, wanted) && t < pairs.size(); ++t) threads.emplace_back(work);
        work();
    }
    if (failed) std::rethrow_exception(failed);
    return results;
}

/// The rules between the devices, or those of one device where both are the same.
std::span<const GoldenRule> chooseRules(Comparison& comparison, const CompareOptions& options) {
    static const std::vector<GoldenRule> ofOthers = rulesOfOtherDevices();
    if (!comparison.goldenFrom || !comparison.outputFrom) {
        const bool golden = !comparison.goldenFrom;
        comparison.notes.push_back(fmt::format("{} {} no {}: whether one device made both is not known",
                                               golden ? comparison.golden : comparison.output, "has", kManifestName));
        return options.rules.rules;
    }
    const std::string theirs = deviceOf(*comparison.goldenFrom), ours = deviceOf(*comparison.outputFrom);
    if (comparison.goldenFrom->job != comparison.outputFrom->job) {
        comparison.notes.push_back(
            "the goldens were made of another job: sequence, scene or colour have changed since");
    }
    if (comparison.goldenFrom->sameDevice(*comparison.outputFrom)) return options.rules.rules;
    if (!options.otherDevice) {
        throw Error(ErrorKind::Input, comparison.golden,
                    fmt::format("the goldens were made by \"{}\", the output by \"{}\"", theirs, ours),
                    "compare on the goldens' device, or allow it with --other-device, by rules of its own "
                    "(golden.devices)");
    }
    comparison.foreignDevice = true;
    for (const GoldenPair& pair : options.rules.devices) {
        if (matchesGlob(pair.golden, theirs) && matchesGlob(pair.output, ours)) {
            comparison.notes.push_back(
                fmt::format("judged by the rules of the devices \"{}\" and \"{}\"", pair.golden, pair.output));
            return pair.rules;
        }
    }
    comparison.notes.push_back(
        fmt::format("another device (\"{}\", the goldens' \"{}\"): judged by the rules for "
                    "devices that nobody named",
                    ours, theirs));
    return ofOthers;
}

void compareStatistics(Comparison& comparison, const CompareOptions& options) {
    const fs::path golden = fs::path(comparison.golden) / kGoldenStatistics;
    const fs::path output = fs::path(comparison.output) / kGoldenStatistics;
    if (!fs::exists(golden)) return;
    if (fs::exists(output)) {
        comparison.statistics = compareWithin(readStatistics(golden), readStatistics(output), options.rules.statistics);
    } else {
        comparison.statistics.push_back({.column = kGoldenStatistics,
                                         .outcome = Outcome::MissingOutput,
                                         .reason = "the goldens have statistics, the output none"});
    }
}

void compareFolders(Comparison& comparison, const CompareOptions& options) {
    const fs::path golden = comparison.golden, output = comparison.output;
    const std::optional<Manifest> theirs = readManifest(golden), ours = readManifest(output);
    if (theirs) comparison.goldenFrom = theirs->from;
    if (ours) comparison.outputFrom = ours->from;
    const std::span<const GoldenRule> rules = chooseRules(comparison, options);

    const std::vector<std::string> goldens = picturesIn(golden), outputs = picturesIn(output, golden);
    const std::set<std::string> hasGolden(goldens.begin(), goldens.end()), hasOutput(outputs.begin(), outputs.end());
    std::set<std::string> names(goldens.begin(), goldens.end());
    names.insert(outputs.begin(), outputs.end());
    const std::map<std::string, ManifestImage>* asked = options.asked ? &*options.asked
                                                        : ours        ? &ours->images
                                                                      : nullptr;
    if (asked) {
        for (const auto& [name, image] : *asked) names.insert(name);
    }
    if (names.empty()) {
        throw Error(ErrorKind::Input, comparison.golden, "there is no picture to compare, here or in the output",
                    "a comparison of nothing is no pass; accept makes goldens of an output");
    }

    std::vector<Pair> pairs;
    for (const std::string& name : names) {
        Pair pair{name, namedImage(name), golden / name, output / name, {}};
        const auto known = asked ? asked->find(name) : decltype(asked->find(name)){};
        const bool isAsked = !asked || known != asked->end();
        if (asked && isAsked) pair.image = known->second;
        pair.rules = rulesFor(rules, name, pair.image.aov);
        const auto add = [&](Outcome outcome, const std::string& reason) {
            const bool skipped = !pair.rules.skip.empty();
            comparison.images.push_back(
                resultOf(pair, skipped ? Outcome::Skipped : outcome, skipped ? pair.rules.skip : reason));
        };
        if (!hasOutput.contains(name)) {
            if (options.asked && !isAsked) {
                add(Outcome::Skipped, "the sequence, as it was asked for here, does not make this frame");
            } else {
                add(Outcome::MissingOutput,
                    hasGolden.contains(name) ? "the golden has no output" : "neither golden nor output is there");
            }
        } else if (!isAsked) {
            add(Outcome::ExtraOutput, "nobody asked for it: it is left from another run, or was put there");
        } else if (!hasGolden.contains(name)) {
            add(Outcome::MissingGolden, "there is no golden; the output is left as a candidate");
        } else {
            pairs.push_back(std::move(pair));
        }
    }
    compareStatistics(comparison, options);
    const std::vector<ImageResult> results = compareAll(pairs, options);
    comparison.images.insert(comparison.images.end(), results.begin(), results.end());
    std::ranges::sort(comparison.images, {}, &ImageResult::name);
}

void compareTwo(Comparison& comparison, const CompareOptions& options) {
    const fs::path golden = comparison.golden, output = comparison.output;
    if (const auto theirs = readManifest(golden.parent_path())) comparison.goldenFrom = theirs->from;
    if (const auto ours = readManifest(output.parent_path())) comparison.outputFrom = ours->from;
    const std::span<const GoldenRule> rules = chooseRules(comparison, options);
    Pair pair{output.filename().generic_string(), namedImage(output.filename().string()), golden, output, {}};
    pair.rules = rulesFor(rules, pair.name, pair.image.aov);
    comparison.images = compareAll({pair}, options);
}

}  // namespace

std::vector<std::string> picturesIn(const fs::path& folder, const fs::path& except) {
    std::vector<std::string> names;
    std::error_code failed, unknown;
    for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->is_directory() && !except.empty() && fs::equivalent(entry->path(), except, unknown)) {
            entry.disable_recursion_pending();
            continue;
        }
        const std::string extension = entry->path().extension().string();
        if (!entry->is_regular_file() || (extension != ".png" && extension != ".exr")) continue;
        names.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    if (failed) throw Error(ErrorKind::Input, folder.string(), failed.message());
    std::ranges::sort(names);
    return names;
}

ManifestImage namedImage(const std::string& name) {
    const std::string file = name.substr(name.rfind('/') + 1);
    const std::size_t ext = file.rfind('.'),
                      frame = ext == 0 || ext == std::string::npos ? ext : file.rfind('.', ext - 1);
    if (frame == std::string::npos || ext == std::string::npos || frame + 1 >= ext || ext - frame > 9) return {};
    const std::string digits = file.substr(frame + 1, ext - frame - 1);
    if (digits.find_first_not_of("0123456789") != std::string::npos) return {};
    return {file.substr(0, frame), std::stoi(digits)};
}

bool equalFiles(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    if (fs::file_size(a, failed) != fs::file_size(b, failed) || failed) return false;
    return contentsOf(a) == contentsOf(b);
}

Comparison comparePictures(const fs::path& golden, const fs::path& output, const CompareOptions& options) {
    for (const fs::path& path : {golden, output}) {
        std::error_code failed;
        if (!fs::exists(path, failed)) {
            throw Error(ErrorKind::Input, path.string(), "there is no such file or folder",
                        path == golden ? "umbrage accept makes goldens of an output" : "");
        }
    }
    if (fs::is_directory(golden) != fs::is_directory(output)) {
        throw Error(ErrorKind::Usage, output.string(), "a folder can only be compared with a folder");
    }
    Comparison comparison;
    comparison.golden = golden.string();
    comparison.output = output.string();
    if (fs::is_directory(golden)) {
        compareFolders(comparison, options);
    } else {
        compareTwo(comparison, options);
    }
    return comparison;
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include "golden/accept.h"

#include <fmt/format.h>

#include <set>

#include "error.h"
#include "golden/compare_folders.h"
#include "golden/compare_images.h"
#include "image/image.h"
#include "job/yaml_tree.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;
using Kind = GoldenChange::Kind;

std::string differenceOf(const fs::path& golden, const fs::path& output) {
    try {
        const ImageResult result = compareImages(codec().read(golden), codec().read(output), {});
        if (result.figures.empty()) return result.reason;
        std::string text;
        for (const Figure& figure : result.figures) {
            if (figure.metric != "max-abs" && figure.metric != "fraction" && figure.metric != "uint-different")
                continue;
            text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", figure.metric, figure.value);
        }
        return result.worst.first < 0 ? "the same pixels in other bytes" : text;
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

AcceptPlan planAccept(const fs::path& golden, const fs::path& output,
                      const std::optional<std::map<std::string, ManifestImage>>& asked, bool statistics) {
    AcceptPlan plan{golden, output, {}, 0, readManifest(golden), readManifest(output)};
    const std::map<std::string, ManifestImage>* known = asked             ? &*asked
                                                        : plan.outputFrom ? &plan.outputFrom->images
                                                                          : nullptr;
    const std::vector<std::string> outputs = picturesIn(output, golden);
    std::vector<std::string> goldens;
    if (fs::exists(golden)) goldens = picturesIn(golden);
    std::set<std::string> names(goldens.begin(), goldens.end());
    const std::set<std::string> hasGolden = names, hasOutput(outputs.begin(), outputs.end());
    for (const std::string& name : outputs) {
        if (!known || known->contains(name)) names.insert(name);
    }
    for (const std::string& name : names) {
        const bool isOutput = hasOutput.contains(name) && (!known || known->contains(name));
        if (!isOutput) {
            if (!asked || asked->contains(name)) plan.changes.push_back({Kind::Removed, name, {}});
        } else if (!hasGolden.contains(name)) {
            plan.changes.push_back({Kind::Added, name, {}});
        } else if (equalFiles(golden / name, output / name)) {
            ++plan.unchanged;
        } else {
            plan.changes.push_back({Kind::Changed, name, differenceOf(golden / name, output / name)});
        }
    }
    const fs::path theirs = golden / kGoldenStatistics, ours = output / kGoldenStatistics;
    if (fs::exists(ours) && (statistics || fs::exists(theirs))) {
        if (equalFiles(theirs, ours)) {
            ++plan.unchanged;
        } else {
            plan.changes.push_back({fs::exists(theirs) ? Kind::Changed : Kind::Added, kGoldenStatistics, {}});
        }
    }
    return plan;
}

void accept(const AcceptPlan& plan) {
    Manifest manifest;
    if (plan.goldenFrom) manifest = *plan.goldenFrom;
    if (plan.outputFrom) {
        manifest.from = plan.outputFrom->from;
        manifest.images.insert(plan.outputFrom->images.begin(), plan.outputFrom->images.end());
    }
    for (const GoldenChange& change : plan.changes) {
        const fs::path golden = plan.golden / change.name;
        if (change.kind == Kind::Removed) {
            std::error_code failed;
            fs::remove(golden, failed);
            if (failed) throw Error(ErrorKind::Output, golden.string(), failed.message());
            manifest.images.erase(change.name);
        } else {
            writeWhole(golden, contentsOf(plan.output / change.name));
        }
    }
    if (!plan.outputFrom) {
        // Nobody knows what made these: a manifest of what was there before would lie.
        fs::remove(plan.golden / kManifestName);
        return;
    }
    std::erase_if(manifest.images, [&](const auto& image) { return !fs::exists(plan.golden / image.first); });
    writeManifest(plan.golden, manifest);
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <exception>
#include <filesystem>

#include "bench/bench_run.h"
#include "commands.h"
#include "exit_codes.h"
#include "interrupt.h"
#include "progress.h"
#include "version.h"

namespace umbrage {
namespace {

class Watch : public BenchObserver {
public:
    explicit Watch(Progress& progress) : progress_(progress) {}

    void note(const std::string& text) override { progress_.note(text); }
    void started(std::size_t stepCount, const std::string& what) override { progress_.started(stepCount, what); }
    void advanced(const std::string& step) override { progress_.advanced(step); }

private:
    Progress& progress_;
};

struct Header {
    std::string command, device, driver;
};

std::string jsonOf(const BenchResult& result, const Header& header) {
    nlohmann::ordered_json json = {{"umbrage", kVersion},
                                   {"command", header.command},
                                   {"device", header.device},
                                   {"driver", header.driver},
                                   {"measurements", nlohmann::ordered_json::array()}};
    for (const BenchTable& table : result.tables) json["measurements"].push_back(table.json());
    json["plots"] = nlohmann::ordered_json::object();
    for (const auto& [name, plot] : result.plots) {
        nlohmann::ordered_json& series = json["plots"][name] = {{"x", plot.xLabel}, {"y", plot.yLabel}};
        for (const PlotSeries& one : plot.series) series["series"][one.name] = one.points;
    }
    return json.dump(2) + "\n";
}

std::string csvOf(const BenchResult& result) {
    std::string text = BenchTable::csvHead();
    for (const BenchTable& table : result.tables) text += table.csv();
    return text;
}

std::string markdownOf(const BenchResult& result, const Header& header) {
    std::string text = fmt::format(
        "# Measurements\n\nMade by this command; changes by hand are lost:\n\n    {}\n\numbrage {} on {} ({}).\n",
        header.command, kVersion, header.device, header.driver);
    for (const BenchTable& table : result.tables) text += fmt::format("\n{}", table.markdown());
    return text;
}

void writeFiles(const BenchResult& result, const BenchCommandOptions& options, const Header& header) {
    if (!options.json.empty()) writeWhole(options.json, jsonOf(result, header));
    if (!options.csv.empty()) writeWhole(options.csv, csvOf(result));
    if (!options.markdown.empty()) writeWhole(options.markdown, markdownOf(result, header));
    const std::filesystem::path folder = options.out;
    for (const auto& [name, plot] : result.plots) {
        const Drawing drawing = layOut(plot);
        writeWhole(folder / (name + ".svg"), svgOf(drawing));
        codec().write(folder / (name + ".png"), pictureOf(drawing).file({}));
    }
    for (const auto& [name, picture] : result.pictures) codec().write(folder / (name + ".png"), picture.file({}));
}

}  // namespace

int runBench(const BenchCommandOptions& options, bool quiet) {
    Bench bench = readBench(options.file);
    if (options.rounds > 0) bench.rounds = options.rounds;
    const std::atomic<bool>& interrupted = watchForInterrupts();
    const std::future<void> prefetch = prefetchCodec();
    const gpu::Context context(options.device);
    const gpu::DeviceInfo& device = context.info();
    BenchResult result;
    {
        Progress progress(options.progress, quiet);
        progress.note(fmt::format("device: {} ({})", device.renderer, device.version));
        Watch watch(progress);
        result = runBench(bench, context, options.allowExternalFiles, watch, interrupted);
    }
    std::exception_ptr failed;  // the tables are printed even where a file cannot be written
    try {
        writeFiles(result, options, {options.commandLine, device.renderer, device.version});
    } catch (const Error&) {
        failed = std::current_exception();
    }
    const char* separator = "";
    for (const BenchTable& table : result.tables) {
        fmt::print("{}{}", separator, table.text());
        separator = "\n";
    }
    for (const std::string& wrong : result.wrong) fmt::print("wrong: {}\n", wrong);
    if (failed) std::rethrow_exception(failed);
    if (interrupted) return interruptExitCode();
    return result.wrong.empty() ? kOk : kFramesFailed;
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include "report/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "job/frame_range.h"
#include "report/statistics_table.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

/// Of a light. A new skip of casters is one line here.
struct Column {
    std::string_view counter, title;
};
constexpr Column kColumns[] = {
    {"casters.outOfReach", "out of reach"},
    {"casters.outOfView", "out of view"},
    {"casters.ended", "ended"},
    {"casters.zfail", "by z-fail"},
    {"edges.silhouette", "edges"},
    {"quads", "sides"},
    {"quads.halved", "halved"},
    {"caps.light", "light caps"},
    {"caps.dark", "dark caps"},
    {"overdraw.updates", "updates"},
    {"overdraw.fragments", "fragments"},
};

class Explaining {
public:
    explicit Explaining(const StatisticsFile& file) : file_(file) {
        for (std::size_t i = 0; i < file.counters.size(); ++i) indexOf_[file.counters[i].name] = i;
    }

    /// Of a frame, without its number.
    std::string textOf(const FrameFigures& frame) const {
        const auto whole = frame.find(StatisticsPlace{});
        if (whole == frame.end()) return "";
        std::vector<std::vector<std::string>> rows{{"light"}};
        std::vector<bool> isText{true};
        for (const Column& column : kColumns) {
            rows[0].emplace_back(column.title);
            isText.push_back(false);
        }
        rows[0].emplace_back("of all");
        isText.push_back(false);
        const double all = valueOf(whole->second, "overdraw.fragments").value_or(0.0);
        for (const auto& [place, figures] : frame) {
            if (place.light.empty() || !place.caster.empty()) continue;
            rows.push_back(rowOf(place.light, figures, all));
        }
        const std::string table = rows.size() > 1 ? alignedTable(std::move(rows), isText) : "";
        return headOf(whole->second) + indented(table);
    }

    std::string legend() const {
        std::string text;
        for (const Column& column : kColumns) {
            const auto found = indexOf_.find(column.counter);
            if (found == indexOf_.end()) continue;
            text += fmt::format("{}: {} ({})\n", column.title, file_.counters[found->second].doc, column.counter);
        }
        return text;
    }

private:
    std::optional<double> valueOf(const Figures& figures, std::string_view counter) const {
        const auto index = indexOf_.find(counter);
        if (index == indexOf_.end()) return std::nullopt;
        const auto value = figures.values.find(index->second);
        return value == figures.values.end() ? std::nullopt : std::optional(value->second);
    }

    std::string headOf(const Figures& whole) const {
        const auto number = [&](const char* counter) { return readableNumber(valueOf(whole, counter).value_or(0.0)); };
        std::string text = fmt::format("  {} triangles in {} placed meshes", number("triangles"), number("casters"));
        const auto add = [&](const char* counter, std::string_view what) {
            if (valueOf(whole, counter).value_or(0.0) != 0.0) text += fmt::format("; {} {}", number(counter), what);
        };
        add("lights.skipped", "lights left out");
        add("lights.fellBack", "lights not counted as chosen");
        add("channels.idle", "animation channels left out");
        return text + "\n";
    }

    std::vector<std::string> rowOf(const std::string& light, const Figures& figures, double allFragments) const {
        std::vector<std::string> row{light};
        if (valueOf(figures, "lights.skipped").value_or(0.0) != 0.0) row.front() += " (off)";
        for (const Column& column : kColumns) {
            const std::optional<double> value = valueOf(figures, column.counter);
            row.push_back(value ? readableNumber(*value) : "");
        }
        const double fragments = valueOf(figures, "overdraw.fragments").value_or(0.0);
        row.push_back(allFragments > 0.0 && fragments > 0.0 ? fmt::format("{:.1f} %", 100.0 * fragments / allFragments)
                                                            : "");
        return row;
    }

    static std::string indented(const std::string& text) {
        std::string result;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = text.find('\n', begin) + 1;
            result += "  " + text.substr(begin, end - begin);
            begin = end;
        }
        return result;
    }

    const StatisticsFile& file_;
    std::map<std::string, std::size_t, std::less<>> indexOf_;
};

/// Frames one after another of which the same is said.
struct Run {
    std::vector<int> frames;
    int as = 0;           // the first frame of which it was said
    bool reused = false;  // they were not rendered
    std::string text;
};

}  // namespace

std::string explanation(const StatisticsFile& file) {
    const Explaining explaining(file);
    std::map<std::string, int> firstWith;
    std::vector<Run> runs;
    const auto reusedCounter = std::ranges::find(file.counters, "frames.reused", &StatisticsFile::CounterEntry::name);
    for (const auto& [frame, figures] : file.frames) {
        std::string text = explaining.textOf(figures);
        const auto whole = figures.find(StatisticsPlace{});
        bool reused = false;
        if (whole != figures.end() && reusedCounter != file.counters.end()) {
            const auto value = whole->second.values.find(std::size_t(reusedCounter - file.counters.begin()));
            reused = value != whole->second.values.end() && value->second != 0.0;
        }
        const int as = firstWith.emplace(text, frame).first->second;
        const bool continues = !runs.empty() && runs.back().as == as && runs.back().reused == reused && as != frame &&
                               runs.back().frames.front() != as;
        if (!continues) runs.push_back({{}, as, reused, std::move(text)});
        runs.back().frames.push_back(frame);
    }
    std::string result;
    for (const Run& run : runs) {
        result += fmt::format("frame{} {}", run.frames.size() > 1 ? "s" : "", FrameRange::textOf(run.frames));
        if (run.as == run.frames.front()) {
            result += "\n" + run.text;
        } else {
            result += fmt::format(": as frame {}{}\n", run.as, run.reused ? ", and not rendered again" : "");
        }
    }
    return result + "\n" + explaining.legend();
}

}  // namespace umbrage

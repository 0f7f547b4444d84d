// SPDX-License-Identifier: Apache-2.0
// growth: of the bench file.
#include <fmt/ranges.h>

#include "bench/bench_file_parts.h"
#include "diagnostics/counters.h"

namespace umbrage {
namespace {

using Value = std::vector<double>;

Type<Value> value() {
    const Type<Value> single = converted<Value>(number(), [](double one, const YamlNode&) { return Value{one}; });
    const Type<Value> list = notEmpty(listOf(number(), "a list of numbers"));
    Type<Value> type = either(single, list, [](const YamlNode& node) { return node.isScalar(); });
    type.read = [single, list](const YamlNode& node, const std::string& name) {
        return node.isSequence() ? list.read(node, name) : single.read(node, name);
    };
    return type;
}

}  // namespace

Type<std::vector<BenchGrowth>> growths() {
    using Growth = BenchGrowth;
    std::vector<std::string> counters;
    for (const CounterInfo& counter : kCounters) counters.emplace_back(counter.name);
    return listOf(
        mapping<Growth>(
            "growth",
            "How a frame's cost grows with one value of a sequence, all else being equal: a table, and plots of whole "
            "frames and of shadows.",
            {
                field<Growth>("name", fileStem(), &Growth::name, "Of the rows and files").required(),
                field<Growth>("sequence", located(text()), &Growth::sequence, "Name of the sequence").required(),
                field<Growth>("set", text("a path"), &Growth::set, "Which value, as --set has it").required(),
                field<Growth>("values", notEmpty(listOf(value(), "a list of numbers or lists")), &Growth::values,
                              "What it is set to, from cheap to costly; of a list, the first number is on the axis")
                    .required(),
                field<Growth>("label", text(), &Growth::label, "What is on the axis").unset("the name"),
                field<Growth>("by", choice(counters), &Growth::by,
                              "On the axis is this counter of the first frame by z-pass")
                    .unset("the value is"),
                field<Growth>("linear", boolean(), &Growth::isLinear, "Axes are linear, not logarithmic"),
                field<Growth>("patience", number(above(0)), &Growth::patienceSeconds,
                              "What took longer for a frame is not asked for later values")
                    .in("seconds"),
            },
            {}),
        "a list of growths");
}

std::string BenchGrowth::text(const Value& value) {
    return value.size() == 1 ? fmt::format("{}", value[0]) : fmt::format("[{}]", fmt::join(value, ", "));
}

std::string BenchGrowth::assignment(const Value& value) const {
    return fmt::format("{}={}", set, text(value));
}

}  // namespace umbrage

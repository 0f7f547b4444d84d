// SPDX-License-Identifier: Apache-2.0
// What a measurement found, as a table: each says its columns once, and text, Markdown, CSV and JSON are made of that.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace umbrage {

struct BenchColumn {
    std::string key;    // for programs
    std::string title;  // for people
    std::string doc;    // with the unit
    int decimals = -1;  // of numbers; -1: words
};

struct BenchCell {
    std::string words;
    std::optional<double> number;

    BenchCell() = default;
    BenchCell(std::string text) : words(std::move(text)) {}
    BenchCell(const char* text) : words(text) {}
    BenchCell(double value) : number(value) {}
};

struct BenchTable {
    std::string measurement, title;
    std::vector<BenchColumn> columns;
    std::vector<std::vector<BenchCell>> rows;  // as many cells as columns
    std::vector<std::string> remarks;

    std::string text() const;
    std::string markdown() const;
    nlohmann::ordered_json json() const;
    /// A line for each number: measurement, the words of its row, column, number.
    std::string csv() const;
    static std::string csvHead();

private:
    std::string cellText(std::size_t column, const BenchCell& cell) const;
    std::vector<std::vector<std::string>> texts() const;
    std::vector<bool> areWords() const;
};

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_table.h"

#include <fmt/format.h>

#include "diagnostics/csv_field.h"
#include "report/text_table.h"

namespace umbrage {

std::string BenchTable::cellText(std::size_t column, const BenchCell& cell) const {
    if (columns[column].decimals < 0) return cell.words;
    return cell.number ? fmt::format("{:.{}f}", *cell.number, columns[column].decimals) : "-";
}

std::vector<std::vector<std::string>> BenchTable::texts() const {
    std::vector<std::vector<std::string>> all(1);
    for (const BenchColumn& column : columns) all.front().push_back(column.title);
    for (const std::vector<BenchCell>& row : rows) {
        std::vector<std::string>& cells = all.emplace_back();
        for (std::size_t c = 0; c < columns.size(); ++c) cells.push_back(cellText(c, row[c]));
    }
    return all;
}

std::vector<bool> BenchTable::areWords() const {
    std::vector<bool> words;
    for (const BenchColumn& column : columns) words.push_back(column.decimals < 0);
    return words;
}

std::string BenchTable::text() const {
    std::string text = title + "\n" + alignedTable(texts(), areWords());
    for (const std::string& remark : remarks) text += remark + "\n";
    return text;
}

std::string BenchTable::markdown() const {
    std::string text = fmt::format("## {}\n\n{}\n", title, markdownTable(texts(), areWords()));
    for (const std::string& remark : remarks) text += remark + "\n\n";
    for (const BenchColumn& column : columns) {
        if (!column.doc.empty()) text += fmt::format("- {}: {}\n", column.title, column.doc);
    }
    return text;
}

nlohmann::ordered_json BenchTable::json() const {
    nlohmann::ordered_json made = {{"measurement", measurement}, {"title", title}, {"columns", nullptr}, {"rows", {}}};
    made["columns"] = nlohmann::ordered_json::object();
    for (const BenchColumn& column : columns) made["columns"][column.key] = column.doc;
    for (const std::vector<BenchCell>& row : rows) {
        nlohmann::ordered_json object;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (columns[c].decimals < 0) {
                object[columns[c].key] = row[c].words;
            } else if (row[c].number) {
                object[columns[c].key] = *row[c].number;
            }
        }
        made["rows"].push_back(object);
    }
    made["remarks"] = remarks;
    return made;
}

std::string BenchTable::csvHead() {
    return "measurement,row,column,value\n";
}

std::string BenchTable::csv() const {
    std::string text;
    for (const std::vector<BenchCell>& row : rows) {
        std::string words;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (columns[c].decimals < 0) words += (words.empty() ? "" : " ") + row[c].words;
        }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (!row[c].number) continue;
            text += fmt::format("{},{},{},{}\n", measurement, csvField(words), columns[c].key, *row[c].number);
        }
    }
    return text;
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
// The table for editors (JSON Schema) and for readers (Markdown).
#include <fmt/core.h>

#include <set>

#include "job/job_fields.h"
#include "job/reference_page.h"

namespace umbrage {
namespace {

// What would end a table cell.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

std::string pageText(const ReferencePage& page) {
    std::string text = fmt::format("\n## {}\n\n{}\n\n| key | value | default | meaning |\n|---|---|---|---|\n",
                                   page.title, page.meaning);
    for (const ReferencePage::Row& row : page.rows)
        text += fmt::format("| `{}` | {}{} | {} | {} |\n", row.key, cell(row.value),
                            row.unit.empty() ? "" : fmt::format("; {}", cell(row.unit)), cell(row.byDefault),
                            cell(row.meaning));
    return text;
}

}  // namespace

std::string referenceText(const std::vector<ReferencePage>& pages) {
    std::string text;
    std::set<std::string> written;
    for (const ReferencePage& page : pages) {
        if (written.insert(page.title).second) text += pageText(page);
    }
    return text;
}

std::string jobSchema() {
    return schemaText("umbrage sequence", sequenceType());
}

std::string jobReference() {
    const std::string text =
        "# The sequence file\n\n"
        "Every key of a sequence file, from the table that the parser itself uses: `umbrage schema --markdown` wrote "
        "this\n"
        "page, and `umbrage schema` writes the same as a JSON Schema for editors. Unknown keys, keys given twice and "
        "values\n"
        "of the wrong kind are errors with file, line and column. Strings that look like numbers are quoted, numbers "
        "never;\n"
        "numbers are decimal whatever they begin with. Relative paths are read from the folder of the sequence file.\n"
        "`--set path=value` changes any of it from the command line: `--set shadow.count=z-fail --set "
        "lights.0.intensity=40`.\n";
    return text + referenceText(sequenceType().pages);
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
// A table (field_table.h) for editors, as a JSON Schema, and for readers, as Markdown.
#pragma once

#include "job/field_table.h"

namespace umbrage {

/// A heading and a table for each mapping.
std::string referenceText(const std::vector<ReferencePage>& pages);

/// Draft 2020-12.
template <class T>
std::string schemaText(const std::string& title, const Type<T>& type) {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", title},
                   {"description", type.pages.front().meaning}};
    schema.update(type.schema);
    return schema.dump(2) + "\n";
}

}  // namespace umbrage

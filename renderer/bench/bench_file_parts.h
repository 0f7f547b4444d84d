// SPDX-License-Identifier: Apache-2.0
// Parts of the bench file's table, each in the file of its name, and types that they share.
#pragma once

#include "bench/bench_file.h"
#include "job/field_types.h"

namespace umbrage {

template <class T>
Type<std::vector<T>> notEmpty(const Type<std::vector<T>>& list) {
    Type<std::vector<T>> type = list;
    type.schema["minItems"] = 1;
    type.read = [read = list.read](const YamlNode& node, const std::string& name) {
        std::vector<T> values = read(node, name);
        if (values.empty()) refuse(node, name + " is empty");
        return values;
    };
    return type;
}

/// What it names becomes part of files' names.
inline Type<std::string> fileStem() {
    return converted<std::string>(
        text("a name"),
        [](const std::string& name, const YamlNode& node) {
            if (name.find_first_of("/\\") != std::string::npos) refuse(node, "a name of files has no slashes");
            return name;
        },
        [](const std::string& name) { return name; });
}

// bench_file_growth.cpp
Type<std::vector<BenchGrowth>> growths();

}  // namespace umbrage

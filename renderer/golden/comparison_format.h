// SPDX-License-Identifier: Apache-2.0
// What the writer, the reader and the schema of comparison files agree on.
#pragma once

#include <array>
#include <string_view>

#include "golden/comparison.h"

namespace umbrage {

inline constexpr std::string_view kComparisonFormat = "umbrage comparison 1";

struct ProvenanceField {
    const char* key;
    std::string Provenance::*text;
    const char* doc;
};
inline constexpr std::array kProvenanceFields{
    ProvenanceField{"renderer", &Provenance::renderer, "GL_RENDERER"},
    ProvenanceField{"version", &Provenance::version, "GL_VERSION"},
    ProvenanceField{"processor", &Provenance::processor,
                    "vector and FMA flags of the processor that a software device compiles for"},
    ProvenanceField{"tool", &Provenance::tool, "umbrage's version"},
    ProvenanceField{"job", &Provenance::job, "fingerprint of what shaped the pictures"},
};

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
// tinygltf behind its guard: it gets a validated document in which every URI is a name that only we can resolve, so
// it never touches the file system, and whatever it reports after that is an error.
#pragma once

// The declarations must match the installed library, which is built with the image writer.
#include <tiny_gltf.h>

#include "scene/gltf_budget.h"
#include "scene/gltf_document.h"
#include "scene/gltf_validate.h"

namespace umbrage {

/// Images are left encoded, in tinygltf::Image::image. @throws Error(Input)
tinygltf::Model buildModel(const GltfDocument& document, const GltfFacts& facts, MemoryBudget& budget);

}  // namespace umbrage

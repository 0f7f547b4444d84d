// SPDX-License-Identifier: Apache-2.0
// Which side of an edge a device puts samples on that lie exactly on it. GL only says that it is one of both.
#pragma once

namespace umbrage::gpu {

/// As if samples were moved a little along their row, and much less along their column: 1 to the right and down, -1 to
/// the left and up.
struct SampleTies {
    int right = 1, down = 1;
};

/// Draws two triangles to find out.
SampleTies findSampleTies();

}  // namespace umbrage::gpu

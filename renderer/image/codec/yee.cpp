// SPDX-License-Identifier: Apache-2.0
#include "image/codec/yee.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace umbrage {

std::size_t countYeeFailures(int width, int height, std::span<const float> golden, std::span<const float> output) {
    const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
    // The buffers are read only; OpenImageIO 2.4 has no constructor that says so.
    const OIIO::ImageBuf a(spec, const_cast<float*>(golden.data())), b(spec, const_cast<float*>(output.data()));
    OIIO::ImageBufAlgo::CompareResults result;
    return std::size_t(OIIO::ImageBufAlgo::compare_Yee(a, b, result));
}

}  // namespace umbrage

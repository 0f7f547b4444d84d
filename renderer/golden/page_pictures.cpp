// SPDX-License-Identifier: Apache-2.0
#include "golden/page_pictures.h"

#include "error.h"
#include "image/image.h"

namespace umbrage {
namespace {

/// Integers as floats, of which a page shows no more digits.
PagePicture pagePicture(const StoredImage& image) {
    PagePicture page{image.data.width, image.data.height, {}, {}, image.displayEncoded};
    page.values.resize(image.pixelCount() * image.channels.size());
    for (std::size_t k = 0; k < image.channels.size(); ++k) {
        page.channels.push_back(image.channels[k].name);
        const auto spread = [&](const auto& values) {
            for (std::size_t i = 0; i < values.size(); ++i)
                page.values[i * image.channels.size() + k] = float(values[i]);
        };
        std::visit(spread, image.channels[k].values);
    }
    return page;
}

std::optional<PagePicture> pagePicture(const std::string& file) {
    try {
        return pagePicture(codec().read(file));
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<PagePictures> picturesOf(const Comparison& comparison, const ImageResult& image) {
    return PagePictures{pagePicture(fileAt(comparison.golden, image)), pagePicture(fileAt(comparison.output, image))};
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
#include "image/codec/oiio_output.h"

#include <OpenImageIO/filesystem.h>
#include <fmt/format.h>

#include <set>

#include "error.h"

namespace umbrage {

EncodedFile encodeWithOiio(const std::filesystem::path& file, const std::string& format, const OIIO::ImageSpec& spec,
                           const void* pixels) {
    EncodedFile bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format);
    const bool done = output && output->set_ioproxy(&memory) && output->open("memory." + format, spec) &&
                      output->write_image(OIIO::TypeDesc::UNKNOWN, pixels) && output->close();
    if (!done) {
        throw Error(ErrorKind::Output, file.string(),
                    fmt::format("cannot encode: {}", output ? output->geterror() : OIIO::geterror()));
    }
    return bytes;
}

void checkImage(const std::filesystem::path& file, const ImageFile& image) {
    if (image.width < 1 || image.height < 1 || image.channels.empty()) {
        throw Error(ErrorKind::Output, file.string(),
                    fmt::format("there is nothing to write: {}x{} pixels, {} channels", image.width, image.height,
                                image.channels.size()));
    }
    std::set<std::string_view> names;
    for (const auto& channel : image.channels) {
        if (!names.insert(channel.name).second) {
            throw Error(ErrorKind::Output, file.string(),
                        fmt::format("there are two channels called '{}'", channel.name));
        }
    }
}

}  // namespace umbrage

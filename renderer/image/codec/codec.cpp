// SPDX-License-Identifier: Apache-2.0
// The module's face: Codec, and the one function it exports.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "error.h"
#include "image/codec/decode.h"
#include "image/codec/display_transform.h"
#include "image/codec/encode.h"
#include "image/codec/read.h"
#include "image/codec/yee.h"
#include "image/codec_module.h"

namespace umbrage {
namespace {

class OiioCodec final : public Codec {
public:
    OiioCodec() {
        OIIO::attribute("debug", 0);      // Debian's build would comment on files on stderr
        OIIO::ImageInput::create("png");  // finds the readers and writers now rather than at the first texture
    }

    DecodedImage decode(std::span<const std::byte> encoded, std::string_view name) const override {
        try {
            return decodeImage(encoded, name);
        } catch (const std::bad_alloc&) {
            throw Error(ErrorKind::Input, std::string(name), "the picture does not fit into memory", "scale it down");
        }
    }

    void write(const std::filesystem::path& file, const ImageFile& image) const override {
        const auto extension = file.extension();
        if (extension != ".png" && extension != ".exr") {
            throw Error(ErrorKind::Output, file.string(),
                        fmt::format("there is no writer for '{}' files", extension.string()), "use .png or .exr");
        }
        const EncodedFile bytes = extension == ".png" ? encodePng(file, image) : encodeExr(file, image);
        writeWhole(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

    StoredImage read(const std::filesystem::path& file) const override {
        try {
            return readStored(file);
        } catch (const std::bad_alloc&) {
            throw Error(ErrorKind::Input, file.string(), "the picture does not fit into memory", "scale it down");
        }
    }

    std::size_t yeeFailures(int width, int height, std::span<const float> golden,
                            std::span<const float> output) const override {
        return countYeeFailures(width, height, golden, output);
    }

    std::string png(const ImageFile& image) const override {
        const EncodedFile bytes = encodePng("PNG", image);
        return {bytes.begin(), bytes.end()};
    }

    std::unique_ptr<DisplayTransform> displayTransform(const ColorRequest& request) const override {
        return makeDisplayTransform(request);
    }
};

}  // namespace
}  // namespace umbrage

extern "C" const umbrage::Codec* umbrageCodec() {
    static const umbrage::OiioCodec instance;
    return &instance;
}

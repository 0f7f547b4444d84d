// SPDX-License-Identifier: Apache-2.0
// Pixels to files and back: decoding of textures, display colour, PNG and EXR, written whole or not at all.
//
// OpenImageIO and OpenColorIO cost 0.15 s and 130 MB to load, so they live in a module of their own
// (libumbrage_codec.so) that codec() opens on first use; nothing else links them, and `umbrage --help` never pays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace umbrage {

enum class PixelType : std::uint8_t { UInt8, UInt16, UInt32, Half, Float };

/// Decoded texture: rows from the top, 1 to 4 interleaved channels of UInt8 or UInt16, as stored (no colour change).
struct DecodedImage {
    int width = 0, height = 0, channelCount = 0;
    PixelType type = PixelType::UInt8;
    std::vector<std::byte> pixels;
};

/// One named channel of an image to be written; `pixels` are rows from the top, `stride` values apart.
/// Values are float, or uint32 for UInt32, or bytes for UInt8, stored as they are; `type` is what the file stores.
struct Channel2D {
    std::string name;  // R, G, B, A, Z, N.X, shadow.Lamp ...
    PixelType type = PixelType::Half;
    std::variant<const float*, const std::uint32_t*, const std::uint8_t*> pixels;
    int stride = 1;
};

using Metadata = std::vector<std::pair<std::string, std::variant<std::string, double, int>>>;

struct ImageFile {
    int width = 0, height = 0;
    std::vector<Channel2D> channels;
    Metadata metadata;  // no time, host or frame number: equal pictures are equal files
};

/// A rectangle of pixels; (x, y) is its upper left one.
struct PixelWindow {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const PixelWindow&) const = default;
};

/// One named channel as a file stores it: `width` x `height` values, rows from the top. PNG's bytes come in [0, 1];
/// UInt32 comes as std::uint32_t, all other types as float, in which each of their values is exact.
struct StoredChannel {
    std::string name;  // PNG: Y, Y A, R G B or R G B A
    PixelType type = PixelType::Half;
    std::variant<std::vector<float>, std::vector<std::uint32_t>> values;
};

/// A picture as a file holds it. Channels are by name: an EXR's come back in another order than they were written.
struct StoredImage {
    PixelWindow data, display;            // of the pixels there are, and of the picture they are a part of
    bool displayEncoded = false;          // PNG: values are for a display; EXR: they are linear, or data
    std::vector<StoredChannel> channels;  // by name, in alphabetical order
    Metadata metadata;                    // texts, integers and numbers; by name, in alphabetical order

    std::size_t pixelCount() const { return std::size_t(data.width) * data.height; }
    /// @return  null where there is none of that name
    const StoredChannel* channel(std::string_view name) const;
    /// The same, of the float values; null too for integers.
    const std::vector<float>* floats(std::string_view name) const;
};

/// Colour management of one display and view: linear Rec.709 in, display values out, clamped to [0, 1].
class DisplayTransform {
public:
    virtual ~DisplayTransform() = default;
    /// In place; `rgba` holds interleaved RGBA floats, alpha untouched. Several threads may apply it at once. A pixel
    /// with a NaN or an infinity in its colour becomes NaN in all three channels, which write() refuses for PNG.
    virtual void apply(std::span<float> rgba) const = 0;
    virtual std::string description() const = 0;  // configuration, display, view: for log and metadata
    virtual std::string cacheId() const = 0;
};

struct ColorRequest {
    std::string configPath;     // --ocio or the job's; empty: $OCIO, else the built-in configuration
    std::string display, view;  // empty: the configuration's default
    double exposureStops = 0.0;
};

class Codec {
public:
    virtual ~Codec() = default;

    /// PNG, JPEG or WebP from memory. @throws Error(Input) that names `name`
    virtual DecodedImage decode(std::span<const std::byte> encoded, std::string_view name) const = 0;

    /// PNG: 1 to 4 channels of UInt8 or UInt16. EXR: any. The kind follows `file`'s extension. Values are written as
    /// they are (a NaN or infinity is an Error for PNG). The file appears whole under its name or not at all.
    /// @throws Error(Output)
    virtual void write(const std::filesystem::path& file, const ImageFile& image) const = 0;

    /// A PNG or a single EXR with flat scanlines or tiles. The kind follows the file's first bytes.
    /// @throws Error(Input) that names `file`: missing, another kind, damaged, cut short, or of a size out of bounds
    virtual StoredImage read(const std::filesystem::path& file) const = 0;

    /// Yee's perceptual comparison as OpenImageIO computes it (ImageBufAlgo::compare_Yee), at its defaults: a display
    /// of 100 cd/m2 that fills 45 degrees.
    /// @param golden, output  width x height interleaved linear Rec.709 triples, finite
    /// @return  pixels that fail
    virtual std::size_t yeeFailures(int width, int height, std::span<const float> golden,
                                    std::span<const float> output) const = 0;

    /// What write() would put into a .png, for those who put it elsewhere. @throws Error(Output)
    virtual std::string png(const ImageFile& image) const = 0;

    /// @throws Error(Input) that lists what the configuration offers
    virtual std::unique_ptr<DisplayTransform> displayTransform(const ColorRequest& request) const = 0;
};

/// The one codec of the process, opened on first use. Thread-safe. @throws Error(Device) if the module is missing
const Codec& codec();

/// Starts opening the codec in the background, so that it is ready when the first texture or frame needs it. A failure
/// is reported to whoever calls codec() next.
/// @return  waits when it is destroyed: the process must not end while libraries are being opened
[[nodiscard]] std::future<void> prefetchCodec();

/// Writes `bytes` to `file`: a temporary name in the same folder, then a rename. Makes the folder.
/// @throws Error(Output)
void writeWhole(const std::filesystem::path& file, std::string_view bytes);

/// Makes `file` the same as another: a hard link where the file system has them, else a copy; whole or not at all.
/// @throws Error(Output)
void repeatWhole(const std::filesystem::path& file, const std::filesystem::path& other);

}  // namespace umbrage

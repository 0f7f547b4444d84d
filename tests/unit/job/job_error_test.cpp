// SPDX-License-Identifier: Apache-2.0
// Wrong files: each kind of mistake has its exact place, a sentence and a hint.
#include "expect_error.h"

namespace umbrage {
namespace {

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

TEST(JobErrors, UnknownKeysNameTheNearestOne) {
    expectRefused(sequence("shadwo: {}\n"),
                  {"s.yaml:3:1", "unknown key \"shadwo\" in sequence", "did you mean \"shadow\"?"});
    expectRefused(sequence("time: {fps: 24, frame: 1}\n"),
                  {"s.yaml:3:17", "unknown key \"frame\" in time", "did you mean \"frames\"?"});
    expectRefused(
        sequence("image:\n  size: [4, 4]\n  colour: 1\n"),
        {"s.yaml:5:3", "unknown key \"colour\" in image", "known: size, samples, accumulation, background, ambient"});
    expectRefused("umbrage: 1\nscene:\n- over:\n    /A: {light: {intensty: 4}}\n- gltf: a.glb\n",
                  {"s.yaml:4:18", "unknown key \"intensty\"", "intensity"});
    expectRefused(sequence("lights: [{type: point, name: a, postion: [0, 0, 0]}]\n"),
                  {"s.yaml:3:33", "unknown key \"postion\"", "position"});
}

TEST(JobErrors, KeysOfLaterFormatsAreUnknown) {
    expectRefused("umbrage: 1\nscene: [{gltf: a.glb}, {variant: {material: night}}]\n",
                  {"s.yaml:2:24", "a layer needs the key", "gltf, generated, over"});
    expectRefused("umbrage: 1\nscene: [{gltf: a.glb, instances: {grid: [4, 4]}}]\n",
                  {"s.yaml:2:23", "unknown key \"instances\" in glTF layer", ""});
}

TEST(JobErrors, RulesOfGoldensNameTheirPlace) {
    expectRefused(sequence("golden: {rules: {}}\n"), {"s.yaml:3:9", "golden lacks the key \"path\"", "path: "});
    expectRefused(sequence("golden: {path: x, rules: {default: {all: {few: {metric: fractoin, fail: 0}}}}}\n"),
                  {"s.yaml:3:57", "fractoin", "fraction"});
    expectRefused(sequence("golden: {path: x, rules: {default: {all: {few: {metric: fraction}}}}}\n"),
                  {"s.yaml:3:48", "limits nothing", "fail: NUMBER"});
    expectRefused(sequence("golden: {path: x, statistics: {\"overdraw.*\": no way}}\n"),
                  {"s.yaml:3:46", "overdraw.*", "skip"});
}

TEST(JobErrors, DuplicateKeysNameTheFirst) {
    expectRefused(sequence("time: {fps: 24}\ntime: {fps: 25}\n"),
                  {"s.yaml:4:1", "the key \"time\" is there twice", "s.yaml:3:1"});
    expectRefused(sequence("time: {fps: 24, \"fps\": 25}\n"),
                  {"s.yaml:3:17", "the key \"fps\" is there twice", "s.yaml:3:8"});
}

TEST(JobErrors, AMissingKeyIsReportedAtItsParent) {
    expectRefused("scene: [{gltf: a.glb}]\n", {"s.yaml:1:1", "version key is missing", "add the line umbrage: 1"});
    expectRefused("umbrage: 1\n", {"s.yaml:1:1", "sequence lacks the key \"scene\"", "add scene:"});
    expectRefused(sequence("lights:\n  - {name: a}\n"), {"s.yaml:4:5", "light lacks the key \"type\"", "point, spot"});
    expectRefused(sequence("lights:\n  - {type: spot}\n"), {"s.yaml:4:5", "light lacks the key \"name\"", ""});
    expectRefused("umbrage: 1\nscene: []\n", {"s.yaml:2:8", "no glTF layer", "add - gltf: FILE"});
    expectRefused("umbrage: 1\nscene: [{glft: a.glb}]\n", {"s.yaml:2:9", "a layer needs", "did you mean \"gltf\"?"});
}

TEST(JobErrors, OnlyVersionOneIsKnown) {
    expectRefused("umbrage: 2\nscene: [{gltf: a.glb}]\n", {"s.yaml:1:10", "umbrage must be 1, not 2", ""});
    expectRefused("umbrage: \"1\"\nscene: [{gltf: a.glb}]\n", {"s.yaml:1:10", "umbrage must be 1, not \"1\"", ""});
}

TEST(JobErrors, WrongKindsOfValueSayWhatIsExpectedAndWhatIsThere) {
    expectRefused(sequence("time: {fps: fast}\n"),
                  {"s.yaml:3:13", "fps must be a number above 0, not \"fast\"", "decimal"});
    expectRefused(sequence("time: {fps: \"24\"}\n"), {"s.yaml:3:13", "not \"24\"", "without quotes"});
    expectRefused(sequence("time: {fps: [24]}\n"), {"s.yaml:3:13", "not a list of 1", ""});
    expectRefused(sequence("time: 24\n"), {"s.yaml:3:7", "time must be a mapping, not 24", ""});
    expectRefused(sequence("time:\n"), {"s.yaml:3:1", "time must be a mapping, not nothing", ""});
    expectRefused(sequence("time: ~\n"), {"s.yaml:3:7", "not nothing", ""});
    expectRefused(sequence("lights: {type: point}\n"),
                  {"s.yaml:3:9", "lights must be a list of lights, not a mapping", "- "});
    expectRefused(sequence("image: {size: 4}\n"), {"s.yaml:3:15", "size must be a list [width, height], not 4", ""});
    expectRefused(sequence("image: {size: [4, 4, 4]}\n"), {"s.yaml:3:15", "expected 2 values, not 3", ""});
    expectRefused(sequence("image: {size: [4, 4.5]}\n"), {"s.yaml:3:19", "integer from 1 to 16384, not 4.5", ""});
    expectRefused(sequence("displace: {/A: {kind: twist, axis: [0, 0, 0]}}\n"),
                  {"s.yaml:3:36", "axis must be an axis [x, y, z], not 0", ""});
    expectRefused(sequence("color: {view: 12}\n"), {"s.yaml:3:15", "view must be a string, not 12", "quote it"});
    expectRefused(sequence("color: {view: \"\"}\n"), {"s.yaml:3:15", "view must be a string", ""});
    expectRefused(sequence("shadow: {enabled: 1}\n"), {"s.yaml:3:19", "enabled must be true or false, not 1", ""});
    expectRefused(sequence("shadow: {enabled: \"true\"}\n"), {"s.yaml:3:19", "not \"true\"", ""});
    expectRefused(sequence("camera: [1]\n"), {"s.yaml:3:9", "camera must be a name", ""});
    expectRefused("- 1\n", {"s.yaml:1:1", "the sequence must be a mapping, not a list of 1", ""});
    expectRefused("hello\n", {"s.yaml:1:1", "the sequence must be a mapping, not \"hello\"", ""});
}

TEST(JobErrors, ValuesOutOfRangeSayTheRange) {
    expectRefused(sequence("time: {fps: 0}\n"), {"s.yaml:3:13", "fps must be a number above 0, not 0", ""});
    expectRefused(sequence("image: {samples: 3}\n"), {"s.yaml:3:18", "one of 1, 2, 4, 8, 16, not 3", ""});
    expectRefused(sequence("image: {size: [0, 4]}\n"), {"s.yaml:3:16", "from 1 to 16384, not 0", ""});
    expectRefused(sequence("image: {size: [99999999999999999999, 4]}\n"), {"s.yaml:3:16", "from 1 to 16384", ""});
    expectRefused(sequence("image: {background: [0, -1, 0]}\n"), {"s.yaml:3:25", "of at least 0, not -1", ""});
    expectRefused(sequence("output: {pngBits: 12}\n"), {"s.yaml:3:19", "pngBits must be one of 8, 16, not 12", ""});
    expectRefused(sequence("camera: {yfov: 180}\n"), {"s.yaml:3:16", "above 0 and below 180, not 180", ""});
    expectRefused("umbrage: 1\nscene: [{gltf: a.glb, scale: [1, 0, 1]}]\n", {"s.yaml:2:30", "scale must not be 0", ""});
}

TEST(JobErrors, NumbersAreFiniteAndDecimal) {
    for (const char* text : {".nan", ".inf", "-.inf", "nan", "inf", "infinity", "1e400", "1e39", "0x10", "0o7", "1_000",
                             "1,5", "--1", "+-1", "1e", "."}) {
        SCOPED_TRACE(text);
        const std::string yaml = sequence("color:\n  exposure: " + std::string(text) + "\n");
        expectRefused(yaml, {"s.yaml:4:13", "exposure must be a number, not \"" + std::string(text) + "\"", "decimal"});
    }
    EXPECT_EQ(read(sequence("color: {exposure: 0010}\n")).color.exposureStops, 10);
    EXPECT_EQ(read(sequence("color: {exposure: +.5e1}\n")).color.exposureStops, 5);
}

TEST(JobErrors, NamesFromAListGiveTheNearest) {
    expectRefused(sequence("shadow: {count: z-pas}\n"), {"s.yaml:3:17", ", not \"z-pas\"", "z-pass"});
    expectRefused(sequence("output: {aovs: {beuty: png}}\n"),
                  {"s.yaml:3:17", "unknown name \"beuty\" in aovs", "\"beauty\""});
    expectRefused(sequence("output: {aovs: {beauty: jpg}}\n"), {"s.yaml:3:25", "one of png, exr, not \"jpg\"", "png"});
    expectRefused(sequence("shadow: {skips: {hlave: off}}\n"), {"s.yaml:3:18", "unknown name \"hlave\"", "\"halve\""});
    expectRefused(sequence("diagnostics: {overlays: [stencils]}\n"),
                  {"s.yaml:3:26", "not \"stencils\"", "\"stencil\""});
}

TEST(JobErrors, DataIsNotWrittenAsPng) {
    expectRefused(sequence("output: {aovs: {beauty: png, depth: png}}\n"),
                  {"s.yaml:3:37", "depth is data, which PNG would cut", "write exr"});
}

TEST(JobErrors, FrameRangesKeepTheirPlace) {
    expectRefused(sequence("time: {frames: \"1:10\"}\n"), {"s.yaml:3:16", "has a ':'", "stagger"});
    expectRefused(sequence("time:\n  frames: 10-1\n"), {"s.yaml:4:11", "runs backwards", "1-10"});
    expectRefused(sequence("time: {frames: [1-5, 7-6]}\n"), {"s.yaml:3:22", "runs backwards", ""});
    expectRefused(sequence("time: {frames: [1-5, 3]}\n"), {"s.yaml:3:16", "both have frame 3", ""});
    expectRefused(sequence("time: {frames: []}\n"), {"s.yaml:3:16", "frames must be", ""});
    expectRefused(sequence("time: {frames: 1-5,8}\n"),
                  {"s.yaml:3:20", "unknown key 8 in time", "quote a value with commas"});
}

TEST(JobErrors, TimeSamplesNeedTimesAndEachOnce) {
    const std::string light = "lights:\n  - type: point\n    name: a\n    intensity: ";
    expectRefused(sequence(light + "{}\n"), {"s.yaml:6:16", "time samples of intensity are empty", "{0: value"});
    expectRefused(sequence(light + "{soon: 1}\n"), {"s.yaml:6:17", "must be a time in seconds, not \"soon\"", ""});
    expectRefused(sequence(light + "{0: 1, 1: x}\n"),
                  {"s.yaml:6:26", "intensity must be a number of at least 0, not \"x\"", ""});
    expectRefused(sequence(light + "{1: 1, 1.0: 2}\n"), {"s.yaml:6:23", "at the same time", "s.yaml:6:17"});
    expectRefused(sequence(light + "[1]\n"), {"s.yaml:6:16", "not a list of 1", ""});
}

TEST(JobErrors, LightsAreCheckedAsAWhole) {
    expectRefused(sequence("lights: [{type: point, name: a/b}]\n"),
                  {"s.yaml:3:30", "cannot have a '/'", "/lights/NAME"});
    expectRefused(sequence("lights: [{type: point, name: a}, {type: spot, name: a}]\n"),
                  {"s.yaml:3:53", "two lights are named \"a\"", "s.yaml:3:30"});
    expectRefused(sequence("lights: [{type: point, name: a, target: [0, 0, 0]}]\n"),
                  {"s.yaml:3:41", "\"target\" is only for spot and directional lights", ""});
    expectRefused(sequence("lights: [{type: point, name: a, outerConeAngle: 4}]\n"),
                  {"s.yaml:3:49", "only for spot lights", ""});
    expectRefused(sequence("lights: [{type: directional, name: a, range: 4}]\n"),
                  {"s.yaml:3:46", "point and spot", ""});
    expectRefused("umbrage: 1\nscene: [{gltf: a.glb, at: Lamp}]\n", {"s.yaml:2:27", "not the path of a node", "'/'"});
}

TEST(JobErrors, CamerasAreCheckedAsAWhole) {
    expectRefused(sequence("camera: {type: orthographic}\n"), {"s.yaml:3:9", "needs a zfar", "add zfar"});
    expectRefused(sequence("camera: {type: orthographic, zfar: 0}\n"), {"s.yaml:3:36", "needs a zfar", ""});
    expectRefused(sequence("camera: {type: orthographic, zfar: 9, yfov: 3}\n"), {"s.yaml:3:45", "perspective", ""});
    expectRefused(sequence("camera: {ymag: 3}\n"), {"s.yaml:3:16", "only for orthographic", ""});
    expectRefused(sequence("camera: {znear: 2, zfar: 1}\n"), {"s.yaml:3:26", "greater than znear", ""});
}

TEST(JobErrors, OutputNamesMustDiffer) {
    const std::string frames = "time: {frames: 1-3}\n";
    expectRefused(sequence(frames + "output: {path: \"{aov}.{ext}\"}\n"), {"s.yaml:4:16", "no {frame}", "{frame:04}"});
    expectRefused(sequence("output:\n  path: x.{frame}.{ext}\n  aovs: {beauty: png, depth: exr}\n"),
                  {"s.yaml:4:9", "no {aov}, but 2 images", "add {aov}"});
    expectRefused(sequence("output: {path: x.exr}\n"),
                  {"s.yaml:3:16", "no {ext}, but beauty is written as png", ".{ext}"});
    expectRefused(sequence("output: {path: \"out/{aov}/\", aovs: {}}\n"), {"s.yaml:3:16", "is a folder", "{aov}"});
    EXPECT_NO_THROW(read(sequence("output: {path: x.png}\n")));
}

TEST(JobErrors, FieldsOfOutputNamesAreKnown) {
    expectRefused(sequence("output: {path: \"{aof}.{ext}\"}\n"), {"s.yaml:3:16", "unknown field {aof}", "\"aov\""});
    expectRefused(sequence("output: {path: \"{frame:4}.{ext}\"}\n"),
                  {"s.yaml:3:16", "\"4\" is not a format", "{frame:04}"});
    expectRefused(sequence("output: {path: \"{aov:04}.{ext}\"}\n"),
                  {"s.yaml:3:16", "not a format of {aov}", "{frame:04}"});
    expectRefused(sequence("output: {path: \"{aov.png\"}\n"), {"s.yaml:3:16", "without its partner", ""});
    expectRefused(sequence("output: {path: \"aov}.png\"}\n"), {"s.yaml:3:16", "without its partner", ""});
    expectRefused(sequence("statistics: {path: s.txt}\n"), {"s.yaml:3:20", ".json or .csv", ""});
    expectRefused(sequence("statistics: {page: s.htm}\n"), {"s.yaml:3:20", "ends with .html", ""});
}

TEST(JobErrors, BrokenYamlHasItsPlace) {
    expectRefused("", {"s.yaml:1:1", "empty", "umbrage: 1"});
    expectRefused("# nothing\n", {"s.yaml:1:1", "empty", ""});
    expectRefused("umbrage: 1\nscene: [\n", {"s.yaml:3:1", "end of sequence flow not found", "not valid YAML"});
    expectRefused("umbrage: 1\ntime:\n\tfps: 1\n", {"s.yaml:3:5", "", "spaces"});
    expectRefused(sequence("camera: *nowhere\n"), {"s.yaml:3:9", "anchor", ""});
    expectRefused(sequence("---\numbrage: 1\n"), {"s.yaml:3:1", "document has ended, but the text goes on", "---"});
    expectRefused("," + sequence(""), {"s.yaml:1:1", "document has ended", "comma"});
    expectRefused(sequence("") + "]\n", {"s.yaml:3:1", "illegal flow end", "YAML"});
    expectRefused(sequence("image: &i {samples: 4}\ntime: {<<: *i}\n"),
                  {"s.yaml:4:8", "merge keys", "write the keys out"});
    expectRefused(sequence("? [a, b]\n: 1\n"), {"s.yaml:3:3", "a key cannot be a list of 2", ""});
    expectRefused(sequence("~: 1\n"), {"s.yaml:3:1", "a key cannot be nothing", ""});
    expectRefused(sequence("camera: !!str 12\n"), {"s.yaml:3:9", "tag", "quote"});
    expectRefused(sequence("camera: !mine {}\n"), {"s.yaml:3:9", "tag", ""});
}

TEST(JobErrors, TextThatIsNotUtf8HasItsPlace) {
    expectRefused(sequence("camera: \xff\n"), {"s.yaml:3:9", "UTF-8", "save"});
    expectRefused(sequence("# \xc3\x28\n"), {"s.yaml:3:3", "UTF-8", ""});
    expectRefused(sequence("# \xe0\x80\x80\n"), {"s.yaml:3:3", "UTF-8", ""});
    expectRefused(sequence("# \xed\xa0\x80\n"), {"s.yaml:3:3", "UTF-8", ""});
    expectRefused(sequence("# \xf4\x90\x80\x80\n"), {"s.yaml:3:3", "UTF-8", ""});
    expectRefused(sequence("# \xe2\x82"), {"s.yaml:3:3", "UTF-8", ""});
    expectRefused(sequence(std::string("camera: a\0b\n", 12)), {"s.yaml:3:10", "UTF-8", ""});
    expectRefused(sequence("camera: \x04\n"), {"s.yaml:3:9", "UTF-8", ""});
    EXPECT_EQ(read(sequence("camera: /Höfe/\xf0\x9f\x94\xa5\n")).camera.node.value, "/Höfe/\xf0\x9f\x94\xa5");
    EXPECT_NO_THROW(read("\xef\xbb\xbf" + sequence("")));
    EXPECT_NO_THROW(read("umbrage: 1\r\nscene: [{gltf: a.glb}]\r\n"));
}

TEST(JobErrors, ADeepTreeIsRefused) {
    for (const int depth : {70, 1000, 200'000}) {
        SCOPED_TRACE(depth);
        for (const std::string open : {"[", "{a: ", "- "})
            EXPECT_THROW(read(sequence("camera: " + repeated(open, depth))), Error);
        EXPECT_THROW(read(sequence("camera: " + repeated("[", depth) + repeated("]", depth))), Error);
    }
    expectRefused(sequence("camera: " + repeated("[", 70) + repeated("]", 70) + "\n"),
                  {"s.yaml:3:72", "nested too deeply", ""});
    expectRefused(sequence("camera: &x [*x]\n"), {"s.yaml:3:13", "an alias contains itself", ""});
}

TEST(JobErrors, AnAliasBombIsRefusedBeforeItGrows) {
    std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
    for (int i = 1; i < 20; ++i) {
        const std::string last = "*a" + std::to_string(i - 1);
        bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + repeated(last + ", ", 9) + last + "]\n";
    }
    try {
        read(sequence(bomb));
        FAIL() << "a bomb was read";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("more than 250000 values"));
    }
}

TEST(JobErrors, AHugeFileIsRefused) {
    expectRefused(sequence("#" + std::string(5u << 20, 'x')), {"s.yaml:1:1", "bytes", ""});
}

// Each byte of a good file replaced by, and put behind, a few that mean something to YAML.
TEST(JobErrors, NoChangedByteGivesAnythingButAnErrorWithItsPlace) {
    const std::string good = sequence(
        "lights: [{type: spot, name: a, intensity: {0: 1, 2: 3}}]\ncamera: {yfov: 30}\ntime:\n  frames: 1-9x2\n"
        "output:\n  path: \"o/{aov}.{frame:04}.{ext}\"\n  aovs: {beauty: png, depth: exr}\n");
    const std::string bytes = std::string("{}[]:,-&*!|>'\"%@`#?~<=\t\n 0x") + '\0' + '\xff';
    constexpr std::size_t kTried = 5;
    for (std::size_t i = 0; i < good.size(); ++i) {
        for (std::size_t n = 0; n < 2 * kTried; ++n) {
            std::string bad = good;
            bad.replace(i, n % 2, 1, bytes[(i * kTried + n / 2) % bytes.size()]);
            try {
                read(bad);
            } catch (const Error& error) {
                ASSERT_THAT(error.where(), testing::StartsWith("s.yaml:")) << bad;
            }
        }
    }
}

}  // namespace
}  // namespace umbrage

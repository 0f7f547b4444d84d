// SPDX-License-Identifier: Apache-2.0
// What the device is asked to do, against calls of GL that are counted where they leave the program.
#include <epoxy/gl.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "counter_checks.h"
#include "subjects.h"

namespace umbrage::test {
namespace {

using Json = nlohmann::json;

struct Calls {
    double draws = 0, dispatches = 0, stateChanges = 0, uploaded = 0, readBack = 0;
};
Calls calls;

double bytesOf(GLenum format, GLenum type) {
    const double components = format == GL_RGBA || format == GL_RGBA_INTEGER ? 4
                              : format == GL_RG || format == GL_RG_INTEGER   ? 2
                                                                             : 1;
    return components * (type == GL_UNSIGNED_BYTE ? 1 : type == GL_HALF_FLOAT || type == GL_UNSIGNED_SHORT ? 2 : 4);
}

/// While it lives, calls of one function of GL also run `count`.
template <auto& function, class Count>
class Spy;
template <class... Arguments, void (*&function)(Arguments...), class Count>
class Spy<function, Count> {
public:
    explicit Spy(Count) : real_(function) {
        real() = function;
        function = [](Arguments... arguments) {
            Count{}(arguments...);
            real()(arguments...);
        };
    }
    ~Spy() { function = real_; }
    Spy(const Spy&) = delete;
    Spy& operator=(const Spy&) = delete;

private:
    static auto& real() {
        static void (*value)(Arguments...) = nullptr;
        return value;
    }
    void (*real_)(Arguments...);
};
template <auto& function, class Count>
auto spyOn(Count count) {
    return Spy<function, Count>(count);
}

/// Bytes of all buffers and textures that exist.
double allocated() {
    double bytes = 0;
    constexpr GLuint kNames = 1u << 17;  // more than one process of all tests ever makes
    for (GLuint name = 1; name < kNames; ++name) {
        if (glIsBuffer(name)) {
            GLint64 size = 0;
            glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &size);
            bytes += double(size);
        }
        if (!glIsTexture(name)) continue;
        const auto level = [&](GLint l, GLenum what) {
            GLint value = 0;
            glGetTextureLevelParameteriv(name, l, what, &value);
            return value;
        };
        for (GLint l = 0; level(l, GL_TEXTURE_WIDTH) > 0 && l < 16; ++l) {
            double bits = 0;
            for (const GLenum channel :
                 {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE}) {
                bits += level(l, channel);
            }
            if (level(l, GL_TEXTURE_DEPTH_SIZE) > 0) bits = 64;  // with stencil and padding
            bytes += bits / 8 * level(l, GL_TEXTURE_WIDTH) * level(l, GL_TEXTURE_HEIGHT) *
                     std::max(1, level(l, GL_TEXTURE_DEPTH)) * std::max(1, level(l, GL_TEXTURE_SAMPLES));
        }
    }
    glGetError();  // of levels that do not exist
    return bytes;
}

TEST(DeviceCounters, AreTheCallsOfGl) {
    for (const char* name : {"knight", "courtyard"}) {
        SCOPED_TRACE(name);
        const Subject subject = ours(name, 128, 96);
        FrameSettings settings = subject.settings();
        settings.profile = true;
        FrameRenderer renderer(subject.scene, subject.moment(), settings, context());
        FrameOutputs outputs;
        Statistics unused, statistics;
        renderer.render(subject.moment(), subject.camera, outputs, 1, unused);  // functions are looked up when called
        calls = {};
        double passes = 0, milliseconds = 0;
        {
            const auto draw = [](auto...) { ++calls.draws; };
            const auto a = spyOn<glDrawArrays>(draw);
            const auto b = spyOn<glMultiDrawArrays>(draw);
            const auto c = spyOn<glDrawElementsIndirect>(draw);
            const auto d = spyOn<glDrawElementsInstancedBaseVertexBaseInstance>(draw);
            const auto e = spyOn<glDispatchCompute>([](auto...) { ++calls.dispatches; });
            const auto change = [](auto...) { ++calls.stateChanges; };
            const auto f = spyOn<glUseProgram>(change);
            const auto g = spyOn<glDepthFunc>(change);  // once for a raster state
            const auto h =
                spyOn<glBindFramebuffer>([](GLenum target, GLuint) { calls.stateChanges += target == GL_FRAMEBUFFER; });
            const auto i = spyOn<glNamedBufferSubData>(
                [](GLuint, GLintptr, GLsizeiptr size, const void*) { calls.uploaded += double(size); });
            const auto j = spyOn<glNamedBufferStorage>([](GLuint, GLsizeiptr size, const void* data, GLbitfield) {
                calls.uploaded += data ? double(size) : 0.0;
            });
            const auto k = spyOn<glGetNamedBufferSubData>(
                [](GLuint, GLintptr, GLsizeiptr size, void*) { calls.readBack += double(size); });
            const auto m =
                spyOn<glReadPixels>([](GLint, GLint, GLsizei width, GLsizei height, GLenum format, GLenum type, void*) {
                    calls.readBack += double(width) * height * bytesOf(format, type);
                });
            const auto begin = std::chrono::steady_clock::now();
            const FramePixels pixels = renderer.render(subject.moment(), subject.camera, outputs, 1, unused);
            milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
            for (const auto& [pass, time] : pixels.milliseconds) passes += time;
        }
        outputs.figures = true;  // measures more than the frame, which the figures leave out
        renderer.render(subject.moment(), subject.camera, outputs, 1, statistics);
        const Json values = Json::parse(statistics.file({}).json())["frames"][0]["values"];
        EXPECT_GT(calls.draws, 3.0);
        expectCounter("device.draws", "calls of GL", values["device.draws"], calls.draws);
        expectCounter("device.dispatches", "calls of GL", values["device.dispatches"], calls.dispatches);
        expectCounter("device.stateChanges", "calls of GL", values["device.stateChanges"], calls.stateChanges);
        expectCounter("device.uploaded", "sizes given to GL", values["device.uploaded"], calls.uploaded);
        expectCounter("device.readBack", "sizes given to GL", values["device.readBack"], calls.readBack);
        expectCounter("memory.device", "sizes GL tells", values["memory.device"], allocated());
        EXPECT_LE(passes, milliseconds);
        EXPECT_GT(passes, 0.0);
    }
}

/// Nothing asked for, nothing paid: the frame's own work is the same with and without diagnostics.
TEST(DeviceCounters, DoNotCountDiagnostics) {
    const Subject subject = ours("knight", 128, 96);
    const auto work = [&](bool more) {
        FrameRenderer renderer(subject.scene, subject.moment(), subject.settings(), context());
        Statistics statistics;
        FrameOutputs outputs;
        outputs.figures = true;
        outputs.overdraw = outputs.hulls = outputs.topCasters = outputs.scene = more;
        if (more) outputs.aovs = {"position", "ids", "motion", "silhouette", "cost"};
        renderer.render(subject.moment(), subject.camera, outputs, 1, statistics);
        const Json values = Json::parse(statistics.file({}).json())["frames"][0]["values"];
        EXPECT_GT(values["device.draws"], 3);
        EXPECT_GT(values["device.uploaded"], 0);
        EXPECT_GE(values["memory.device"].get<double>(), 128.0 * 96 * 4 * 8);
        return std::array<Json, 5>{values["device.draws"], values["device.dispatches"], values["device.stateChanges"],
                                   values["device.uploaded"], values["device.readBack"]};
    };
    EXPECT_EQ(work(true), work(false));
}

}  // namespace
}  // namespace umbrage::test

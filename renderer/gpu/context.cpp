// SPDX-License-Identifier: Apache-2.0
#include "gpu/context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "error.h"

namespace umbrage::gpu {

struct Context::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    DeviceInfo info;

    Impl(EGLDeviceEXT device, int index);
    ~Impl();
};

namespace {

std::string eglErrorText(const char* what) {
    return fmt::format("{} failed (EGL error 0x{:x})", what, eglGetError());
}

std::string glText(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

/// libepoxy ends the process when libEGL is missing, or is a dispatcher without any driver, so look first.
bool haveEgl() {
    static const bool found =
        dlopen("libEGL.so.1", RTLD_LAZY) != nullptr && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
    return found;
}

/// The system's EGL devices; EGL_NO_DEVICE_EXT stands for Mesa's surfaceless platform where they cannot be listed.
std::vector<EGLDeviceEXT> eglDevices() {
    std::vector<EGLDeviceEXT> devices;
    if (!haveEgl()) return devices;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 64> found{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(EGLint(found.size()), found.data(), &count)) {
            devices.assign(found.begin(), found.begin() + count);
        }
    }
    if (devices.empty()) devices.push_back(EGL_NO_DEVICE_EXT);
    return devices;
}

bool isIndex(const std::string& text, int& index) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc() && end == text.data() + text.size();
}

bool containsIgnoringCase(const std::string& text, const std::string& part) {
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

}  // namespace

/// Opens the device and makes its context current; on failure info.problem says why.
Context::Impl::Impl(EGLDeviceEXT device, int index) {
    info.index = index;
    display = device == EGL_NO_DEVICE_EXT
                  ? eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                  : eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
        info.problem = eglErrorText("eglInitialize");
        display = EGL_NO_DISPLAY;
        return;
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        info.problem = eglErrorText("creating an OpenGL 4.5 core context");
        return;
    }
    info.renderer = glText(GL_RENDERER);
    info.vendor = glText(GL_VENDOR);
    info.version = glText(GL_VERSION);
    for (const char* name : {"llvmpipe", "softpipe", "swiftshader"}) {
        info.software = info.software || containsIgnoringCase(info.renderer, name);
    }
}

Context::Impl::~Impl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
}

std::vector<DeviceInfo> listDevices() {
    std::vector<DeviceInfo> infos;
    for (const EGLDeviceEXT device : eglDevices()) {
        infos.push_back(Context(device, int(infos.size())).info());
    }
    return infos;
}

Context::Context(void* eglDevice, int index) : impl_(std::make_unique<Impl>(eglDevice, index)) {}

Context::Context(const std::string& device) {
    if (!haveEgl()) throw Error(ErrorKind::Device, "", "there is no EGL driver", kDriverHint);
    const std::vector<EGLDeviceEXT> devices = eglDevices();
    std::string tried;
    std::unique_ptr<Impl> software;
    int wantedIndex = -1;
    const bool byIndex = isIndex(device, wantedIndex);
    for (int i = 0; i < int(devices.size()); ++i) {
        if (byIndex && i != wantedIndex) continue;
        auto opened = std::make_unique<Impl>(devices[i], i);
        tried +=
            fmt::format("; {}: {}", i, opened->info.problem.empty() ? opened->info.renderer : opened->info.problem);
        if (!opened->info.problem.empty()) continue;
        if (device == "auto" && opened->info.software) {
            software = std::move(opened);  // a GPU later in the list is better
        } else if (byIndex || device == "auto" || containsIgnoringCase(opened->info.renderer, device)) {
            impl_ = std::move(opened);
            break;
        }
    }
    if (!impl_ && software) impl_ = std::move(software);
    if (!impl_) {
        throw Error(
            ErrorKind::Device, "", fmt::format("no usable OpenGL device for '{}'{}", device, tried),
            device == "auto" ? kDriverHint : "give the index or part of the name of one that umbrage devices lists");
    }
    // Opening and closing others has changed what is current.
    software.reset();
    eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context);
}

Context::~Context() = default;

const DeviceInfo& Context::info() const {
    return impl_->info;
}

int Context::subPixelBits() const {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return bits;
}

int Context::maxSamples() const {
    GLint all = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &all);
    for (const GLenum limit : {GL_MAX_INTEGER_SAMPLES, GL_MAX_COLOR_TEXTURE_SAMPLES, GL_MAX_DEPTH_TEXTURE_SAMPLES}) {
        GLint value = 0;
        glGetIntegerv(limit, &value);
        all = std::min(all, value);
    }
    return all;
}

}  // namespace umbrage::gpu

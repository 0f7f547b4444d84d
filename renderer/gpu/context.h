// SPDX-License-Identifier: Apache-2.0
// A headless OpenGL 4.5 core context through EGL: on a device of the system, or Mesa's surfaceless platform.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace umbrage::gpu {

/// What to do where there is no usable device.
inline constexpr const char* kDriverHint =
    "umbrage needs EGL with OpenGL 4.5; on Debian: apt-get install libegl1 libgl1-mesa-dri";

struct DeviceInfo {
    int index = 0;  // for --device
    std::string renderer, vendor, version;
    bool software = false;  // rasterises on the CPU: timer queries there mean nothing (T15)
    std::string problem;    // why it cannot be used; empty: it can
};

/// Opens every EGL device in turn. Never throws: what cannot be used says why.
std::vector<DeviceInfo> listDevices();

class Context {
public:
    /// Opens a device and makes its context current on this thread.
    /// @param device  an index of listDevices(), part of a renderer's name, or "auto": the first GPU, else the CPU
    /// @throws Error(Device)
    explicit Context(const std::string& device = "auto");
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const DeviceInfo& info() const;
    int maxSamples() const;    // of colour, integer and depth textures alike
    int subPixelBits() const;  // of the grid that vertices are snapped to

private:
    friend std::vector<DeviceInfo> listDevices();
    Context(void* eglDevice, int index);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace umbrage::gpu

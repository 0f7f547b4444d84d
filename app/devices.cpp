// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "commands.h"
#include "exit_codes.h"
#include "gpu/context.h"

namespace umbrage {

int runDevices() {
    const std::vector<gpu::DeviceInfo> devices = gpu::listDevices();
    bool usable = false;
    for (const gpu::DeviceInfo& device : devices) {
        if (device.problem.empty()) {
            fmt::print("{}  {} ({}){}\n", device.index, device.renderer, device.version,
                       device.software ? ", rasterises on the CPU" : "");
            usable = true;
        } else {
            fmt::print("{}  not usable: {}\n", device.index, device.problem);
        }
    }
    if (usable) return kOk;
    throw Error(ErrorKind::Device, "", devices.empty() ? "no EGL device found" : "no EGL device offers OpenGL 4.5",
                gpu::kDriverHint);
}

}  // namespace umbrage

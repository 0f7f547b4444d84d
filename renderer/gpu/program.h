// SPDX-License-Identifier: Apache-2.0
// Programs from the shaders embedded in the build (shaders/<pass>.<stage>.glsl), with #include resolved and
// #defines chosen at run time. The build has checked every shader, so an error here is a bug of ours or the driver's.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/objects.h"

namespace umbrage::gpu {

void deleteProgram(GLuint name);

class Program {
public:
    using Defines = std::vector<std::string>;  // "SAMPLES 4"

    Program() = default;
    /// A compute shader, or a vertex shader with or without a fragment and a geometry shader. Compiled on first use: a
    /// run pays only for the passes it needs.
    explicit Program(std::string_view computeOrVertex, std::string_view fragment = {}, Defines defines = {},
                     std::string_view geometry = {})
        : shaders_{std::string(computeOrVertex), std::string(geometry), std::string(fragment)},
          defines_(std::move(defines)) {}

    GLuint name() const;
    void use() const {
        ++activity().stateChanges;
        glUseProgram(name());
    }
    void uniform(GLint location, GLuint value) const { glProgramUniform1ui(name(), location, value); }
    void uniform(GLint location, GLint value) const { glProgramUniform1i(name(), location, value); }
    void uniform(GLint location, GLfloat value) const { glProgramUniform1f(name(), location, value); }

    /// Runs a compute shader over that many groups, which it counts by GROUP_HERE.
    void dispatchGroups(GLuint groupCount) const;

private:
    std::string shaders_[3];
    Defines defines_;
    mutable Handle<deleteProgram> handle_;
};

/// The text of an embedded shader. @throws std::out_of_range
std::string_view shaderSource(std::string_view name);

}  // namespace umbrage::gpu

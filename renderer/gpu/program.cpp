// SPDX-License-Identifier: Apache-2.0
#include "gpu/program.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "shaders/shared.h"

namespace umbrage::gpu {
namespace {

/// Appends the shader's lines with includes replaced by the files they name.
void expand(std::string_view source, std::string& out) {
    while (!source.empty()) {
        const std::size_t end = std::min(source.find('\n'), source.size() - 1);
        const std::string_view line = source.substr(0, end + 1);
        source.remove_prefix(end + 1);
        if (line.starts_with("#include \"")) {
            expand(shaderSource(line.substr(10, line.find('"', 10) - 10)), out);
        } else if (!line.starts_with("#version") && !line.starts_with("#extension GL_GOOGLE_include_directive")) {
            out += line;
        }
    }
}

GLenum stageOf(std::string_view name) {
    if (name.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (name.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    if (name.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    return GL_COMPUTE_SHADER;
}

std::string infoLog(GLuint name, decltype(glGetProgramiv) get, decltype(glGetProgramInfoLog) getLog) {
    GLint length = 0;
    get(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    getLog(name, length, nullptr, log.data());
    return log;
}

GLuint compile(std::string_view name, const std::vector<std::string>& defines) {
    std::string text = "#version 450 core\n";
    for (const std::string& define : defines) text += fmt::format("#define {}\n", define);
    expand(shaderSource(std::string(name) + ".glsl"), text);
    const GLuint shader = glCreateShader(stageOf(name));
    const char* data = text.c_str();
    glShaderSource(shader, 1, &data, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        throw std::logic_error(
            fmt::format("shader {} does not compile:\n{}", name, infoLog(shader, glGetShaderiv, glGetShaderInfoLog)));
    }
    return shader;
}

}  // namespace

void deleteProgram(GLuint name) {
    glDeleteProgram(name);
}

GLuint Program::name() const {
    if (handle_.get()) return handle_.get();
    handle_ = Handle<deleteProgram>(glCreateProgram());
    std::string label;
    for (const std::string& shader : shaders_) {
        if (shader.empty()) continue;
        const GLuint compiled = compile(shader, defines_);
        glAttachShader(handle_.get(), compiled);
        glDeleteShader(compiled);  // lives on with the program
        label += fmt::format("{}{}", label.empty() ? "" : " + ", shader);
    }
    glLinkProgram(handle_.get());
    GLint linked = 0;
    glGetProgramiv(handle_.get(), GL_LINK_STATUS, &linked);
    if (!linked) {
        throw std::logic_error(fmt::format("program {} does not link:\n{}", label,
                                           infoLog(handle_.get(), glGetProgramiv, glGetProgramInfoLog)));
    }
    glObjectLabel(GL_PROGRAM, handle_.get(), -1, label.c_str());
    return handle_.get();
}

void Program::dispatchGroups(GLuint groupCount) const {
    if (groupCount == 0) return;
    use();
    ++activity().dispatches;
    glDispatchCompute(std::min(groupCount, GROUP_ROW), (groupCount + GROUP_ROW - 1) / GROUP_ROW, 1);
}

}  // namespace umbrage::gpu

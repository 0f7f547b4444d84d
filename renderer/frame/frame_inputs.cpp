// SPDX-License-Identifier: Apache-2.0
#include "frame/frame_inputs.h"

#include <span>
#include <type_traits>
#include <vector>

#include "shading/lights.h"

namespace umbrage {
namespace {

class Bytes {
public:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "padding would count");
        text_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    /// Vectors and matrices of glm.
    template <glm::length_t N, class T>
    void add(const glm::vec<N, T>& vector) {
        for (glm::length_t i = 0; i < N; ++i) add(vector[i]);
    }
    void add(const glm::dmat4& matrix) {
        for (glm::length_t i = 0; i < 4; ++i) add(matrix[i]);
    }
    template <class T>
    void addAll(const std::vector<T>& values) {
        add(values.size());
        for (const T& value : values) add(value);
    }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void addInstance(const Instance& instance, Bytes& bytes) {
    bytes.add(instance.node);
    bytes.add(instance.mesh);
    bytes.add(instance.worldFromModel);
    bytes.addAll(instance.morphWeights);
    bytes.addAll(instance.worldFromBindPose);
    bytes.add(instance.displacement);
}

void addLight(const PlacedLight& placed, Bytes& bytes) {
    const Light& light = placed.light;
    bytes.add(isOn(light));
    if (!isOn(light)) return;  // nobody looks further
    bytes.add(light.type);
    bytes.add(light.color);
    bytes.add(light.intensity);
    bytes.add(light.rangeMetres);
    bytes.add(light.innerConeAngle);
    bytes.add(light.outerConeAngle);
    bytes.add(placed.position);
    bytes.add(placed.direction);
}

void addCamera(const PlacedCamera& placed, Bytes& bytes) {
    const Camera& camera = placed.camera;
    bytes.add(camera.perspective);
    bytes.add(camera.yfov);
    bytes.add(camera.xmag);
    bytes.add(camera.ymag);
    bytes.add(camera.znear);
    bytes.add(camera.zfar);
    bytes.add(placed.worldFromCamera);
}

}  // namespace

std::string inputsOf(const Scene& scene, const PlacedMoment& placed, bool nodes) {
    const Moment& moment = placed.moment;
    Bytes bytes;
    addCamera(placed.camera, bytes);
    bytes.add(moment.lights.size());
    for (const PlacedLight& light : moment.lights) addLight(light, bytes);
    bytes.add(moment.instances.size());
    for (const Instance& instance : moment.instances) addInstance(instance, bytes);
    for (const Displacement& procedure : scene.displacements) {
        float amplitude = 0.0f;
        sample(procedure.amplitude, moment.timeSeconds, false, std::span(&amplitude, 1));
        bytes.add(amplitude);
        bytes.add(double(procedure.speed) * moment.timeSeconds);
    }
    if (nodes) bytes.addAll(moment.worldFromNode);
    return bytes.take();
}

}  // namespace umbrage

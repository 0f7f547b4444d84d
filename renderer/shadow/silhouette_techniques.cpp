// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <stdexcept>

#include "shadow/silhouette.h"

namespace umbrage {

// One line a technique; each is in a file of its name.
std::unique_ptr<SilhouetteTechnique> makeComputeSilhouettes(Fault fault);
std::unique_ptr<SilhouetteTechnique> makeVertexReject(Fault fault);
std::unique_ptr<SilhouetteTechnique> makeVertexRejectReadback(Fault fault);
std::unique_ptr<SilhouetteTechnique> makeDegenerateQuads(Fault fault);
std::unique_ptr<SilhouetteTechnique> makeGeometryShader(Fault fault);
std::unique_ptr<SilhouetteTechnique> makeCpuSilhouettes();

std::unique_ptr<SilhouetteTechnique> makeSilhouetteTechnique(std::string_view name, Fault fault) {
    if (name == "compute") return makeComputeSilhouettes(fault);
    if (name == "vertex-reject") return makeVertexReject(fault);
    if (name == "vertex-reject-readback") return makeVertexRejectReadback(fault);
    if (name == "degenerate-quad") return makeDegenerateQuads(fault);
    if (name == "geometry-shader") return makeGeometryShader(fault);
    if (name == "cpu") return makeCpuSilhouettes();
    throw std::logic_error("no such silhouette technique: " + std::string(name));
}

}  // namespace umbrage

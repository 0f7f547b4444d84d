// SPDX-License-Identifier: Apache-2.0
// Surdulescu 2003: a quad of no width along every edge, opened in the vertex stage (degenerate.vert.glsl).
#include "shadow/sides.h"
#include "shadow/silhouette_classed.h"

namespace umbrage {
namespace {

class DegenerateQuads : public ClassedSilhouettes {
public:
    explicit DegenerateQuads(Fault fault) : ClassedSilhouettes(fault), fault_(fault) {}

    std::string_view name() const override { return "degenerate-quad"; }
    SideShaders sideShaders() const override { return {"degenerate.vert", "", {planted(fault_)}}; }
    void drawSides(const SideList& sides, const gpu::Program& program) override {
        bindClasses();
        quads_.draw(sides, program, mostQuads(sides.list));
    }

private:
    Fault fault_;
    EverySide quads_;
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeDegenerateQuads(Fault fault) {
    return std::make_unique<DegenerateQuads>(fault);
}

}  // namespace umbrage

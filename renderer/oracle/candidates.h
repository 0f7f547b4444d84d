// SPDX-License-Identifier: Apache-2.0
// Which triangles a ray may meet: Embree's hierarchy over boxes that are grown outward by more than its traversal can
// round. Embree's own triangle test is not used, because it misses (docs/rules.md, T13); whoever asks decides exactly.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "oracle/formulas.h"

namespace umbrage::oracle {

class Candidates {
public:
    /// `corners` must outlive the object. @throws Error(Device) where Embree fails
    explicit Candidates(std::span<const Corners> corners);
    ~Candidates();

    /// How far from the true one the origin of a ray may be, in each coordinate.
    double tolerance() const;

    /// Visits triangles whose grown box the ray meets within `length` (in units of its direction, may be infinite), in
    /// no particular order, and maybe some more. `visit(index)` returns the length that is still of interest; below 0:
    /// nothing any more. Safe to call from several threads.
    template <class Visit>
    void along(const Ray& ray, double length, Visit&& visit) const {
        const auto call = [](void* what, std::uint32_t triangle) {
            return double((*static_cast<std::remove_reference_t<Visit>*>(what))(triangle));
        };
        traverse(ray, length, call, &visit);
    }

private:
    using Call = double (*)(void*, std::uint32_t);
    void visitAll(Call call, void* what) const;
    void traverse(const Ray& ray, double length, Call call, void* what) const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace umbrage::oracle

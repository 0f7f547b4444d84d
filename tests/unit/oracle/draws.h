// SPDX-License-Identifier: Apache-2.0
// What rapidcheck's generators lack here.
#pragma once

#include <rapidcheck.h>

#include <glm/glm.hpp>
#include <vector>

// Counterexamples are printed by what is found in the type's namespace.
namespace glm {
template <length_t L, class T, qualifier Q>
void showValue(const vec<L, T, Q>& v, std::ostream& os) {
    os.precision(17);
    for (length_t i = 0; i < L; ++i) os << (i ? ", " : "(") << v[i];
    os << ")";
}
}  // namespace glm

namespace umbrage::oracle {

/// Not scaled to the size of the case: small cases would hardly differ.
template <class T>
rc::Gen<T> range(T from, T to) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(from, to));
}

template <class T>
std::vector<T> draw(std::size_t count, const rc::Gen<T>& gen) {
    return *rc::gen::container<std::vector<T>>(count, gen);
}

}  // namespace umbrage::oracle

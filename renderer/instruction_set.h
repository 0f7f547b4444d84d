// SPDX-License-Identifier: Apache-2.0
// Which of the copies of a function, compiled for several instruction sets, this processor can run.
#pragma once

namespace umbrage {

/// The last that it can. As renderer/CMakeLists.txt compiles <path>_<set>.cpp.
template <class Function>
Function* forThisProcessor(Function* baseline, Function* avx2, Function* avx512) {
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return baseline;
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    return wide ? avx512 : avx2;
}

}  // namespace umbrage

// SPDX-License-Identifier: Apache-2.0
// Sixteen floats or integers at a time, in whatever registers the file that includes it is compiled for. Nothing here
// may come from the standard library: the linker keeps one copy of what several files instantiate.

#include <immintrin.h>

namespace umbrage {
namespace {

typedef float Floats __attribute__((vector_size(64)));
typedef std::int32_t Ints __attribute__((vector_size(64)));  // a comparison: -1 where it holds
constexpr int kLanes = 16;
constexpr float kInfinity = __builtin_inff();

struct Floats3 {
    Floats x, y, z;
};

inline Floats3 operator+(const Floats3& a, const Floats3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Floats3 operator*(const Floats& s, const Floats3& v) {
    return {s * v.x, s * v.y, s * v.z};
}
inline Floats dot(const Floats3& a, const Floats3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Floats3 spread(const float (&v)[3]) {
    return {Floats{} + v[0], Floats{} + v[1], Floats{} + v[2]};
}

template <class Vector, class Element>
inline Vector load(const Element* p) {
    Vector v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
template <class Vector, class Element>
inline void store(Element* p, const Vector& v) {
    __builtin_memcpy(p, &v, sizeof v);
}

/// One bit for each lane of a comparison.
inline std::uint32_t bitsOf(const Ints& v) {
#if defined(__AVX512DQ__)
    __m512i all;
    __builtin_memcpy(&all, &v, sizeof all);
    return _mm512_movepi32_mask(all);
#elif defined(__AVX2__)
    __m256 halves[2];
    __builtin_memcpy(halves, &v, sizeof halves);
    return std::uint32_t(_mm256_movemask_ps(halves[0])) | std::uint32_t(_mm256_movemask_ps(halves[1])) << 8;
#else
    __m128 quarters[4];
    __builtin_memcpy(quarters, &v, sizeof quarters);
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits |= std::uint32_t(_mm_movemask_ps(quarters[i])) << (4 * i);
    return bits;
#endif
}

inline bool any(const Ints& v) {
    return bitsOf(v) != 0;
}
inline Floats larger(const Floats& a, const Floats& b) {
    return a > b ? a : b;
}
inline Floats smaller(const Floats& a, const Floats& b) {
    return a < b ? a : b;
}
inline Floats within01(const Floats& a) {
    return smaller(larger(a, Floats{}), Floats{} + 1.0f);
}
inline Floats magnitude(const Floats& a) {
    return larger(a, -a);
}
inline Floats root(const Floats& a) {
    Floats r{};
    for (int i = 0; i < kLanes; ++i) r[i] = __builtin_sqrtf(a[i]);
    return r;
}
inline Floats3 unit(const Floats3& v) {
    return (1.0f / root(larger(dot(v, v), Floats{} + 1e-30f))) * v;
}

/// values[index], lane by lane. Compilers do not make the instruction of it by themselves.
template <class Vector, class Element>
inline Vector gather(const Element* values, const Ints& index) {
    static_assert(sizeof(Element) == 4);
    Vector result{};
#if defined(__AVX512F__)
    __m512i at;
    __builtin_memcpy(&at, &index, sizeof at);
    // The plain form begins with a register that GCC 12 calls uninitialised.
    const __m512 found = _mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, at, values, 4);
    __builtin_memcpy(&result, &found, sizeof result);
#elif defined(__AVX2__)
    __m256i at[2];
    __builtin_memcpy(&at, &index, sizeof at);
    const __m256 found[2] = {_mm256_i32gather_ps(reinterpret_cast<const float*>(values), at[0], 4),
                             _mm256_i32gather_ps(reinterpret_cast<const float*>(values), at[1], 4)};
    __builtin_memcpy(&result, &found, sizeof result);
#else
    for (int i = 0; i < kLanes; ++i) __builtin_memcpy(reinterpret_cast<char*>(&result) + 4 * i, values + index[i], 4);
#endif
    return result;
}
inline Floats3 gather3(const float* values, const Ints& index) {
    return {gather<Floats>(values, index), gather<Floats>(values + 1, index), gather<Floats>(values + 2, index)};
}

}  // namespace
}  // namespace umbrage

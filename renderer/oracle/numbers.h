// SPDX-License-Identifier: Apache-2.0
// The two kinds of numbers predicates are made of: doubles that know how wrong they may be, and exact ones. A formula
// (formulas.h) is written once and evaluated in Bounded; where that leaves the sign open, again in Exact.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>

namespace umbrage::oracle {

/// A double within `error` of the true value: forward error analysis that runs along. Rounding of the bound itself is
/// covered by kUp. Not for directed rounding modes; compile without FMA contraction.
struct Bounded {
    double value = 0.0, error = 0.0;

    Bounded() = default;
    Bounded(double exact) : value(exact) {}  // NOLINT: input numbers are exact
    Bounded(double v, double e) : value(v), error(e) {}

    bool isZero() const { return value == 0.0 && error == 0.0; }
    bool signKnown() const { return std::abs(value) > error || error == 0.0; }  // false for NaN and infinity - infinity
    int sign() const { return (value > 0.0) - (value < 0.0); }
};

inline constexpr double kHalfUlp = 0x1p-53;
inline constexpr double kUp = 1.0 + 0x1p-49;

inline Bounded operator-(const Bounded& a) {
    return {-a.value, a.error};
}
inline Bounded operator+(const Bounded& a, const Bounded& b) {
    const double v = a.value + b.value;
    return {v, (a.error + b.error + std::abs(v) * kHalfUlp) * kUp};  // sums never underflow
}
inline Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + -b;
}
inline Bounded operator*(const Bounded& a, const Bounded& b) {
    if (a.isZero() || b.isZero()) return {};
    const double v = a.value * b.value;
    const double underflow = std::abs(v) < 0x1p-960 ? 0x1p-1020 : 0.0;
    return {v, (std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error + std::abs(v) * kHalfUlp +
                underflow) *
                   kUp};
}
/// An infinite error where the divisor may be 0.
inline Bounded operator/(const Bounded& a, const Bounded& b) {
    const double least = std::abs(b.value) - b.error;
    const double v = a.value / b.value;
    if (!(least > 0.0)) return {v, std::numeric_limits<double>::infinity()};
    const double underflow = std::abs(v) < 0x1p-960 ? 0x1p-1020 : 0.0;
    // Each error is divided by itself: the product of a quotient and a tiny divisor's error would vanish.
    return {v, (a.error / least + std::abs(v) * (b.error / least) + std::abs(v) * kHalfUlp + underflow) * kUp};
}

/// mantissa * 2^exponent: sums, differences and products of doubles, exactly.
class Exact {
public:
    Exact() = default;
    Exact(double value) {  // NOLINT: as Bounded
        if (value == 0.0) return;
        const double fraction = std::frexp(value, &exponent_);
        mantissa_ = std::ldexp(fraction, 53);
        exponent_ -= 53;
    }

    int sign() const { return sgn(mantissa_); }

    Exact operator-() const { return {-mantissa_, exponent_}; }
    friend Exact operator*(const Exact& a, const Exact& b) {
        return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
    }
    friend Exact operator+(const Exact& a, const Exact& b) {
        if (a.sign() == 0) return b;
        if (b.sign() == 0) return a;
        return a.exponent_ >= b.exponent_ ? sum(a, b) : sum(b, a);
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }

    /// a / b, to a few units in the last place.
    friend double quotient(const Exact& a, const Exact& b) {
        long exponentA = 0, exponentB = 0;
        const double fractionA = mpz_get_d_2exp(&exponentA, a.mantissa_.get_mpz_t());
        const double fractionB = mpz_get_d_2exp(&exponentB, b.mantissa_.get_mpz_t());
        return std::ldexp(fractionA / fractionB, int(exponentA - exponentB) + a.exponent_ - b.exponent_);
    }

private:
    Exact(mpz_class mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

    static Exact sum(const Exact& high, const Exact& low) {
        const auto shift = mp_bitcnt_t(high.exponent_ - low.exponent_);
        return {mpz_class(high.mantissa_ << shift) + low.mantissa_, low.exponent_};
    }

    mpz_class mantissa_;
    int exponent_ = 0;
};

}  // namespace umbrage::oracle

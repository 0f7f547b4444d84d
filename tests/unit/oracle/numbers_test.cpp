// SPDX-License-Identifier: Apache-2.0
// The numbers predicates are made of: a Bounded is never farther from the truth than it says, an Exact is the truth.
#include "oracle/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "draws.h"

namespace umbrage::oracle {
namespace {

/// Finite doubles of all kinds: any bits, around 1 and nearly equal to each other, at both ends of the range.
rc::Gen<double> doubles() {
    const auto anyBits =
        rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()), [](std::uint64_t bits) {
            const double value = std::bit_cast<double>(bits);
            return std::isfinite(value) ? value : 0.0;
        });
    const auto scaled = [](int lowest, int highest) {
        return rc::gen::map(rc::gen::pair(range<std::int64_t>(-(1LL << 53), 1LL << 53), range(lowest, highest)),
                            [](const auto& parts) { return std::ldexp(double(parts.first), parts.second - 53); });
    };
    const auto nearOne = rc::gen::map(range(-3, 4), [](int ulps) { return 1.0 + ulps * 0x1p-52; });
    const auto whole = rc::gen::map(range(-3, 4), [](int i) { return double(i); });
    return rc::gen::oneOf(anyBits, scaled(-8, 8), scaled(-1073, -940), scaled(-560, -470), scaled(900, 1023), nearOne,
                          whole);
}

/// One operation of a straight-line program: on earlier results, by their number.
struct Step {
    int operation;
    std::size_t left, right;
};

void showValue(const Step& step, std::ostream& os) {
    os << step.left << " "
       << "+-*/"[step.operation] << " " << step.right;
}

rc::Gen<std::vector<Step>> programs(int operations) {
    return rc::gen::container<std::vector<Step>>(
        6, rc::gen::build<Step>(rc::gen::set(&Step::operation, range(0, operations)),
                                rc::gen::set(&Step::left, range<std::size_t>(0, 64)),
                                rc::gen::set(&Step::right, range<std::size_t>(0, 64))));
}

template <class N>
N apply(int operation, const N& a, const N& b) {
    switch (operation) {
        case 0:
            return a + b;
        case 1:
            return a - b;
        default:
            return a * b;
    }
}

/// |bounded - truth| <= error, or the error is infinite or unknown.
void checkBound(const Bounded& bounded, const mpq_class& truth) {
    if (bounded.signKnown()) RC_ASSERT(bounded.sign() == sgn(truth));
    if (!std::isfinite(bounded.value) || !std::isfinite(bounded.error)) return;
    RC_ASSERT(abs(mpq_class(bounded.value) - truth) <= mpq_class(bounded.error));
}

RC_GTEST_PROP(Bounded, IsNeverFartherFromTheTruthThanItSays, ()) {
    std::vector<double> leaves = *rc::gen::container<std::vector<double>>(5, doubles());
    std::vector<Bounded> bounded(leaves.begin(), leaves.end());
    std::vector<mpq_class> truth(leaves.begin(), leaves.end());
    for (const Step& step : *programs(4)) {
        const std::size_t i = step.left % bounded.size(), j = step.right % bounded.size();
        if (step.operation == 3) {
            if (truth[j] == 0) continue;
            bounded.push_back(bounded[i] / bounded[j]);
            truth.push_back(truth[i] / truth[j]);
        } else {
            bounded.push_back(apply(step.operation, bounded[i], bounded[j]));
            truth.push_back(apply(step.operation, truth[i], truth[j]));
        }
        if (mpz_sizeinbase(truth.back().get_num_mpz_t(), 2) > 60000) break;
        checkBound(bounded.back(), truth.back());
    }
}

RC_GTEST_PROP(Bounded, QuotientsOfUncertainNumbersAreCovered, ()) {
    // A divisor within a factor of two of its own error, and a dividend that moves with its own.
    const double a = *doubles(), b = *doubles(), shareA = *rc::gen::map(range(-64, 65), [](int i) { return i / 64.0; });
    const double shareB = *rc::gen::map(range(-64, 65), [](int i) { return i / 64.0; });
    const double errorA = std::abs(*doubles()),
                 errorB = std::abs(b) * *rc::gen::element(0.0, 0x1p-50, 0x1p-20, 0.25, 0.5);
    const Bounded quotient = Bounded(a, errorA) / Bounded(b, errorB);
    const mpq_class divisor = mpq_class(b) + mpq_class(shareB) * mpq_class(errorB);
    if (divisor == 0) return;
    checkBound(quotient, mpq_class((mpq_class(a) + mpq_class(shareA) * mpq_class(errorA)) / divisor));
}

RC_GTEST_PROP(Bounded, ProductsOfUncertainNumbersAreCovered, ()) {
    const double a = *doubles(), b = *doubles();
    const double errorA = std::abs(*doubles()), errorB = std::abs(*doubles());
    for (const int signA : {-1, 1}) {
        for (const int signB : {-1, 1}) {
            const mpq_class x = mpq_class(a) + signA * mpq_class(errorA), y = mpq_class(b) + signB * mpq_class(errorB);
            checkBound(Bounded(a, errorA) * Bounded(b, errorB), mpq_class(x * y));
            checkBound(Bounded(a, errorA) + Bounded(b, errorB), mpq_class(x + y));
        }
    }
}

TEST(Bounded, DecidesOrdinaryDeterminantsAndLeavesCancelledOnesOpen) {
    const auto determinant = [](double a, double b, double c, double d) {
        return Bounded(a) * Bounded(d) - Bounded(b) * Bounded(c);
    };
    EXPECT_TRUE(determinant(0.1, 0.2, 0.3, 0.7).signKnown());
    EXPECT_TRUE(determinant(1.0, 1.0, 1.0, 1.0 + 0x1p-50).signKnown());
    EXPECT_FALSE(determinant(0.1, 0.2, 0.3, 0.6).signKnown());
    EXPECT_FALSE(determinant(1e300, 1e300, 1e300, 1e300).signKnown());  // overflows
    EXPECT_FALSE((Bounded(1.0) / (Bounded(0.1) * Bounded(3.0) - Bounded(0.3))).signKnown());
}

TEST(Bounded, ProductsWithZeroAreKnownToBeZero) {
    const Bounded uncertain = Bounded(0.1) * Bounded(0.1), zero = uncertain * Bounded(0.0) + Bounded(0.0) * uncertain;
    EXPECT_TRUE(zero.isZero());
    EXPECT_TRUE(zero.signKnown());
    EXPECT_EQ(zero.sign(), 0);
}

RC_GTEST_PROP(Exact, AgreesWithRationals, ()) {
    std::vector<double> leaves = *rc::gen::container<std::vector<double>>(5, doubles());
    std::vector<Exact> exact(leaves.begin(), leaves.end());
    std::vector<mpq_class> truth(leaves.begin(), leaves.end());
    for (const Step& step : *programs(3)) {
        const std::size_t i = step.left % exact.size(), j = step.right % exact.size();
        exact.push_back(apply(step.operation, exact[i], exact[j]));
        truth.push_back(apply(step.operation, truth[i], truth[j]));
        RC_ASSERT(exact.back().sign() == sgn(truth.back()));
        for (const double leaf : leaves) {
            RC_ASSERT((exact.back() - Exact(leaf)).sign() == sgn(mpq_class(truth.back() - mpq_class(leaf))));
        }
        RC_ASSERT((-exact.back()).sign() == -exact.back().sign());
    }
}

RC_GTEST_PROP(Exact, IsARing, ()) {
    const Exact a(*doubles()), b(*doubles()), c(*doubles()), one(1.0);
    const auto equal = [](const Exact& x, const Exact& y) { return (x - y).sign() == 0; };
    RC_ASSERT(equal(a + b, b + a));
    RC_ASSERT(equal(a * b, b * a));
    RC_ASSERT(equal((a + b) + c, a + (b + c)));
    RC_ASSERT(equal((a * b) * c, a * (b * c)));
    RC_ASSERT(equal(a * (b + c), a * b + a * c));
    RC_ASSERT(equal(a * one, a));
    RC_ASSERT(equal(a + Exact(0.0), a));
    RC_ASSERT(equal(a + -a, Exact()));
}

RC_GTEST_PROP(Exact, AgreesWithWholeNumbersOf128Bits, ()) {
    const auto whole = range<std::int64_t>(-(1LL << 53), (1LL << 53) + 1);
    const std::int64_t a = *whole, b = *whole, c = *whole, d = *whole;
    const __int128 determinant = __int128(a) * d - __int128(b) * c;
    const Exact exact = Exact(double(a)) * Exact(double(d)) - Exact(double(b)) * Exact(double(c));
    RC_ASSERT(exact.sign() == (determinant > 0) - (determinant < 0));
    // And not only its sign: the difference from the same number in two halves is nothing.
    const __int128 high = determinant / (1LL << 50), low = determinant % (1LL << 50);
    RC_ASSERT((exact - Exact(double(std::int64_t(high / 1024))) * Exact(0x1p60) -
               Exact(double(std::int64_t(high % 1024))) * Exact(0x1p50) - Exact(double(std::int64_t(low))))
                  .sign() == 0);
}

TEST(Exact, KeepsTheSmallestNextToTheLargest) {
    const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
    const Exact sum = Exact(most) + Exact(least);
    EXPECT_EQ((sum - Exact(most)).sign(), 1);
    EXPECT_EQ((sum - Exact(most) - Exact(least)).sign(), 0);
    EXPECT_EQ((Exact(least) * Exact(least)).sign(), 1);
    EXPECT_EQ((Exact(-least) * Exact(least) * Exact(least)).sign(), -1);
    EXPECT_EQ((Exact(most) * Exact(most) * Exact(-most)).sign(), -1);
    EXPECT_EQ((Exact(0x1p-1060) * Exact(0x1p1000) - Exact(0x1p-60)).sign(), 0);
    EXPECT_EQ(Exact(-0.0).sign(), 0);
}

}  // namespace
}  // namespace umbrage::oracle

// SPDX-License-Identifier: Apache-2.0
// Every counter beside a count that shares nothing with the code that makes it. What the tests compare becomes
// docs/counter-checks.md by
//     UMBRAGE_COUNTER_TABLE=docs/counter-checks.md build/test_gpu --gtest_filter='*Fill*:*Sums*:*Overdraw*:*Counters*'
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "diagnostics/counters.h"

namespace umbrage::test {

/// Expects both to be equal, or not further apart than `tolerance`.
///
/// @param against  what counted `theirs`: a row of the table for each counter and each of these
void expectCounter(const Counter& counter, const std::string& against, double ours, double theirs,
                   double tolerance = 0.0);

}  // namespace umbrage::test

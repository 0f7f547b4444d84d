// SPDX-License-Identifier: Apache-2.0
// Errors of the job room, checked for their place, their sentence and their hint.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "error.h"
#include "job/job.h"

namespace umbrage {

struct Expected {
    std::string where, message, hint;  // message and hint: a part
};

inline void expectError(const std::function<void()>& act, const Expected& expected) {
    try {
        act();
        ADD_FAILURE() << "no error; expected " << expected.where << ": " << expected.message;
    } catch (const Error& error) {
        EXPECT_EQ(error.where(), expected.where) << error.what();
        EXPECT_THAT(error.message(), testing::HasSubstr(expected.message));
        EXPECT_THAT(error.hint(), testing::HasSubstr(expected.hint));
    }
}

/// A sequence named s.yaml in the folder /seq. Its first two lines are the smallest valid sequence; `more` begins on
/// line 3.
inline std::string sequence(const std::string& more) {
    return "umbrage: 1\nscene: [{gltf: a.glb}]\n" + more;
}

inline Job read(const std::string& yaml, const JobOverrides& overrides = {}) {
    return parseJob(yaml, "s.yaml", "/seq", overrides);
}

inline void expectRefused(const std::string& yaml, const Expected& expected) {
    SCOPED_TRACE(yaml.substr(0, 300));
    expectError([&] { read(yaml); }, expected);
}

}  // namespace umbrage

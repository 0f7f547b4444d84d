// SPDX-License-Identifier: Apache-2.0
// A folder of its own for each test, with small sequences of the scenes in scenes/.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "process.h"

namespace umbrage::cli {

class Workspace : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// The test's folder, in which the program runs.
    const std::filesystem::path& folder() const { return folder_; }

    /// seq.yaml: three frames of the lantern at 64x48 into out/, and `more`.
    void writeSequence(const std::string& more = "") const;
    void writeFile(const std::filesystem::path& name, const std::string& text) const;

    Result umbrage(const std::vector<std::string>& arguments) const;
    Result umbrage(Launch launch, const std::vector<std::string>& arguments) const;

    /// Files below a folder of the test's, relative to it, sorted; hidden ones too. Without the manifests that lie
    /// beside pictures.
    std::vector<std::string> filesIn(const std::filesystem::path& name) const;

private:
    std::filesystem::path folder_;
};

std::string contentsOf(const std::filesystem::path& file);

/// scenes/NAME.glb of the repository.
std::string sceneFile(const std::string& name);

/// The channels of an image file, in its order; fails the test where it cannot be read.
std::vector<std::string> channelsOf(const std::filesystem::path& image);

/// All values of an image file, channels interleaved: whole numbers of UINT, others as fractions of their type's range.
std::vector<double> valuesOf(const std::filesystem::path& image);

}  // namespace umbrage::cli

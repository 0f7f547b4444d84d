// SPDX-License-Identifier: Apache-2.0
// Every test has a context, also one that runs alone and makes something on the device before it asks for one.
#include "techniques.h"

namespace umbrage::test {
namespace {

class WithContext : public testing::Environment {
public:
    void SetUp() override { context(); }
};

const testing::Environment* const environment = testing::AddGlobalTestEnvironment(new WithContext);

}  // namespace
}  // namespace umbrage::test

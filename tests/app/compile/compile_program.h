// Maps for `temblor compile`, and a temporary folder to run it in.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "formats/levels/bsp.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {

// A room with one wall texture, a player start, and a colored light.
std::string lit_room();
// Rows of side * side pillars, each slightly displaced, so that visibility takes long to compute.
std::string hall_of_pillars(int side);

class CompileProgram : public ::testing::Test {
 protected:
  // CHECKs that it exists and is valid.
  formats::Bsp read_level(const std::string& name);
  TemporaryFolder folder_;
};

}  // namespace temblor::test

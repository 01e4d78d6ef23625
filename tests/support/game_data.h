// Stock data for tests: TEMBLOR_DATA names the folder that contains the game folders (id1).
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "base/bytes.h"

namespace temblor::test {

// TEMBLOR_DATA, if it is set and names a folder.
std::optional<std::filesystem::path> data_folder();

// Reads a file on disk. CHECKs that it can be read.
base::ByteVector read_file(const std::filesystem::path& path);

}  // namespace temblor::test

// Declares `variable` as the base folder, or skips the test with a message.
#define DATA_FOLDER_OR_SKIP(variable)                                                      \
  const auto variable##_optional = ::temblor::test::data_folder();                         \
  if (!variable##_optional) GTEST_SKIP() << "TEMBLOR_DATA names no folder with game data"; \
  const std::filesystem::path& variable = *variable##_optional

// Compiles QuakeC source with fteqcc, if it is installed.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string_view>

#include "base/bytes.h"
#include "vm/program.h"

namespace temblor::test {

bool has_quakec_compiler();

// Returns the progs.dat of one source file, "test.qc". `options`: those of fteqcc, such as "-Tfte". CHECKs
// that it compiles.
base::ByteVector compile_quakec(std::string_view source, std::string_view options = "");
// Like compile_quakec(), but loads the program.
std::shared_ptr<const vm::Program> load_quakec(std::string_view source, std::string_view options = "");

}  // namespace temblor::test

#define SKIP_WITHOUT_QUAKEC() \
  if (!::temblor::test::has_quakec_compiler()) GTEST_SKIP() << "fteqcc, which compiles QuakeC, is not here"

// Declares `variable` as the program of that source, or skips the test with a message.
#define QUAKEC_OR_SKIP(variable, source) \
  SKIP_WITHOUT_QUAKEC();                 \
  const auto variable = ::temblor::test::load_quakec(source)

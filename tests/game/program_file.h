// The contents of a compiled QuakeC program, read by hand from the description of the format, so
// that the compiler's output is not judged by the engine's own reader.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace temblor::test {

struct ProgramFile {
  std::int32_t version = 0;
  std::int32_t crc = 0;
  std::set<std::uint16_t> opcodes;
  std::set<std::string> functions;  // with a body
  std::set<std::string> builtins;   // the program's names of built-in functions
  std::set<std::int32_t> builtin_numbers;
  std::set<std::string> fields;
  std::set<std::string> strings;  // all strings, including those in the code
};

// CHECKs that the file exists and is complete.
ProgramFile read_program_file(const std::filesystem::path& path);

}  // namespace temblor::test

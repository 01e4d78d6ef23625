// What a compiled QuakeC program says of itself, read by hand from the table in the format's description, so
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
  std::set<std::string> functions;  // that have a body
  std::set<std::string> builtins;   // names given to those of the engine
  std::set<std::int32_t> builtin_numbers;
  std::set<std::string> fields;
  std::set<std::string> strings;  // all there are, those of the code among them
};

// CHECKs that the file is there and whole.
ProgramFile read_program_file(const std::filesystem::path& path);

}  // namespace temblor::test

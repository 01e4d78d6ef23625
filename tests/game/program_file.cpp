#include "game/program_file.h"

#include <cstddef>
#include <cstring>

#include "base/check.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

constexpr std::size_t kHeaderBytes = 60;
constexpr std::size_t kStatementBytes = 8;
constexpr std::size_t kDefinitionBytes = 8;
constexpr std::size_t kFunctionBytes = 36;

template <typename T>
T number_at(const base::ByteVector& bytes, std::size_t offset) {
  CHECK(offset + sizeof(T) <= bytes.size(), "the program ends at {}", bytes.size());
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

// A part of the file, from the header: offset and count.
struct Part {
  std::size_t offset, count;
};

Part part_at(const base::ByteVector& bytes, std::size_t header_offset) {
  return {number_at<std::uint32_t>(bytes, header_offset), number_at<std::uint32_t>(bytes, header_offset + 4)};
}

}  // namespace

ProgramFile read_program_file(const std::filesystem::path& path) {
  const base::ByteVector bytes = read_file(path);
  CHECK(bytes.size() >= kHeaderBytes, "{} is too short", path.string());
  const Part statements = part_at(bytes, 8);
  const Part fields = part_at(bytes, 24);
  const Part functions = part_at(bytes, 32);
  const Part strings = part_at(bytes, 40);
  CHECK(strings.offset + strings.count <= bytes.size(), "strings end at {}", bytes.size());
  const std::string text(reinterpret_cast<const char*>(bytes.data()) + strings.offset, strings.count);
  const auto name_at = [&text](std::uint32_t offset) { return std::string(text.c_str() + offset); };

  ProgramFile program;
  program.version = number_at<std::int32_t>(bytes, 0);
  program.crc = number_at<std::int32_t>(bytes, 4);
  for (std::size_t i = 0; i < statements.count; ++i)
    program.opcodes.insert(number_at<std::uint16_t>(bytes, statements.offset + i * kStatementBytes));
  for (std::size_t i = 0; i < fields.count; ++i)
    program.fields.insert(name_at(number_at<std::uint32_t>(bytes, fields.offset + i * kDefinitionBytes + 4)));
  for (std::size_t i = 1; i < functions.count; ++i) {
    const std::size_t offset = functions.offset + i * kFunctionBytes;
    const auto first = number_at<std::int32_t>(bytes, offset);
    const std::string name = name_at(number_at<std::uint32_t>(bytes, offset + 16));
    if (first > 0) program.functions.insert(name);
    if (first < 0) program.builtins.insert(name);
    if (first < 0) program.builtin_numbers.insert(-first);
  }
  for (std::size_t at = 0; at < text.size(); at += std::strlen(text.c_str() + at) + 1)
    program.strings.insert(text.c_str() + at);
  return program;
}

}  // namespace temblor::test

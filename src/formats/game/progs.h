// Compiled QuakeC (progs.dat), version 6: bytes to structs and back. What the numbers mean is the business of
// vm; here they are only inside their bounds.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// Of a definition and of its value.
enum class ProgsType : std::uint8_t {
  kVoid = 0,
  kString = 1,
  kFloat = 2,
  kVector = 3,  // three words
  kEntity = 4,
  kField = 5,
  kFunction = 6,
  kPointer = 7,
};

// Operands are word offsets among the globals, or, of jumps, statements to go on (signed).
struct ProgsStatement {
  std::uint16_t op = 0;
  std::array<std::uint16_t, 3> operands{};
  bool operator==(const ProgsStatement&) const = default;
};

// A named global, or a field of entities.
struct ProgsDefinition {
  ProgsType type = ProgsType::kVoid;
  bool is_saved = false;
  std::uint16_t offset = 0;  // in words: among the globals, or in an entity
  std::uint32_t name = 0;    // into strings
  bool operator==(const ProgsDefinition&) const = default;
};

struct ProgsFunction {
  std::int32_t first_statement = 0;  // negative: built-in function -first_statement
  std::uint32_t first_local = 0;     // global words; the parameters are the first of them
  std::uint32_t local_count = 0;
  std::uint32_t name = 0, file = 0;               // into strings
  std::int32_t parameter_count = 0;               // at most 8; below 0: as many as the caller likes
  std::array<std::uint8_t, 8> parameter_words{};  // of each: 1 or 3
  bool operator==(const ProgsFunction&) const = default;
};

struct Progs {
  std::uint32_t crc = 0;  // of the system definitions that it was compiled with: 5927 for Quake's
  std::vector<ProgsStatement> statements;
  std::vector<ProgsDefinition> globals, fields;
  std::vector<ProgsFunction> functions;  // [0] stands for no function
  std::string strings;                   // all of them, each with a zero behind it; begins with the empty one
  std::vector<std::uint32_t> global_words;
  std::uint32_t entity_words = 0;  // words that an entity has

  // Valid offsets only.
  std::string_view string_at(std::uint32_t offset) const { return strings.data() + offset; }
  bool operator==(const Progs&) const = default;
};

constexpr std::int32_t kProgsVersion = 6;
constexpr std::uint32_t kReservedGlobalWords = 28;  // nothing, the returned value and eight parameters
constexpr std::uint32_t kMaxEntityWords = 1 << 16;  // all that a field's 16 bits can name
constexpr std::int32_t kMaxParameters = 8;
constexpr std::uint32_t kQuakeProgsCrc = 5927;

// Words that a value of that type takes.
constexpr std::uint32_t words_of(ProgsType type) {
  return type == ProgsType::kVoid ? 0 : type == ProgsType::kVector ? 3 : 1;
}

// Of a Progs that was read: at least one statement, function and the 28 reserved global words; every name and
// file is a string of `strings`, at most 1024 characters long; these begin and end with a zero; definitions
// and locals lie inside the globals or the entity; functions that have statements begin inside them and take
// at most 8 parameters. kUnsupported for other versions (7 and up: fteqcc's own), with what to do about it.
// Operations and operands of statements are anything.
base::Result<Progs> read_progs(base::Bytes bytes);

// CHECKs nothing: what is written is what is there.
base::ByteVector write_progs(const Progs& progs);

}  // namespace temblor::formats

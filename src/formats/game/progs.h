// Compiled QuakeC (progs.dat), versions 6 and 7: converts between bytes and structs, and validates indices.
// src/vm defines the meaning of the statements. Sections may be anywhere in the file:
//
//   header, 60 bytes       0  version i32            6, or 7 for the layouts below
//                          4  crc i32                of the system definitions (progdefs.h of the original)
//                          8  statements             each section: offset in the file i32, count i32
//                         16  global definitions
//                         24  field definitions
//                         32  functions
//                         40  strings                count in bytes
//                         48  global words           initial values, 4 bytes each
//                         56  entity words i32       size of an entity's fields
//   statement, 8 bytes     0  op u16 | 2 a u16 | 4 b u16 | 6 c u16
//   definition, 8 bytes    0  type u16 (bit 15: saved) | 2 offset u16 | 4 name i32
//                             fteqcc uses types above 7 for integers, structs, arrays, and so on
//   function, 36 bytes     0  first statement i32    negative: built-in function
//                          4  first local i32        a global word
//                          8  number of locals i32   words, including parameters
//                         12  profile i32            only used in memory
//                         16  name i32, 20 file i32  into the strings
//                         24  parameter count i32
//                         28  parameter words u8[8]
//
// Version 7 has 32 more bytes of header. The last number selects the layout (ProgsLayout):
//
//   wide statement, 16 bytes    0  op u32 | 4 a u32 | 8 b u32 | 12 c u32
//   wide definition, 12 bytes   0  type u32 (bit 15: saved) | 4 offset u32 | 8 name i32
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// Type of a definition and its value. Definitions only serve debuggers, saved games, and lookups by name, so
// higher numbers, which compilers have added, are kept: nothing is known about their values.
enum class ProgsType : std::uint16_t {
  kVoid = 0,
  kString = 1,
  kFloat = 2,
  kVector = 3,  // three 32-bit words
  kEntity = 4,
  kField = 5,
  kFunction = 6,
  kPointer = 7,
};

// The layouts of version 7. fteqcc writes the first two for -Tfte, the second one if a program has more than
// 65535 global words, and the third one for -Tkkqwsv.
enum class ProgsLayout : std::uint8_t {
  kNarrow,          // version 6, or version 7 with the number 0x021b1461: as shown
  kWide,            // 0x65167402: wide statements and definitions
  kWideStatements,  // other numbers, or no further header: wide statements only
};

// One statement. Operands are word offsets into the globals; for jumps, signed distances in statements. In
// narrow layouts, a distance has 16 bits.
struct ProgsStatement {
  std::uint32_t op = 0;
  std::array<std::uint32_t, 3> operands{};
  bool operator==(const ProgsStatement&) const = default;
};

// A named global, or a field of an entity.
struct ProgsDefinition {
  ProgsType type = ProgsType::kVoid;
  bool is_saved = false;     // the value of a global is part of saved games
  std::uint32_t offset = 0;  // in words: among the globals, or in an entity
  std::uint32_t name = 0;    // into strings
  bool operator==(const ProgsDefinition&) const = default;
};

// A QuakeC function, or a built-in function of the engine.
struct ProgsFunction {
  // Negative: built-in function number -first_statement. 0: a built-in function that is found by its name.
  std::int32_t first_statement = 0;
  std::uint32_t first_local = 0;  // global word of the first local; parameters come first
  std::uint32_t local_count = 0;
  std::uint32_t name = 0, file = 0;  // into strings
  std::int32_t parameter_count = 0;  // at most 8; negative: variadic
  // The size of each. More than 3 continue in the next parameter's place (structs).
  std::array<std::uint8_t, 8> parameter_words{};
  bool operator==(const ProgsFunction&) const = default;
};

// A whole program.
struct Progs {
  std::int32_t version = 6;
  ProgsLayout layout = ProgsLayout::kNarrow;
  std::uint32_t crc = 0;  // of the system definitions; kQuakeProgsCrc for Quake
  std::vector<ProgsStatement> statements;
  std::vector<ProgsDefinition> globals, fields;
  std::vector<ProgsFunction> functions;  // [0] is the null function
  std::string strings;                   // zero-terminated, back to back; the first is empty
  std::vector<std::uint32_t> global_words;
  std::uint32_t entity_words = 0;  // size of an entity's fields

  // Returns the string at `offset`, which must be valid.
  std::string_view string_at(std::uint32_t offset) const { return strings.data() + offset; }
  bool operator==(const Progs&) const = default;
};

constexpr std::int32_t kProgsVersion = 6, kExtendedProgsVersion = 7;
constexpr std::uint32_t kReservedGlobalWords = 28;  // null, return value, eight parameters
constexpr std::uint32_t kMaxEntityWords = 1 << 16;  // limit of 16-bit field offsets
constexpr std::int32_t kMaxParameters = 8;
// The checksum of Quake's system globals and fields. Another value means a program for another game.
constexpr std::uint32_t kQuakeProgsCrc = 5927;

// Size of a value in words; 0 if it is not known.
constexpr std::uint32_t value_words(ProgsType type) {
  if (type == ProgsType::kVector) return 3;
  return type == ProgsType::kVoid || type > ProgsType::kPointer ? 0 : 1;
}

// Reads and validates a program. Guarantees: at least one statement, one function, and the 28 reserved global
// words; names and files are valid strings of at most 1024 characters; `strings` begins and ends with a zero;
// definitions and locals are inside of the globals or the entity; functions with statements start inside of
// the statements and have at most 8 parameters, whose places are inside of the globals. Opcodes and operands
// are not checked. Returns kUnsupported for other versions.
//
// Only data that a running program needs can be refused. A name or file that is no such string becomes empty;
// a definition outside of its words becomes one of type kVoid at word 0; missing zeros around the strings and
// missing reserved words are added; parameters above 8 are ignored.
base::Result<Progs> read_progs(base::Bytes bytes);

// Writes a program without validation.
base::ByteVector write_progs(const Progs& progs);

}  // namespace temblor::formats

// Converts values of fields and globals to text and back. Levels set the keys of entities this way, and saved
// games consist of such text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/machine.h"

namespace temblor::server {

// Parses a value of the definition's type. Numbers are read as far as possible, as in stock Quake: "12abc"
// is 12, and "abc" is 0; infinities and NaN count as 0. In a string, "\n" becomes a newline, and any other
// backslash stays. kUsage for functions and fields that the program does not have, for entities past the last
// one, and for types that have no text.
base::Status set_value(vm::Machine& io_machine, const formats::ProgsDefinition& definition,
                       std::string_view text, std::span<std::uint32_t> out_words);

// The text from which set_value() reads the same value. A newline becomes "\n"; characters that would end a
// quoted string are left out. Empty for types that have no text.
std::string value_text(const vm::Machine& machine, const formats::ProgsDefinition& definition,
                       std::span<const std::uint32_t> words);

}  // namespace temblor::server

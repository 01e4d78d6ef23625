// Values of fields and globals as text and back: how levels give keys to entities, and how saved games hold
// everything.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "formats/game/progs.h"
#include "vm/machine.h"

namespace temblor::server {

// The words of a value of the definition's type: kUsage for text that is none (numbers are read as far as
// they go, as the original does, so "12abc" is 12 and "abc" is 0; what is not finite counts as 0), for
// functions and fields that the program has not, and for entities past the last one.
// A string's "\n" becomes a newline, and "\" before anything else stays a backslash.
base::Status set_value(vm::Machine& io_machine, const formats::ProgsDefinition& definition,
                       std::string_view text, std::span<std::uint32_t> out_words);

// What set_value reads back as the same; a newline as "\n", and characters that would end the quoted text
// left out. Empty for types that no text can say.
std::string value_text(const vm::Machine& machine, const formats::ProgsDefinition& definition,
                       std::span<const std::uint32_t> words);

// 3 for vectors, 1 for everything else.
std::size_t word_count(formats::ProgsType type);

}  // namespace temblor::server

// The places to which pointers and array indices lead. All of them are checked at every access.
#include <cstdint>
#include <span>

#include "vm/code/words.h"
#include "vm/machine.h"

namespace temblor::vm {

// Word 0 is the zero that compilers use as an operand, so programs must not change it.
std::uint32_t* Machine::find_writable(std::uint32_t pointer, std::uint32_t words) {
  const std::span<std::uint32_t> globals = global_words();
  if (pointer > kFirstGlobalPointer) {
    const std::uint32_t word = pointer - kFirstGlobalPointer;
    return std::size_t{word} + words <= globals.size() ? &globals[word] : nullptr;
  }
  const std::uint32_t entity_words = program_->progs().entity_words;
  if (pointer >= entity_words_.size() || pointer % entity_words + words > entity_words) return nullptr;
  return world_is_protected_ && pointer < entity_words ? nullptr : &entity_words_[pointer];
}

const std::uint32_t* Machine::find_readable(std::uint32_t pointer, std::uint32_t words) const {
  const std::span<const std::uint32_t> globals = global_words();
  if (pointer >= kFirstGlobalPointer) {
    const std::uint32_t word = pointer - kFirstGlobalPointer;
    return std::size_t{word} + words <= globals.size() ? &globals[word] : nullptr;
  }
  const std::uint32_t entity_words = program_->progs().entity_words;
  if (pointer >= entity_words_.size() || pointer % entity_words + words > entity_words) return nullptr;
  return &entity_words_[pointer];
}

// The statement does not say where the array ends, so only the end of the globals is a limit. The sum wraps
// around for negative indices.
const std::uint32_t* Machine::find_element(const Instruction* at, std::uint32_t words) const {
  const std::span<const std::uint32_t> globals = global_words();
  const std::uint32_t word = static_cast<std::uint32_t>(at->a) + globals[static_cast<std::size_t>(at->b)];
  return std::size_t{word} + words <= globals.size() ? &globals[word] : nullptr;
}

const std::uint32_t* Machine::find_counted_element(const Instruction* at, std::uint32_t words) const {
  const std::span<const std::uint32_t> globals = global_words();
  const auto array = static_cast<std::size_t>(at->a);
  const auto index = static_cast<std::uint32_t>(as_int(globals[static_cast<std::size_t>(at->b)]));
  if (array == 0 || index > globals[array - 1]) return nullptr;
  const std::size_t word = array + std::size_t{index} * words;
  return word + words <= globals.size() ? &globals[word] : nullptr;
}

bool Machine::is_switch_value(const std::uint32_t* value) const {
  switch (switch_kind_) {
    case Operation::kSwitchF:
      return as_float(*value) == as_float(switch_value_[0]);
    case Operation::kSwitchV:
      return same_vector(value, switch_value_.data());
    case Operation::kSwitchString:
      return strings_.text(StringIndex{*value}) == strings_.text(StringIndex{switch_value_[0]});
    default:
      return *value == switch_value_[0];
  }
}

}  // namespace temblor::vm

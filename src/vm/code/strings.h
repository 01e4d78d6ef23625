// The strings that a machine knows: those of its program, and those made while it runs, which have numbers
// from 2^31 + 1 on. (2^31 itself is never one: it is the number -0.0.) A made string does not change; it goes
// when nobody holds its number any more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "vm/program.h"

namespace temblor::vm {

class Strings {
 public:
  // `program_strings` begins and ends with a zero, and must outlive this. Made strings take at most
  // `limit_bytes`, with what it costs to keep them.
  Strings(std::string_view program_strings, std::size_t limit_bytes);

  bool contains(StringIndex index) const;
  // Nothing for what is no string. Valid until the string goes.
  std::string_view text(StringIndex index) const;
  // Also for what is no string.
  bool is_empty(StringIndex index) const;

  // Up to the first zero; the empty string is always kEmptyString. kTooLarge over the limit.
  base::Result<StringIndex> make(std::string_view text);
  // The same, but it lives until it is unzoned, whoever holds it.
  base::Result<StringIndex> zone(std::string_view text);
  // From now on it lives as long as somebody holds its number. False: it was not zoned.
  bool unzone(StringIndex index);

  // Whether enough was made since the last collection to be worth one.
  bool is_worth_collecting() const;
  // Forgets made strings whose number is in none of `holders` (any word may be a number).
  void collect(std::initializer_list<std::span<const std::uint32_t>> holders);

  std::size_t made_count() const { return slots_.size() - free_.size(); }
  std::size_t made_bytes() const { return bytes_; }

 private:
  struct Slot {
    std::unique_ptr<const std::string> text;  // null: free
    bool is_zoned = false;
    bool is_held = false;  // while collecting
  };

  const Slot* slot_of(StringIndex index) const;

  std::string_view program_;
  std::size_t limit_bytes_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t bytes_ = 0;
  std::size_t bytes_since_collection_ = 0;
};

}  // namespace temblor::vm

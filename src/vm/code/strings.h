// The strings of a machine: those of its program, and those made while it runs.
//
// QuakeC stores a string as a number:
//
//   0 ... program text size - 1    offset into the text of the program; 0 is the empty string
//   2^31 + 1 + slot                a made string (2^31 itself is never one, because it is the float -0.0)
//
// Made strings do not change. QuakeC never frees them, so collect() works like a conservative garbage
// collector: it frees those whose number appears in no word of any global or entity, whatever the type of the
// word. In the original, ftos and vtos return one shared buffer instead, which the next call overwrites.
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
  // `program_strings` begins and ends with a zero byte and must outlive this object. Made strings use at most
  // `limit_bytes`, including bookkeeping.
  Strings(std::string_view program_strings, std::size_t limit_bytes);

  bool contains(StringIndex index) const;
  // Returns an empty text if `index` is not a string. Valid as long as the string exists.
  std::string_view text(StringIndex index) const;
  // Also true if `index` is not a string.
  bool is_empty(StringIndex index) const;

  // Makes a string from the text up to its first zero byte. The empty string is always kEmptyString. Fails
  // with kTooLarge above the limit.
  base::Result<StringIndex> make(std::string_view text);
  // Makes a string that lives until unzone(), even if nothing holds it (strzone in QuakeC).
  base::Result<StringIndex> zone(std::string_view text);
  // Ends the effect of zone(): the string lives only as long as something holds it. False if it was not
  // zoned.
  bool unzone(StringIndex index);

  // Returns whether enough bytes were made since the last collection to make another one worthwhile.
  bool needs_collection() const;
  // Frees made strings whose number is in none of `holders` (any word may be a number).
  void collect(std::initializer_list<std::span<const std::uint32_t>> holders);

  std::size_t made_count() const { return slots_.size() - free_.size(); }
  std::size_t made_bytes() const { return bytes_; }

 private:
  struct Slot {
    std::unique_ptr<const std::string> text;  // null: free
    bool is_zoned = false;
    bool is_held = false;  // mark bit of collect()
  };

  const Slot* find_slot(StringIndex index) const;

  std::string_view program_;
  std::size_t limit_bytes_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t bytes_ = 0;
  std::size_t bytes_since_collection_ = 0;
};

}  // namespace temblor::vm

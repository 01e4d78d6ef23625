// A compact record of the shadows that lights cast on one face, for the light cache. Half of all shadows are
// all light or none, and take one byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "compiler/light/shadows/shadow_filter.h"

namespace temblor::compiler {

// A question about one light: at least one luxel, in ascending order, and whether one sample for each was
// enough.
struct ShadowQuestion {
  std::uint32_t light = 0;
  std::span<const std::uint32_t> luxels;
  bool rough = false;
};

// Writes a record.
class ShadowWriter {
 public:
  explicit ShadowWriter(std::size_t luxels_of_face) : luxels_of_face_(luxels_of_face) {}

  // Adds an answer. `shares`: one for each luxel of the question. Lights come in ascending order, each once.
  void add(const ShadowQuestion& question, std::span<const Share> shares);
  base::ByteVector take() && { return std::move(writer_).take(); }

 private:
  void add_bits(std::span<const std::uint32_t> ones, std::size_t count);

  std::size_t luxels_of_face_;
  std::uint32_t next_light_ = 0;
  base::ByteWriter writer_;
};

// Reads a record.
class ShadowReader {
 public:
  // `record`: from a ShadowWriter for a face with as many luxels; outlives the reader. From damaged bytes,
  // everything before the damage is read.
  ShadowReader(base::Bytes record, std::size_t luxels_of_face);

  // Returns the answer to exactly the same question, or nothing. Valid until the next call.
  std::optional<std::span<const Share>> find(const ShadowQuestion& question);

 private:
  struct Entry {
    std::uint32_t light = 0;
    std::uint8_t tag = 0;
    std::uint32_t luxels = 0;  // of the question
    base::Bytes mask, answer;  // mask: which luxels; empty: all
  };
  bool asks_the_same(const Entry& entry, const ShadowQuestion& question) const;

  std::size_t luxels_of_face_;
  std::vector<Entry> entries_;  // by light
  std::vector<Share> shares_;
};

}  // namespace temblor::compiler

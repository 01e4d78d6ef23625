// The shadows that lights cast on one face, packed to be kept: half of them are all light or none, and cost a
// byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "compiler/light/shadows/shadow_filter.h"

namespace temblor::compiler {

// What was asked about one light: which luxels, in rising order and at least one, and whether roughly.
struct ShadowQuestion {
  std::uint32_t light = 0;
  std::span<const std::uint32_t> luxels;
  bool rough = false;
};

class ShadowWriter {
 public:
  explicit ShadowWriter(std::size_t luxels_of_face) : luxels_of_face_(luxels_of_face) {}

  // `shares`: one for each luxel asked about. Lights come in rising order, each once.
  void add(const ShadowQuestion& question, std::span<const Share> shares);
  base::ByteVector take() && { return std::move(writer_).take(); }

 private:
  void add_bits(std::span<const std::uint32_t> ones, std::size_t count);

  std::size_t luxels_of_face_;
  std::uint32_t next_light_ = 0;
  base::ByteWriter writer_;
};

class ShadowReader {
 public:
  // `record`: a ShadowWriter's for a face of as many luxels; outlives the reader. Of damaged bytes what comes
  // before the damage is read.
  ShadowReader(base::Bytes record, std::size_t luxels_of_face);

  // The answer to the same question; nothing when it was never asked. Valid until the next call.
  std::optional<std::span<const Share>> find(const ShadowQuestion& question);

 private:
  struct Entry {
    std::uint32_t light = 0;
    std::uint8_t tag = 0;
    std::uint32_t luxels = 0;  // asked about
    base::Bytes mask, answer;  // mask: empty when all luxels were asked about
  };
  bool asks_the_same(const Entry& entry, const ShadowQuestion& question) const;

  std::size_t luxels_of_face_;
  std::vector<Entry> entries_;  // by light
  std::vector<Share> shares_;
};

}  // namespace temblor::compiler

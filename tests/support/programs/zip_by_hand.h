// Zip archives written from the description of the format (PKWARE's APPNOTE) without a library, so that a
// test can write wrong fields.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/bytes.h"

namespace temblor::test {

// One stored entry. It is valid unless a field is changed.
struct ZipByHand {
  std::string name;
  std::string data;
  std::uint16_t flags = 0;                             // bit 0: encrypted
  std::uint16_t method = 0;                            // 0 stored, 8 deflated; `data` is already packed
  std::optional<std::uint32_t> claimed_size{};         // bytes unpacked
  std::optional<std::uint32_t> claimed_packed_size{};  // bytes in the archive
  std::optional<std::uint32_t> claimed_crc{};
};

base::ByteVector make_zip(std::span<const ZipByHand> entries);

// Size of the end record, which is at the end of the result of make_zip().
constexpr std::size_t kZipEndRecordBytes = 22;
constexpr std::size_t kZipEndDirectorySizeField = 12;

}  // namespace temblor::test

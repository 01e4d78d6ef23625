// Zip archives written out from the format's description (PKWARE's APPNOTE), not by a library: so that a test
// can also say what is not so.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/bytes.h"

namespace temblor::test {

// One entry, stored. Without lies it is a valid one.
struct ZipByHand {
  std::string name;
  std::string data;
  std::uint16_t flags = 0;                      // bit 0: encrypted
  std::uint16_t method = 0;                     // 0 stored, 8 deflated; `data` is taken as already packed
  std::optional<std::uint32_t> claimed_size{};  // bytes unpacked
  std::optional<std::uint32_t> claimed_packed_size{};  // bytes in the archive
  std::optional<std::uint32_t> claimed_crc{};
};

base::ByteVector make_zip(std::span<const ZipByHand> entries);

// Of the last record, 22 bytes before the end of what make_zip() gives.
constexpr std::size_t kZipEndRecordBytes = 22;
constexpr std::size_t kZipEndDirectorySizeField = 12;

}  // namespace temblor::test

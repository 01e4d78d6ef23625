// Text in packets and replays: u16 size, then the bytes.
#pragma once

#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::lockstep {

constexpr std::size_t kMaxTextBytes = 1024;

// Cuts longer text.
inline void write_text(std::string_view text, base::ByteWriter& io_writer) {
  text = text.substr(0, kMaxTextBytes);
  io_writer.u16(static_cast<std::uint16_t>(text.size()));
  io_writer.bytes(base::as_bytes(text));
}

// At the end of the bytes, the reader is not ok().
inline std::string read_text(base::ByteReader& io_reader) {
  return std::string(base::as_text(io_reader.take(io_reader.u16())));
}

}  // namespace temblor::lockstep

// Bytes -> server messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/server_message.h"

namespace temblor::net {

// Reads the messages of one connection or recording. Keeps the dialect that the last ServerInfo named.
//
// Of a message that was read, all numbers are finite, coordinates are at most 2^27, entity numbers below
// kMaxEntities, and precache lists no longer than kMaxModels and kMaxSounds. Models, sounds, frames, clients,
// stats and styles are whatever their bytes say.
//
// FitzQuake's messages of their own (fog, skybox, bonus flash, wide baselines) are read in protocol 15 too,
// where game code may send them by hand. Once warm, reading asks the heap for nothing.
class MessageReader {
 public:
  // Starts on the next packet or recorded message; its bytes must live until all of it is read.
  // `offset_in_file` is only for error messages.
  void begin(base::Bytes bytes, std::size_t offset_in_file = 0);

  // The next message, or nothing at the end. Errors say the offset of the message's first byte, the message
  // that was being read, and what was expected; the rest of these bytes cannot be read then, and is taken for
  // read. kUnsupported for protocols and messages that are not known.
  base::Result<std::optional<ServerMessage>> next();

  const Dialect& dialect() const { return dialect_; }
  // Of the next message's first byte, or of the end.
  std::size_t offset_in_file() const { return offset_in_file_ + reader_.offset(); }

 private:
  base::ByteReader reader_{base::Bytes{}};
  std::size_t offset_in_file_ = 0;
  Dialect dialect_;
  std::vector<std::string_view> models_, sounds_;  // of the last ServerInfo
};

}  // namespace temblor::net

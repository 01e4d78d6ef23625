// Bytes -> server messages.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/server_message.h"

namespace temblor::net {

// Reads the messages of one connection or recording. Keeps the dialect that the last ServerInfo named.
class MessageReader {
 public:
  // Starts on the next packet or recorded message; its bytes must live until all of it is read.
  // `offset_in_file` is only for error messages.
  void begin(base::Bytes bytes, std::size_t offset_in_file = 0);

  // The next message, or nothing at the end. Errors say the offset, the message that was being read, and what
  // was expected; the rest of these bytes cannot be read then.
  base::Result<std::optional<ServerMessage>> next();

  const Dialect& dialect() const { return dialect_; }

 private:
  base::ByteReader reader_{base::Bytes{}};
  std::size_t offset_in_file_ = 0;
  Dialect dialect_;
  std::vector<std::string_view> models_, sounds_;
};

}  // namespace temblor::net

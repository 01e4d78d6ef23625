// Reads server messages (server_message.h) from packets and demos of protocols 15, 666, and 999.
//
//   packet:  | u8 number | fields | u8 number | fields | ...
//
// Messages have no length field: a reader must know all of them, and cannot continue after an error. The
// field readers of net/wire parse the fields with bounds checks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/server_message.h"

namespace temblor::net {

// Reads the messages of one connection or demo, and keeps the dialect that the last ServerInfo announced.
//
// Guarantees for each message: all numbers are finite, coordinates are within +-2^27, entity numbers are
// below kMaxEntities, and precache lists have at most kMaxModels and kMaxSounds names. The numbers of models,
// sounds, frames, clients, stats, and light styles are unchecked.
//
// Accepts FitzQuake's messages (fog, skybox, bonus flash, wide baselines) in protocol 15 too, because mods
// may write them byte by byte. Allocates no memory once warm.
class MessageReader {
 public:
  MessageReader() = default;
  // Starts in the middle of a connection that speaks this dialect.
  explicit MessageReader(const Dialect& dialect) : dialect_(dialect) {}

  // Starts reading a packet or demo record. `bytes` must outlive the messages read from it. `offset_in_file`
  // is added to the offsets in error messages.
  void begin(base::Bytes bytes, std::size_t offset_in_file = 0);

  // Returns the next message, or nullopt at the end. Errors name the offset, the message, and the problem;
  // kUnsupported stands for unknown protocols and messages. After an error the reader is at its end.
  base::Result<std::optional<ServerMessage>> next();
  // Whether the last error was a message, or a part of one, that the reader does not know. The rest of this
  // packet is lost, but the messages before it are whole, and so are later packets.
  bool is_at_unknown() const { return is_at_unknown_; }

  const Dialect& dialect() const { return dialect_; }
  // Offset of the next message, or of the end.
  std::size_t offset_in_file() const { return offset_in_file_ + reader_.offset(); }

 private:
  base::Error add_last_messages(base::Error error) const;

  base::ByteReader reader_{base::Bytes{}};
  std::size_t offset_in_file_ = 0;
  Dialect dialect_;
  std::array<std::uint8_t, 3> last_ids_{};  // of this packet's last messages, the latest last; 0: none
  bool is_at_unknown_ = false;
  std::vector<std::string_view> models_, sounds_;  // of the last ServerInfo
  std::vector<std::string_view> chat_texts_;       // of the last BotChat
};

}  // namespace temblor::net

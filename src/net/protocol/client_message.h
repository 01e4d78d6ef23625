// Messages from client to server, reader and writer. There are four, each a byte with its number and its
// fields (little endian), in any order and number in one packet:
//
//   1 clc_nop         -
//   2 clc_disconnect  -
//   3 clc_move        f32 time, 3 angles, i16 forward, i16 side, i16 up, u8 buttons, u8 impulse
//   4 clc_stringcmd   text + '\0'
//
// Protocols 15, 666, and 999 differ only in the angles of a move: bytes in 15, 16 bits in the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"
#include "net/protocol/protocol.h"
#include "net/protocol/server_message.h"

namespace temblor::net {

// Limit for a console line, with its zero byte, as in stock clients; longer ones are errors.
constexpr std::size_t kMaxCommandBytes = 1024;

// The player's input of one client frame; unreliable, not repeated.
struct Move {
  float time_s = 0;             // latest server time that the client received; the server derives the ping
  math::Vec3 angles_deg{0.0f};  // pitch, yaw, roll; a reader returns them in [-180, 180)
  std::int16_t forward = 0, side = 0, up = 0;  // wanted speed, units per second
  std::uint8_t buttons = 0;                    // 1 attack, 2 jump
  std::uint8_t impulse = 0;
};
// A console line for the server: "prespawn", "say hello".
struct StringCommand {
  std::string_view text;
};

using ClientMessage = std::variant<Nop, Disconnect, Move, StringCommand>;

// Name for messages to people, such as "clc_move".
const char* message_name(const ClientMessage& message);

// Reads the messages of one client packet.
class ClientMessageReader {
 public:
  // `bytes` must outlive the reader and the texts of its messages.
  ClientMessageReader(base::Bytes bytes, Protocol protocol) : reader_(bytes), protocol_(protocol) {}

  // Returns the next message, or nullopt at the end. All numbers of a message are finite, and its text is
  // shorter than kMaxCommandBytes. Errors name the offset, the message, and the problem: kUnsupported for an
  // unknown message number, kTooLarge for a long text, otherwise kMalformed. After an error the reader is at
  // its end, because the length of the bad message is unknown.
  base::Result<std::optional<ClientMessage>> next();

 private:
  base::ByteReader reader_;
  Protocol protocol_;
};

// Appends one message. Rounds angles to the nearest representable value. Returns kTooLarge and appends
// nothing if the text is too long or contains a zero byte, or a number is not finite.
base::Status write_client_message(const ClientMessage& message, Protocol protocol,
                                  base::ByteWriter& io_writer);

}  // namespace temblor::net

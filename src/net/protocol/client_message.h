// What a client tells a server: four messages, alike in protocols 15, 666 and 999 but for the angles of a
// move, which are bytes in 15 and 16-bit in the others. Both directions.
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

// A line of console text of a stock client is shorter than this; a longer one is refused.
constexpr std::size_t kMaxCommandBytes = 1024;

// One a client frame, unreliable and not repeated.
struct Move {
  float time_s = 0;             // the server's time that the client last heard of, for the ping
  math::Vec3 angles_deg{0.0f};  // pitch, yaw, roll; read back in [-180, 180)
  std::int16_t forward = 0, side = 0, up = 0;
  std::uint8_t buttons = 0;  // 1 attack, 2 jump
  std::uint8_t impulse = 0;
};
// A line for the server's console: "prespawn", "say hello".
struct StringCommand {
  std::string_view text;
};

using ClientMessage = std::variant<Nop, Disconnect, Move, StringCommand>;

// "clc_move".
const char* name_of(const ClientMessage& message);

// Reads what one packet of a client holds.
class ClientMessageReader {
 public:
  // `bytes` must live until all of it is read; so must what is done with a StringCommand's text.
  ClientMessageReader(base::Bytes bytes, Protocol protocol) : reader_(bytes), protocol_(protocol) {}

  // The next message, or nothing at the end. Of a message that was read all numbers are finite and the text
  // is shorter than kMaxCommandBytes. Errors say the offset of the message's first byte, its name and what
  // was expected: kUnsupported for a number that is no message, kTooLarge for a text too long, else
  // kMalformed. The rest of these bytes is taken for read then.
  base::Result<std::optional<ClientMessage>> next();

 private:
  base::ByteReader reader_;
  Protocol protocol_;
};

// Appends one message. kTooLarge for a text too long or with a zero in it, and for numbers that are not
// finite; nothing is appended then. Angles are rounded to the nearest that can be said.
base::Status write_client_message(const ClientMessage& message, Protocol protocol,
                                  base::ByteWriter& io_writer);

}  // namespace temblor::net

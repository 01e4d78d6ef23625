#include "net/transport/admission/challenge.h"

#include <fmt/format.h>

#include <bit>

#include "base/check.h"
#include "net/protocol/client_message.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {
namespace {

struct SipState {
  std::uint64_t a, b, c, d;

  void rounds(int count) {
    for (; count > 0; --count) {
      a += b;
      c += d;
      b = std::rotl(b, 13) ^ a;
      d = std::rotl(d, 16) ^ c;
      a = std::rotl(a, 32);
      c += b;
      a += d;
      b = std::rotl(b, 17) ^ c;
      d = std::rotl(d, 21) ^ a;
      c = std::rotl(c, 32);
    }
  }
  void take(std::uint64_t word) {
    d ^= word;
    rounds(2);
    a ^= word;
  }
};

}  // namespace

std::uint64_t sip_hash(const Secret& secret, base::Bytes bytes) {
  // "somepseudorandomlygeneratedbytes"
  SipState state{secret[0] ^ 0x736f6d6570736575u, secret[1] ^ 0x646f72616e646f6du,
                 secret[0] ^ 0x6c7967656e657261u, secret[1] ^ 0x7465646279746573u};
  base::ByteReader reader(bytes);
  while (reader.remaining() >= sizeof(std::uint64_t)) state.take(reader.read<std::uint64_t>());
  std::uint64_t last = static_cast<std::uint64_t>(bytes.size()) << 56;
  for (int shift = 0; reader.remaining() > 0; shift += 8) last |= std::uint64_t{reader.u8()} << shift;
  state.take(last);
  state.c ^= 0xff;
  state.rounds(4);
  return state.a ^ state.b ^ state.c ^ state.d;
}

std::string challenge_word(const Secret& secret, const platform::Address& address, std::uint64_t serial) {
  base::ByteWriter what;
  for (const std::uint8_t byte : address.host) what.u8(byte);
  what.u16(address.port);
  what.u32(address.scope);
  what.write(serial);
  constexpr std::uint64_t kFortyBits = (std::uint64_t{1} << 40) - 1;
  return fmt::format("{:010x}", sip_hash(secret, what.view()) & kFortyBits);
}

base::ByteVector challenge_message(std::string_view word) {
  const std::string text = fmt::format("cmd {}\n", word);
  base::ByteWriter writer;
  const base::Status status = write_message(StuffText{text}, Dialect{}, writer);
  CHECK(status.ok(), "{}", status.error().message());
  return std::move(writer).take();
}

std::optional<base::ByteVector> without_word(base::Bytes message, std::string_view word) {
  ClientMessageReader reader(message, Protocol::kNetQuake);
  base::ByteWriter rest;
  bool is_said = false;
  while (true) {
    const auto next = reader.next();
    if (!next.ok()) return std::nullopt;
    if (!next->has_value()) break;
    const auto* command = std::get_if<StringCommand>(&**next);
    // Some clients leave the line's end on it.
    if (command != nullptr && command->text.substr(0, command->text.find_last_not_of(" \n") + 1) == word)
      is_said = true;
    else if (const base::Status status = write_client_message(**next, Protocol::kNetQuake, rest);
             !status.ok())
      return std::nullopt;
  }
  if (!is_said) return std::nullopt;
  return std::move(rest).take();
}

}  // namespace temblor::net

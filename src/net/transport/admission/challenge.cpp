#include "net/transport/admission/challenge.h"

#include <fmt/format.h>

#include <bit>

#include "base/check.h"
#include "net/protocol/client_message.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {
namespace {

// The four state words of SipHash, with its round function and message step.
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
  void absorb(std::uint64_t word) {
    d ^= word;
    rounds(2);
    a ^= word;
  }
};

}  // namespace

std::uint64_t sip_hash(const Secret& secret, base::Bytes bytes) {
  // The initial state spells "somepseudorandomlygeneratedbytes".
  SipState state{secret[0] ^ 0x736f6d6570736575u, secret[1] ^ 0x646f72616e646f6du,
                 secret[0] ^ 0x6c7967656e657261u, secret[1] ^ 0x7465646279746573u};
  base::ByteReader reader(bytes);
  while (reader.remaining() >= sizeof(std::uint64_t)) state.absorb(reader.read<std::uint64_t>());
  // The last block holds the remaining bytes and the size.
  std::uint64_t last = static_cast<std::uint64_t>(bytes.size()) << 56;
  for (int shift = 0; reader.remaining() > 0; shift += 8) last |= std::uint64_t{reader.u8()} << shift;
  state.absorb(last);
  state.c ^= 0xff;
  state.rounds(4);
  return state.a ^ state.b ^ state.c ^ state.d;
}

std::string make_challenge_cookie(const Secret& secret, const platform::Address& address,
                                  std::uint64_t serial) {
  base::ByteWriter input;
  for (const std::uint8_t byte : address.host) input.u8(byte);
  input.u16(address.port);
  input.u32(address.scope);
  input.write(serial);
  constexpr std::uint64_t kFortyBits = (std::uint64_t{1} << 40) - 1;
  return fmt::format("{:010x}", sip_hash(secret, input.view()) & kFortyBits);
}

base::ByteVector make_challenge_message(std::string_view cookie) {
  const std::string text = fmt::format("cmd {}\n", cookie);
  base::ByteWriter writer;
  const base::Status status = write_message(StuffText{text}, Dialect{}, writer);
  CHECK(status.ok(), "{}", status.error().message());
  return std::move(writer).take();
}

std::optional<base::ByteVector> remove_challenge_reply(base::Bytes message, std::string_view cookie) {
  ClientMessageReader reader(message, Protocol::kNetQuake);
  base::ByteWriter rest;
  bool has_cookie = false;
  while (true) {
    const auto next = reader.next();
    if (!next.ok()) return std::nullopt;
    if (!next->has_value()) break;
    const auto* command = std::get_if<StringCommand>(&**next);
    // Some clients keep the line end.
    if (command != nullptr && command->text.substr(0, command->text.find_last_not_of(" \n") + 1) == cookie)
      has_cookie = true;
    else if (const base::Status status = write_client_message(**next, Protocol::kNetQuake, rest);
             !status.ok())
      return std::nullopt;
  }
  if (!has_cookie) return std::nullopt;
  return std::move(rest).take();
}

}  // namespace temblor::net

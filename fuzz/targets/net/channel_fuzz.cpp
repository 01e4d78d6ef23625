// Runs a channel against a hostile peer: it receives arbitrary packets, sends messages of its own, and lets
// time pass. In the input, each packet is a byte with its length divided by 8, followed by its bytes. No
// buffer may grow beyond its limit.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "net/transport/channel.h"

using namespace temblor;

int temblor::fuzz::fuzz_channel(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMost = 4000, kQueue = 10000;
  net::Channel channel({.max_received_bytes = kMost, .queue_bytes = kQueue});
  const auto sink = [](base::Bytes packet) { CHECK(packet.size() >= 8 && packet.size() <= 8 + 1024); };
  base::ByteReader reader(std::as_bytes(std::span(data, size)));
  for (double now_s = 0; reader.remaining() > 0; now_s += 0.1) {
    const std::size_t wanted = std::size_t{reader.u8()} * 8;
    const base::Bytes packet = reader.take(wanted < reader.remaining() ? wanted : reader.remaining());
    const auto message = channel.receive(packet, now_s, sink);
    if (message.ok() && message->has_value() && (*message)->reliable)
      CHECK((*message)->bytes.size() <= kMost);
    if (packet.size() % 16 == 8) {
      const base::ByteVector own(packet.size() * 3);
      const base::Status status = channel.send_reliable(own, now_s, sink);
      CHECK(status.ok() || channel.queued_bytes() + own.size() > kQueue);
    }
    channel.update(now_s, sink);
    CHECK(channel.queued_bytes() <= kQueue);
  }
  return 0;
}

// Updates told as differences, by anybody: packets of any bytes, each a byte of length (times 4) and then its
// bytes; the first byte of all chooses the dialect. Every other packet is given the head of an update that
// follows the last one, so that what is told against what is known is reached too.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "net/delta/sent_snapshots.h"
#include "net/protocol/message_reader.h"

using namespace temblor;

namespace {

constexpr net::Dialect kDialects[] = {{net::Protocol::kNetQuake, 0},
                                      {net::Protocol::kFitzQuake, 0},
                                      {net::Protocol::kRmq, net::k24BitCoord | net::kShortAngle},
                                      {net::Protocol::kRmq, net::kFloatCoord | net::kFloatAngle}};

// More than any state has: all entities with all of their fields, and text.
constexpr std::size_t kMaxBytes = 1024 * 64 + 2 * 2047 + 1024;

base::ByteVector following(std::uint16_t number, std::uint8_t back, base::Bytes content) {
  base::ByteWriter writer;
  writer.u8(net::kDeltaPacket);
  writer.u16(number);
  writer.u8(back);
  writer.bytes(content);
  return std::move(writer).take();
}

}  // namespace

int temblor::fuzz::fuzz_difference(const std::uint8_t* data, std::size_t size) {
  base::ByteReader reader(std::as_bytes(std::span(data, size)));
  const net::Dialect dialect = kDialects[reader.u8() % std::size(kDialects)];
  net::ReceivedSnapshots known;
  for (int i = 0; reader.remaining() > 0 && i < 30; ++i) {
    const std::size_t wanted = std::size_t{reader.u8()} * 4;
    base::Bytes bytes = reader.take(wanted < reader.remaining() ? wanted : reader.remaining());
    base::ByteVector headed;
    if (i % 2 == 0) {
      const int next = known.latest() ? *known.latest() + 1 : 0;
      headed = following(static_cast<std::uint16_t>(next), known.latest() ? std::uint8_t{1} : std::uint8_t{0},
                         bytes);
      bytes = headed;
    }
    const auto stock = known.read(bytes, dialect);
    if (!stock.ok() || !*stock) continue;
    CHECK((*stock)->size() <= kMaxBytes);
    // Whatever they are: read until they end or make no sense.
    net::MessageReader messages;
    messages.begin(**stock);
    while (true) {
      const auto message = messages.next();
      if (!message.ok() || !message->has_value()) break;
    }
  }
  return 0;
}

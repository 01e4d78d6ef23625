// Feeds arbitrary packets to the receiver of delta-compressed snapshots. In the input, the first byte
// chooses the dialect, and each packet is a byte with its length divided by 4, followed by its bytes. Every
// other packet gets a valid header that continues the last snapshot, so that the fuzzer also reaches the
// decoding of deltas.
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

// More than any snapshot has: all entities with all fields, and text.
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

int temblor::fuzz::fuzz_delta(const std::uint8_t* data, std::size_t size) {
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
    // The messages may be anything. Read them up to the end or an error.
    net::MessageReader messages;
    messages.begin(**stock);
    while (true) {
      const auto message = messages.next();
      if (!message.ok() || !message->has_value()) break;
    }
  }
  return 0;
}

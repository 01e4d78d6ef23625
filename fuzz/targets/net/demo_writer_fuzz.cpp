// Feeds arbitrary bytes to the demo reader, packet by packet and message by message, up to an error or the
// end. All messages are then written as a demo in the widest protocol, which must read back from the first
// message to the last.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "formats/game/dem.h"
#include "fuzz/targets.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

using namespace temblor;

namespace {

constexpr net::Dialect kWidest{net::Protocol::kRmq, net::kFloatCoord | net::kFloatAngle};

// The packet's messages up to the first that cannot be read, and their number.
std::size_t rewrite(const formats::DemMessage& packet, net::MessageReader& io_reader,
                    base::ByteWriter& io_writer) {
  io_reader.begin(packet.message, packet.offset);
  std::size_t messages = 0;
  while (true) {
    auto message = io_reader.next();
    if (!message.ok() || !message->has_value()) return messages;
    if (auto* info = std::get_if<net::ServerInfo>(&**message)) info->dialect = kWidest;
    const std::size_t before = io_writer.size();
    const base::Status status = net::write_message(**message, kWidest, io_writer);
    CHECK(status.ok(), "{}", status.error().message());
    if (io_writer.size() > before) ++messages;  // otherwise the reader skips this kind of message
  }
}

std::size_t count_messages(base::Bytes dem) {
  auto recording = formats::DemReader::open(dem);
  CHECK(recording.ok(), "{}", recording.error().message());
  net::MessageReader reader;
  std::size_t messages = 0;
  while (true) {
    const auto packet = recording->next();
    CHECK(packet.ok(), "{}", packet.error().message());
    if (!packet->has_value()) break;
    reader.begin((*packet)->message, (*packet)->offset);
    while (true) {
      const auto message = reader.next();
      CHECK(message.ok(), "{}", message.error().message());
      if (!message->has_value()) break;
      ++messages;
    }
  }
  CHECK(!recording->is_truncated());
  return messages;
}

}  // namespace

int temblor::fuzz::fuzz_demo_writer(const std::uint8_t* data, std::size_t size) {
  auto recording = formats::DemReader::open(std::as_bytes(std::span(data, size)));
  if (!recording.ok()) return 0;
  net::MessageReader reader;
  // Messages before the first serverinfo are written in this dialect, too.
  formats::DemWriter written(recording->forced_track());
  base::ByteWriter begin;
  CHECK(net::write_message(net::ServerInfo{.dialect = kWidest}, kWidest, begin).ok());
  written.add({}, begin.view());
  std::size_t messages = 1;
  while (true) {
    const auto packet = recording->next();
    if (!packet.ok() || !packet->has_value()) break;
    base::ByteWriter writer;
    messages += rewrite(**packet, reader, writer);
    if (writer.size() > formats::kMaxStockDemMessage) return 0;  // wider numbers can exceed a packet's size
    written.add((*packet)->view_angles_deg, writer.view());
  }
  const base::ByteVector dem = std::move(written).take();
  CHECK(count_messages(dem) == messages);
  return 0;
}

// Feeds arbitrary bytes to the DEM reader. It must return an error, or messages that lie in the file one
// after another and that are written and read back unchanged.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/check.h"
#include "formats/game/dem.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

// The messages before the end, the truncation, or the error.
std::vector<formats::DemMessage> list_messages(formats::DemReader& io_reader) {
  std::vector<formats::DemMessage> messages;
  while (true) {
    const auto message = io_reader.next();
    if (!message.ok() || !*message) return messages;
    CHECK((*message)->offset + (*message)->message.size() == io_reader.offset());
    messages.push_back(**message);
  }
}

}  // namespace

int temblor::fuzz::fuzz_dem(const std::uint8_t* data, std::size_t size) {
  auto reader = formats::DemReader::open(std::as_bytes(std::span(data, size)));
  if (!reader.ok()) return 0;
  const auto messages = list_messages(*reader);
  formats::DemWriter writer(reader->forced_track());
  for (const formats::DemMessage& message : messages) writer.add(message.view_angles_deg, message.message);
  const base::ByteVector written = std::move(writer).take();
  auto back = formats::DemReader::open(written);
  CHECK(back.ok(), "{}", back.error().message());
  CHECK(back->forced_track() == reader->forced_track());
  const auto same = [](const formats::DemMessage& a, const formats::DemMessage& b) {
    return a.view_angles_deg == b.view_angles_deg && std::ranges::equal(a.message, b.message);
  };
  CHECK(std::ranges::equal(list_messages(*back), messages, same));
  CHECK(!back->is_truncated());
  return 0;
}

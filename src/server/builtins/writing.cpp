// Built-in functions that write messages piece by piece: WriteByte(destination, value) and so on. Whole
// numbers that do not fit lose their upper bits, as in stock Quake. Nothing checks that the pieces form a
// message that clients understand: that is up to game code.
#include "net/protocol/clamped_fields.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// The buffer that parameter 0 selects (Destination), which must have room for `bytes`. Destination kOne means
// the player in the global msg_entity.
base::Result<base::ByteWriter*> destination(Call& io_call, std::size_t bytes) {
  Outbox& outbox = io_call.game.outbox;
  const float number = io_call.number(0);
  base::ByteWriter* writer = nullptr;
  if (number == static_cast<float>(Destination::kBroadcast)) writer = &outbox.broadcast();
  if (number == static_cast<float>(Destination::kAll)) writer = &outbox.reliable();
  if (number == static_cast<float>(Destination::kInit)) writer = &outbox.signon();
  if (number == static_cast<float>(Destination::kOne)) {
    const vm::EntityIndex player = io_call.machine.global_entity(global::kMessageEntity);
    writer = outbox.reliable_to(player);
    if (writer == nullptr)
      return io_call.error("msg_entity is entity {}, which is not a player", base::to_size(player));
  }
  if (writer == nullptr) return io_call.error("destination {} is not between 0 and 3", number);
  if (!Outbox::has_room(*writer, bytes))
    return io_call.error("more than {} bytes in one tick for destination {}", Outbox::kMaxBytes, number);
  return writer;
}

template <typename Number>
base::Status write_whole(Call& io_call) {
  TRY(base::ByteWriter* const writer, destination(io_call, sizeof(Number)));
  writer->write(static_cast<Number>(io_call.whole(1)));
  return base::Ok{};
}

// Coordinates and angles are as long as the protocol's; sizeof(float) is the longest.
base::Status write_coord(Call& io_call) {
  TRY(base::ByteWriter* const writer, destination(io_call, sizeof(float)));
  net::write_coord(io_call.number(1), io_call.game.outbox.dialect(), *writer);
  return base::Ok{};
}

base::Status write_angle(Call& io_call) {
  TRY(base::ByteWriter* const writer, destination(io_call, sizeof(float)));
  net::write_angle_deg(io_call.number(1), io_call.game.outbox.dialect(), *writer);
  return base::Ok{};
}

// Whether the last byte is the number of this message. It may also be the last byte of something else.
bool ends_with(const base::ByteWriter& writer, std::uint8_t message) {
  return writer.size() > 0 && writer.view().back() == std::byte{message};
}

// A localized text that stock clients have room for; other texts are left alone.
std::string localize(const Call& call, std::string_view text) {
  constexpr std::size_t kMaxStockText = 2047;
  const formats::Localization* const known = call.game.localization;
  if (known == nullptr || !known->has_text_for(text)) return std::string(text);
  return known->localize(text).substr(0, kMaxStockText);
}

// The 2021 release's programs also send the names of achievements. Clients of other games would take that
// message for another one, and leave.
base::Status write_string(Call& io_call) {
  constexpr std::uint8_t kFinale = 31, kCutScene = 34, kAchievement = 52;
  const std::string text = localize(io_call, io_call.text(1));
  TRY(base::ByteWriter* const writer, destination(io_call, text.size() + 1));
  if (text.starts_with("ACH_") && ends_with(*writer, kAchievement)) {
    writer->truncate(writer->size() - 1);
    return base::Ok{};
  }
  if (ends_with(*writer, kFinale) || ends_with(*writer, kCutScene))
    io_call.game.closing_text = {.since_s = io_call.world.time_s, .letters = text.size()};
  writer->bytes(base::as_bytes(text));
  writer->u8(0);
  return base::Ok{};
}

base::Status write_entity(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(1));
  TRY(base::ByteWriter* const writer, destination(io_call, sizeof(std::uint16_t)));
  writer->u16(static_cast<std::uint16_t>(entity));
  return base::Ok{};
}

}  // namespace

std::span<const BuiltinEntry> writing_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {52, "WriteByte", write_whole<std::uint8_t>},
      {53, "WriteChar", write_whole<std::int8_t>},
      {54, "WriteShort", write_whole<std::int16_t>},
      {55, "WriteLong", write_whole<std::int32_t>},
      {56, "WriteCoord", write_coord},
      {57, "WriteAngle", write_angle},
      {58, "WriteString", write_string},
      {59, "WriteEntity", write_entity},
  };
  return kEntries;
}

}  // namespace temblor::server

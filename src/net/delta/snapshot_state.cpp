#include "net/delta/snapshot_state.h"

#include <cstring>

#include "net/delta/snapshot_fields.h"
#include "net/wire/entity_update.h"
#include "net/wire/message_id.h"

namespace temblor::net {
namespace {

constexpr std::size_t kTimeBytes = 1 + sizeof(float);

bool begins_with(base::Bytes message, MessageId id) {
  return !message.empty() && std::to_integer<std::uint8_t>(message[0]) == static_cast<std::uint8_t>(id);
}

// Returns the text of a single svc_stufftext message; empty if `message` is anything else.
std::string_view find_stuffed_text(base::Bytes message) {
  if (!begins_with(message, MessageId::kStuffText)) return {};
  const std::string_view text = base::as_text(message.subspan(1));
  const bool is_one = !text.empty() && text.find('\0') == text.size() - 1;
  return is_one ? text.substr(0, text.size() - 1) : std::string_view{};
}

void write_id(MessageId id, base::ByteWriter& io_writer) {
  io_writer.u8(static_cast<std::uint8_t>(id));
}

}  // namespace

void SnapshotState::clear() {
  has_time = has_client_data = false;
  time = 0;
  client_data = {};
  acknowledgment_words = 0;
  acknowledgment = {};
  once.truncate(0);
  events.truncate(0);
  entities.clear();
  client_data_changed = acknowledgment_changed = 0;
  time_rate = 0;
  acknowledgment_rates = {};
}

bool SnapshotState::is_stepping(const Entity& entity) {
  return (entity.words[0] & entity_flag::kStep) != 0;
}

// Any bytes may be in `once` and `events`: they are copied, not parsed.
bool parse_snapshot(const SnapshotParts& parts, const Dialect& dialect, SnapshotState& out_state) {
  out_state.has_time = !parts.time.empty();
  if (out_state.has_time) {
    if (parts.time.size() != kTimeBytes || !begins_with(parts.time, MessageId::kTime)) return false;
    std::memcpy(&out_state.time, parts.time.data() + 1, sizeof(out_state.time));
  }
  out_state.has_client_data = !parts.client_data.empty();
  if (out_state.has_client_data && !read_client_data_words(parts.client_data, dialect, out_state.client_data))
    return false;
  out_state.acknowledgment_words = 0;
  out_state.acknowledgment = {};
  if (!parts.acknowledgment.empty()) {
    out_state.acknowledgment_words =
        read_acknowledgment_words(find_stuffed_text(parts.acknowledgment), out_state.acknowledgment);
    if (out_state.acknowledgment_words == 0) return false;
  }
  if (parts.once.size() > SnapshotState::kMaxPlainBytes ||
      parts.events.size() > SnapshotState::kMaxPlainBytes)
    return false;
  out_state.once.bytes(parts.once);
  out_state.events.bytes(parts.events);
  return true;
}

bool parse_entity_update(base::Bytes entity_update, const Dialect& dialect,
                         SnapshotState::Entity& out_entity) {
  return read_entity_words(entity_update, dialect, out_entity.number, out_entity.words);
}

void SnapshotWriter::write(const SnapshotState& state, const Dialect& dialect, base::ByteWriter& io_writer) {
  if (state.has_time) {
    write_id(MessageId::kTime, io_writer);
    io_writer.u32(state.time);
  }
  io_writer.bytes(state.once.view());
  if (state.has_client_data) write_client_data_words(state.client_data, dialect, io_writer);
  if (state.acknowledgment_words > 0) {
    write_acknowledgment_words(std::span(state.acknowledgment).first(state.acknowledgment_words), line_);
    write_id(MessageId::kStuffText, io_writer);
    io_writer.bytes(base::as_bytes(line_));
    io_writer.u8(0);
  }
  for (const SnapshotState::Entity& entity : state.entities)
    write_entity_words(entity.number, entity.words, dialect, io_writer);
  io_writer.bytes(state.events.view());
}

}  // namespace temblor::net

#include "server/game/outbox.h"

#include "net/protocol/message_writer.h"

namespace temblor::server {
namespace {

// The number of the entity that the message is about; 0 for other messages.
std::uint32_t message_entity(const net::ServerMessage& message) {
  if (const auto* sound = std::get_if<net::Sound>(&message)) return sound->entity;
  if (const auto* baseline = std::get_if<net::SpawnBaseline>(&message)) return baseline->number;
  return 0;
}

}  // namespace

Outbox::Outbox(const net::Dialect& dialect, std::uint32_t client_count)
    : dialect_(dialect), players_(client_count) {}

base::ByteWriter* Outbox::reliable_to(vm::EntityIndex player) {
  const std::size_t number = base::to_size(player);
  return number >= 1 && number <= players_.size() ? &players_[number - 1] : nullptr;
}

// Invariant: a buffer contains only whole messages. The written part of a message that turns out too large or
// inexpressible is taken back.
void Outbox::write(const net::ServerMessage& message, base::ByteWriter& io_writer) {
  const std::size_t before = io_writer.size();
  if (dialect_.protocol == net::Protocol::kNetQuake && message_entity(message) >= kMaxEntitiesOfProtocol15) {
    ++dropped_;
    return;
  }
  const bool is_written = net::write_message(message, dialect_, io_writer).ok();
  const bool is_complete = is_written && io_writer.size() > before && has_room(io_writer, 0);
  if (is_complete) return;
  io_writer.truncate(before);
  ++dropped_;
}

void Outbox::write_placed(const net::ServerMessage& message, Placed placed) {
  placed.begin = placed_bytes_.size();
  write(message, placed_bytes_);
  placed.end = placed_bytes_.size();
  if (placed.end > placed.begin) placed_.push_back(placed);
}

void Outbox::write_at_place(const net::ServerMessage& message, std::optional<math::Vec3> place) {
  write_placed(message, {.place = place});
}

// A sound is silent from 1000 units / attenuation on. The margin is for players who come nearer while it
// plays.
void Outbox::write_sound(const net::Sound& sound) {
  constexpr float kSilent_units = 1000, kMargin_units = 600;
  Placed placed;
  if (sound.attenuation > 0)
    placed = {.place = sound.origin, .earshot_units = kSilent_units / sound.attenuation + kMargin_units};
  write_placed(sound, placed);
}

// Keeps the memory of each buffer. The signon stays for later clients.
void Outbox::clear_tick() {
  broadcast_.truncate(0);
  reliable_.truncate(0);
  placed_bytes_.truncate(0);
  for (base::ByteWriter& player : players_) player.truncate(0);
  placed_.clear();
}

}  // namespace temblor::server

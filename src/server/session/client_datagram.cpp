#include "server/session/client_datagram.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "server/game/ideal_pitch.h"

namespace temblor::server {
namespace {

// The same as movement::kSwimmingLevel; here it only sets a bit for the client.
constexpr int kSwimmingLevel = 2;
constexpr double kSetAngleSent_s = 0.03;  // three datagrams at 72 per second

// The status bar's items. The upper bits hold items2 of the mission packs, or else the runes of finished
// episodes:
//    bit 0 .. 22: items     23 .. 31: items2, if the program has it; else 28 .. 31: runes
std::uint32_t sent_items(Game& io_game, const Edict& edict) {
  const auto items = static_cast<std::uint32_t>(edict.whole(field::kItems));
  const float flags = io_game.server_flags();
  const auto runes = static_cast<std::uint32_t>(flags >= 0 && flags < 16 ? flags : 0.0f);
  if (const auto items2 = io_game.items2_field())
    return items | static_cast<std::uint32_t>(edict.whole(*items2)) << 23;
  return items | runes << 28;
}

// The weapon in hand. The message has one byte for it: stock Quake sends the lowest byte of its bits. The
// bits of mission packs do not fit, so they send the index of the lowest bit.
std::uint8_t sent_weapon(const Game& game, const Edict& edict) {
  // No weapon has this bit. Stock servers leave out the byte if there is no weapon, which no client can read.
  constexpr std::uint8_t kNoWeapon = 31;
  if (game.mission_pack() == assets::MissionPack::kNone) return sent_u8(edict[field::kWeapon]);
  const auto bits = static_cast<std::uint32_t>(edict.whole(field::kWeapon));
  return bits == 0 ? kNoWeapon : static_cast<std::uint8_t>(std::countr_zero(bits));
}

// The model's number; 0 if there is no such model. Game code sets only its name.
std::uint16_t find_weapon_model(Game& io_game, const Edict& edict) {
  const std::string_view name = io_game.machine().text(edict[field::kWeaponModel]);
  if (name.empty()) return 0;
  const std::vector<ServerModel>& models = io_game.world().models;
  for (std::size_t i = 1; i < models.size(); ++i)
    if (models[i].name == name) return static_cast<std::uint16_t>(i);
  return 0;
}

std::int16_t sent_i16(float value) {
  return static_cast<std::int16_t>(std::isfinite(value) ? std::clamp(value, -32768.0f, 32767.0f) : 0.0f);
}

// The place from which distances count.
math::Vec3 find_ear(const DatagramRequest& request) {
  return request.camera_world.value_or(request.game.player(request.slot)[field::kOrigin]);
}

// The share of the room that entities get in turn, if not all fit.
constexpr std::size_t kTurnsShare = 4;

// Keeps as many of `io_seen` as fit, in order of number: the player's own entity, the other players and the
// player's missiles, then the nearest of the others, and in a quarter of the room those that were not sent
// for the longest time. So everything arrives within a few ticks, and nothing nearby flickers.
void keep_what_fits(const DatagramRequest& request, std::size_t room, EntityTurns& io_turns,
                    std::vector<std::uint32_t>& io_seen) {
  const Snapshot& snapshot = request.snapshot;
  const vm::EntityIndex own = Game::player_index(request.slot);
  const math::Vec3 eye = find_ear(request);
  const std::uint32_t players = request.game.world().edicts.client_count();
  const auto rank = [&](std::uint32_t i) {
    const Snapshot::Entity& entity = snapshot.entities[i];
    const math::Vec3 away = entity.origin - eye;
    const bool is_first = entity.owner == own || base::to_size(entity.index) <= players;
    return std::pair(entity.index == own ? 0 : is_first ? 1 : 2, glm::dot(away, away));
  };
  const auto last_turn = [&](std::uint32_t i) -> std::uint32_t& {
    return io_turns.last[base::to_size(snapshot.entities[i].index)];
  };
  std::size_t kept = 0, kept_bytes = 0;
  const auto keep_up_to = [&](std::size_t limit) {
    for (; kept < io_seen.size(); ++kept) {
      const Snapshot::Entity& entity = snapshot.entities[io_seen[kept]];
      if (kept_bytes + (entity.end - entity.begin) > limit) return;
      kept_bytes += entity.end - entity.begin;
    }
  };
  io_turns.last.resize(std::max<std::size_t>(io_turns.last.size(), request.game.world().edicts.count()));
  std::stable_sort(io_seen.begin(), io_seen.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
  keep_up_to(room - room / kTurnsShare);
  std::stable_sort(io_seen.begin() + static_cast<std::ptrdiff_t>(kept), io_seen.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return last_turn(a) < last_turn(b); });
  keep_up_to(room);
  io_seen.resize(kept);
  ++io_turns.now;
  for (const std::uint32_t i : io_seen) last_turn(i) = io_turns.now;
  std::sort(io_seen.begin(), io_seen.end());
}

// Chooses the entities that this player sees, in order of number.
void choose_entities(const DatagramRequest& request, std::size_t room, EntityTurns& io_turns,
                     DatagramScratch& io_scratch, DatagramCounts& io_counts) {
  Game& io_game = request.game;
  const Snapshot& snapshot = request.snapshot;
  const vm::EntityIndex own = Game::player_index(request.slot);
  std::vector<std::uint32_t>& seen = io_scratch.seen;
  seen.clear();
  std::size_t bytes = 0;
  for (std::uint32_t i = 0; i < snapshot.entities.size(); ++i) {
    const Snapshot::Entity& entity = snapshot.entities[i];
    const bool is_itself = entity.index == own;
    if (entity.viewers == (is_itself ? Snapshot::Viewers::kOthers : Snapshot::Viewers::kItself)) continue;
    const bool is_seen =
        is_itself || (entity.is_visible && io_scratch.sight.sees(io_game.world().edicts.state(entity.index)));
    if (!is_seen) continue;
    seen.push_back(i);
    bytes += entity.end - entity.begin;
  }
  const std::size_t all = seen.size();
  if (bytes > room) keep_what_fits(request, room, io_turns, seen);
  io_counts.entities = seen.size();
  io_counts.entities_left_out = all - seen.size();
}

// Visibility starts at the player's eye, not at its origin.
void update_sight(Game& io_game, const Edict& player, const std::optional<math::Vec3>& camera_world,
                  DatagramScratch& io_scratch) {
  io_scratch.sight.update(*io_game.world().level,
                          camera_world.value_or(player[field::kOrigin] + player[field::kViewOffset]));
}

// Calls `write` with each event that the player can see or hear, then with the messages to everyone.
template <typename Write>
void for_each_event(Game& io_game, const math::Vec3& ear, const Sight& sight, Write write) {
  Outbox& outbox = io_game.outbox();
  const auto reaches = [&](const Outbox::Placed& placed) {
    if (!placed.place) return true;
    if (placed.earshot_units) return glm::distance(ear, *placed.place) < *placed.earshot_units;
    return sight.sees(*io_game.world().level, *placed.place);
  };
  for (const Outbox::Placed& placed : outbox.placed())
    if (reaches(placed)) write(outbox.placed_bytes().subspan(placed.begin, placed.end - placed.begin));
  if (outbox.broadcast().size() > 0) write(outbox.broadcast().view());
}

// Writes the kept events, then those of this tick, as far as there is room.
void write_events(const DatagramRequest& request, std::size_t max_size, const Sight& sight,
                  PendingUpdates& io_pending, DatagramCounts& io_counts, base::ByteWriter& io_writer) {
  const auto write = [&](base::Bytes event) {
    if (io_writer.size() + event.size() < max_size)
      io_writer.bytes(event);
    else
      io_counts.events_left_out = true;
  };
  std::size_t begin = 0;
  for (const std::size_t end : io_pending.event_ends) {
    write(base::Bytes(io_pending.events.view()).subspan(begin, end - begin));
    begin = end;
  }
  io_pending.events.truncate(0);
  io_pending.event_ends.clear();
  for_each_event(request.game, find_ear(request), sight, write);
}

// The direction of damage comes from the middle of what inflicted it.
void write_damage(Game& io_game, const Edict& edict, base::ByteWriter& io_writer) {
  if (edict[field::kDamageTaken] == 0 && edict[field::kDamageSaved] == 0) return;
  const Edict inflictor = io_game.world().edicts.at(edict[field::kDamageInflictor]);
  const math::Vec3 from =
      inflictor[field::kOrigin] + (inflictor[field::kMins] + inflictor[field::kMaxs]) * 0.5f;
  const net::Damage damage{.armor = sent_u8(edict[field::kDamageSaved]),
                           .blood = sent_u8(edict[field::kDamageTaken]),
                           .from = from};
  io_game.outbox().write(damage, io_writer);
  edict.set(field::kDamageTaken, 0.0f);
  edict.set(field::kDamageSaved, 0.0f);
}

// For a short time after the turn, each tick repeats the angle.
void write_set_angle(Game& io_game, const Edict& edict, PendingSetAngle& io_set_angle,
                     base::ByteWriter& io_writer) {
  if (edict[field::kFixAngle] != 0) {
    io_set_angle = {finite(edict[field::kAngles]), io_game.time_s() + kSetAngleSent_s, -1};
    edict.set(field::kFixAngle, 0.0f);
  }
  // Only once while the game is paused.
  if (io_game.time_s() > io_set_angle.until_s || io_game.time_s() == io_set_angle.sent_at_s) return;
  io_set_angle.sent_at_s = io_game.time_s();
  io_game.outbox().write(net::SetAngle{io_set_angle.angles_deg}, io_writer);
}

}  // namespace

net::ClientData make_client_data(Game& io_game, std::size_t slot) {
  const Edict edict = io_game.player(slot);
  // Protocol 15 has one byte for each. Larger numbers lose their upper bits, as on stock servers.
  const bool is_stock = io_game.setup().dialect.protocol == net::Protocol::kNetQuake;
  const auto number = [&](Field<float> f) {
    return is_stock ? std::uint16_t{sent_u8(edict[f])} : sent_u16(edict[f]);
  };
  return {.view_height = finite(edict[field::kViewOffset]).z,
          .ideal_pitch_deg = finite(math::Vec3{edict[field::kIdealPitch]}).x,
          .punch_deg = finite(edict[field::kPunchAngle]),
          .velocity = finite(edict[field::kVelocity]),
          .items = sent_items(io_game, edict),
          .on_ground = edict.has_flag(flag::kOnGround),
          .in_water = edict[field::kWaterLevel] >= kSwimmingLevel,
          .weapon_frame = number(field::kWeaponFrame),
          .armor = number(field::kArmorValue),
          .weapon_model = find_weapon_model(io_game, edict),
          .health = sent_i16(edict[field::kHealth]),
          .ammo = number(field::kCurrentAmmo),
          .shells = number(field::kAmmoShells),
          .nails = number(field::kAmmoNails),
          .rockets = number(field::kAmmoRockets),
          .cells = number(field::kAmmoCells),
          .active_weapon = sent_weapon(io_game, edict)};
}

// Notes in io_scratch where each part begins, because split_datagram() needs the parts later.
DatagramCounts write_datagram(const DatagramRequest& request, PendingUpdates& io_pending,
                              DatagramScratch& io_scratch, base::ByteWriter& io_writer) {
  Game& io_game = request.game;
  const std::size_t slot = request.slot;
  const Snapshot& snapshot = request.snapshot;
  const std::size_t max_size = io_writer.size() + request.max_bytes;
  const Edict edict = io_game.player(slot);
  set_ideal_pitch(io_game.world(), edict.index());
  update_sight(io_game, edict, request.camera_world, io_scratch);

  DatagramCounts counts;
  io_scratch.time = io_writer.size();
  io_game.outbox().write(net::Time{static_cast<float>(io_game.time_s())}, io_writer);
  io_scratch.once = io_writer.size();
  write_damage(io_game, edict, io_writer);
  write_set_angle(io_game, edict, io_pending.set_angle, io_writer);
  io_scratch.client_data = io_writer.size();
  io_game.outbox().write(make_client_data(io_game, slot), io_writer);
  io_scratch.acknowledgment = io_writer.size();
  if (!io_pending.acknowledgment.empty()) {
    io_game.outbox().write(net::StuffText{io_pending.acknowledgment}, io_writer);
    io_pending.acknowledgment.clear();
  }
  io_scratch.entities = io_writer.size();
  const std::size_t room = max_size > io_writer.size() ? max_size - io_writer.size() : 0;
  choose_entities(request, room, io_pending.entity_turns, io_scratch, counts);
  for (const std::uint32_t i : io_scratch.seen) io_writer.bytes(snapshot.entity_bytes(snapshot.entities[i]));
  io_scratch.events = io_writer.size();
  write_events(request, max_size, io_scratch.sight, io_pending, counts, io_writer);
  return counts;
}

bool split_datagram(base::Bytes datagram, const Snapshot& snapshot, const net::Dialect& dialect,
                    const DatagramScratch& scratch, net::SnapshotState& out_state) {
  const auto part = [&](std::size_t begin, std::size_t end) { return datagram.subspan(begin, end - begin); };
  if (scratch.seen.size() > net::SnapshotState::kMaxEntities) return false;
  const net::SnapshotParts parts{.time = part(scratch.time, scratch.once),
                                 .once = part(scratch.once, scratch.client_data),
                                 .client_data = part(scratch.client_data, scratch.acknowledgment),
                                 .acknowledgment = part(scratch.acknowledgment, scratch.entities),
                                 .events = part(scratch.events, datagram.size())};
  if (!net::parse_snapshot(parts, dialect, out_state)) return false;
  for (const std::uint32_t i : scratch.seen) out_state.entities.push_back(snapshot.words[i]);
  // They are sorted by distance if there was not room for all.
  const auto by_number = [](const net::SnapshotState::Entity& a, const net::SnapshotState::Entity& b) {
    return a.number < b.number;
  };
  if (!std::is_sorted(out_state.entities.begin(), out_state.entities.end(), by_number))
    std::sort(out_state.entities.begin(), out_state.entities.end(), by_number);
  return true;
}

DatagramCounts keep_events(Game& io_game, std::size_t slot, std::size_t max_bytes,
                           DatagramScratch& io_scratch, PendingUpdates& io_pending) {
  const Edict player = io_game.player(slot);
  update_sight(io_game, player, std::nullopt, io_scratch);
  DatagramCounts counts;
  for_each_event(io_game, player[field::kOrigin], io_scratch.sight, [&](base::Bytes event) {
    if (io_pending.events.size() + event.size() > max_bytes) {
      counts.events_left_out = true;
      return;
    }
    io_pending.events.bytes(event);
    io_pending.event_ends.push_back(io_pending.events.size());
  });
  return counts;
}

}  // namespace temblor::server

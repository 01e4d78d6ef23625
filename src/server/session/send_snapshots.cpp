// The end of a tick: sends all players what they see and hear.
//    all entities --take_snapshot--> encoded once --choose--> datagram of each player --> whole, or as a
//    delta Outbox: reliable messages -----------------------------> queue of each client
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "net/protocol/combat_state.h"
#include "net/protocol/powerup_end.h"
#include "server/server.h"
#include "server/session/move_parameters.h"
#include "server/session/stages.h"

namespace temblor::server {
namespace {

constexpr double kRateBurst_s = 0.1;  // a client that got little may save up this much of sv_maxrate
constexpr int kMuzzleFlash = 2;       // a bit of `effects`

std::size_t max_datagram_bytes(const Server& server, std::size_t slot) {
  return server.endpoint.message_limits(server.clients[slot].connection).unreliable_bytes;
}

// Once per server is enough: the levels of a game tend to be alike.
void warn_of_entity_limit(Server& io_server) {
  SnapshotBuffers& buffers = io_server.buffers;
  const std::size_t count = buffers.snapshot.unnumbered;
  if (count == 0 || buffers.has_warned_of_entity_limit) return;
  print(
      io_server,
      fmt::format("{} invisible to players, because protocol 15 has no number for {}; set sv_protocol 666\n",
                  count == 1 ? std::string("1 entity is") : fmt::format("{} entities are", count),
                  count == 1 ? "it" : "them"));
  buffers.has_warned_of_entity_limit = true;
}

// Game code just writes the field `frags`; the server notices the change.
void send_frags(Server& io_server) {
  Clients& clients = io_server.clients;
  for (std::size_t slot = 0; slot < clients.size(); ++slot) {
    Client& client = clients[slot];
    if (!client.is_in_game()) continue;
    const float frags = std::clamp(io_server.game->player(slot)[field::kFrags], -32768.0f, 32767.0f);
    const auto now = static_cast<std::int16_t>(std::isfinite(frags) ? frags : 0.0f);
    if (now == client.sent_frags) continue;
    client.sent_frags = now;
    clients.send_to_all(net::UpdateFrags{static_cast<std::uint8_t>(slot), now});
  }
}

// Whether the client gets values that have changed as lines of text. Only clients that number their moves
// read them. A client that still waits for earlier messages gets the newest values later.
bool takes_values(const Client& client) {
  constexpr std::size_t kMaxWaitingBytes = 1024;
  return client.moves.is_numbered() && client.queued_bytes <= kMaxWaitingBytes;
}

// Sends the game's own stats that have changed.
void send_game_stats(Server& io_server, std::size_t slot) {
  Game& game = *io_server.game;
  Client& client = io_server.clients[slot];
  for (const auto& [number, stat] : game.context().sent_stats) {
    net::StatValue value = read_sent_stat(stat, game.machine(), Game::player_index(slot));
    const auto [sent, is_new] = client.sent_stats.try_emplace(number);
    if (!is_new && sent->second == value) continue;
    sent->second = std::move(value);
    io_server.clients.send(slot, net::StuffText{net::format_game_stat({number, sent->second})});
  }
}

// Sends when the player's power-ups end, if the program has the stock game's fields for that.
void send_powerup_ends(Server& io_server, std::size_t slot) {
  struct Powerup {
    std::uint8_t bit;
    std::string_view field;
  };
  constexpr Powerup kPowerups[] = {{19, "invisible_finished"},
                                   {20, "invincible_finished"},
                                   {21, "radsuit_finished"},
                                   {22, "super_damage_finished"}};
  const vm::Machine& machine = io_server.game->machine();
  const auto player = Game::player_index(slot);
  const float items = io_server.game->player(slot)[field::kItems];
  if (!(items >= 0 && items < 4294967296.0f)) return;
  for (const Powerup& powerup : kPowerups) {
    if ((static_cast<std::uint32_t>(items) >> powerup.bit & 1) == 0) continue;
    const formats::ProgsDefinition* const definition = machine.program().find_field(powerup.field);
    if (definition == nullptr) continue;
    const auto end_s = std::bit_cast<float>(machine.entity(player)[definition->offset]);
    float& sent_s = io_server.clients[slot].sent_powerup_ends_s[powerup.bit];
    if (end_s == sent_s || !std::isfinite(end_s)) continue;
    sent_s = end_s;
    io_server.clients.send(slot, net::StuffText{net::format_powerup_end({powerup.bit, end_s})});
  }
}

// Whether a living monster near the player has chosen it as its enemy.
bool is_hunted(Game& io_game, std::size_t slot) {
  constexpr float kMaxDistance = 1500;
  Edicts& edicts = io_game.world().edicts;
  const math::Vec3 place = io_game.player(slot)[field::kOrigin];
  for (std::uint32_t number = 1; number < edicts.count(); ++number) {
    if (edicts.is_free(vm::EntityIndex{number})) continue;
    const Edict monster = edicts[vm::EntityIndex{number}];
    if (monster.has_flag(flag::kMonster) && monster[field::kEnemy] == Game::player_index(slot) &&
        monster[field::kHealth] > 0 && glm::distance(monster[field::kOrigin], place) < kMaxDistance)
      return true;
  }
  return false;
}

// Sends whether the player fights monsters; a deathmatch may have many players and hardly has monsters. The
// state ends two seconds after the last one has gone, so that monsters that change enemies cause no messages.
void send_combat_state(Server& io_server, std::size_t slot) {
  constexpr double kHold_s = 2;
  if (io_server.game->setup().kind == GameKind::kDeathmatch) return;
  Client& client = io_server.clients[slot];
  const double now_s = io_server.game->time_s();
  const bool hunted = is_hunted(*io_server.game, slot);
  if (hunted) client.hunted_at_s = now_s;
  const bool fights = hunted || (client.was_sent_combat && now_s - client.hunted_at_s < kHold_s);
  if (fights == client.was_sent_combat) return;
  client.was_sent_combat = fights;
  io_server.clients.send(slot, net::StuffText{net::format_combat_state(fights)});
}

// Whether this client gets a snapshot in this tick: not while a reliable one is still in flight, and not if
// it has got more bytes than sv_maxrate allows. Called once per tick, because it counts the bytes.
bool take_snapshot_turn(Server& io_server, std::size_t slot) {
  const ServerVariables& settings = io_server.settings();
  Client& client = io_server.clients[slot];
  const bool is_waiting = settings.has_reliable_updates() && io_server.clients.has_snapshot_in_flight(slot);
  const double rate = settings.max_rate_bytes_per_second();
  if (rate == 0) {
    client.rate_credit_bytes = 0;
    return !is_waiting;
  }
  client.rate_credit_bytes =
      std::min(client.rate_credit_bytes + rate * settings.tick_s(), rate * kRateBurst_s);
  return !is_waiting && client.rate_credit_bytes > 0;
}

// Demos contain whole datagrams, not deltas, so that any client can play them.
void record_messages(Server& io_server, std::size_t slot, base::Bytes messages) {
  if (io_server.recorder && io_server.recorder->slot() == slot)
    io_server.recorder->add(io_server.game->player(slot)[field::kViewAngles], messages);
}

// Writes the datagram as a delta from a snapshot that the client has acknowledged. false: the delta would not
// be shorter, or cannot be computed.
bool write_delta(Server& io_server, std::size_t slot) {
  SnapshotBuffers& buffers = io_server.buffers;
  net::SentSnapshots& sent = *io_server.clients[slot].sent_snapshots;
  buffers.delta.truncate(0);
  if (!split_datagram(buffers.datagram.view(), buffers.snapshot, io_server.game->setup().dialect,
                      buffers.scratch, sent.begin_snapshot()))
    return false;
  sent.write(buffers.delta);
  if (buffers.delta.size() >= buffers.datagram.size()) return false;
  sent.mark_sent();
  return true;
}

// Each datagram repeats the newest acknowledgment, so a lost one does no harm.
void acknowledge_moves(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  if (!client.moves.is_numbered()) return;
  net::write_acknowledgment(make_acknowledgment(*io_server.game, slot, client.moves.last_played()),
                            client.pending.acknowledgment);
}

// With sv_reliableupdates deltas would be pointless: every snapshot arrives, in order.
void send_snapshot(Server& io_server, std::size_t slot) {
  Client& client = io_server.clients[slot];
  SnapshotBuffers& buffers = io_server.buffers;
  buffers.datagram.truncate(0);
  acknowledge_moves(io_server, slot);
  client.sent_counts = write_datagram({.game = *io_server.game,
                                       .slot = slot,
                                       .snapshot = buffers.snapshot,
                                       .max_bytes = max_datagram_bytes(io_server, slot),
                                       .camera_world = io_server.camera_world},
                                      client.pending, buffers.scratch, buffers.datagram);
  const bool is_reliable = io_server.settings().has_reliable_updates();
  const bool is_delta = !is_reliable && client.accepts_deltas && write_delta(io_server, slot);
  const base::Bytes sent = is_delta ? buffers.delta.view() : buffers.datagram.view();
  client.rate_credit_bytes -= static_cast<double>(sent.size());
  if (is_reliable)
    io_server.clients.queue_snapshot(slot, sent);
  else
    io_server.clients.send_unreliable(slot, sent);
  record_messages(io_server, slot, buffers.datagram.view());
}

// Also for clients that still load: their queue holds the messages back.
void queue_reliable_messages(Server& io_server, std::size_t slot) {
  Outbox& outbox = io_server.game->outbox();
  io_server.clients.queue(slot, outbox.reliable().view());
  if (const base::ByteWriter* own = outbox.reliable_to(Game::player_index(slot)))
    io_server.clients.queue(slot, own->view());
}

// A muzzle flash is visible for one tick. Clearing it here saves game code a think function.
void clear_muzzle_flashes(Edicts& io_edicts) {
  for (std::uint32_t number = 1; number < io_edicts.count(); ++number) {
    if (io_edicts.is_free(vm::EntityIndex{number})) continue;
    const Edict edict = io_edicts[vm::EntityIndex{number}];
    const int effects = edict.whole(field::kEffects);
    if ((effects & kMuzzleFlash) != 0)
      edict.set(field::kEffects, static_cast<float>(effects & ~kMuzzleFlash));
  }
}

}  // namespace

// Reliable messages come before snapshots, because a snapshot may use names that they introduce. A client
// that gets no snapshot in this tick keeps its events for the next one.
void send_snapshots(Server& io_server) {
  Game& game = *io_server.game;
  SnapshotBuffers& buffers = io_server.buffers;
  take_snapshot(game.world(), game.machine(), game.look_fields(), game.setup().dialect, buffers.snapshot);
  warn_of_entity_limit(io_server);
  send_frags(io_server);
  for (std::size_t slot = 0; slot < io_server.clients.size(); ++slot) {
    Client& client = io_server.clients[slot];
    queue_reliable_messages(io_server, slot);
    if (client.stage != ClientStage::kPlaying) continue;
    if (takes_values(client)) {
      send_game_stats(io_server, slot);
      send_powerup_ends(io_server, slot);
      send_combat_state(io_server, slot);
    }
    if (io_server.recorder && io_server.recorder->slot() == slot)
      record_messages(io_server, slot, io_server.clients.take_recorded());
    if (take_snapshot_turn(io_server, slot))
      send_snapshot(io_server, slot);
    else
      keep_events(game, slot, max_datagram_bytes(io_server, slot), buffers.scratch, client.pending);
  }
  clear_muzzle_flashes(game.world().edicts);
  game.outbox().clear_tick();
}

void write_visible_entities(const Server& server, base::ByteWriter& io_writer) {
  const Snapshot& snapshot = server.buffers.snapshot;
  for (const Snapshot::Entity& entity : snapshot.entities)
    if (entity.is_visible && entity.viewers != Snapshot::Viewers::kOthers)
      io_writer.bytes(snapshot.entity_bytes(entity));
}

// Bots appear in the list of clients so that score boards, `status` and browsers show them.
void update_bot_clients(Server& io_server) {
  Game& game = *io_server.game;
  Clients& clients = io_server.clients;
  for (std::size_t slot = 0; slot < clients.size(); ++slot) {
    Client& client = clients[slot];
    if (client.is_bot() && !game.is_bot(slot)) {
      clients.release(slot, "");
      send_empty_slot(io_server, slot);
    }
    if (!game.is_bot(slot)) continue;
    if (client.is_free()) {
      client.stage = ClientStage::kBot;
      client.address = "bot";
      client.joined_at_s = io_server.clock.now_s;
    }
    const auto number = static_cast<std::uint8_t>(slot);
    const std::string_view name = game.machine().text(game.player(slot)[field::kNetName]);
    if (name != client.name) clients.send_to_all(net::UpdateName{number, client.name = name});
    const std::uint8_t colors = game.bot_colors(slot);
    if (colors != client.colors) clients.send_to_all(net::UpdateColors{number, client.colors = colors});
  }
}

void send_changed_rules(Server& io_server) {
  const ServerVariables& settings = io_server.settings();
  if (io_server.game)
    for (const auto& [name, value] : settings.rules_changed_since(io_server.sent_rules_version))
      io_server.clients.print_to_all(fmt::format("\"{}\" changed to \"{}\"\n", name, value));
  io_server.sent_rules_version = settings.variables().version();
}

}  // namespace temblor::server

// Time: when ticks are due, one tick, and what clients are told of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "net/protocol/message_writer.h"
#include "server/server.h"
#include "server/session/move_parameters.h"

namespace temblor::server {
namespace {

constexpr double kMaxWait_s = 0.25;  // after which the world has stood still rather than run ahead
// What is certain to get through whole on every way between two machines; stock clients take 1024.
constexpr std::size_t kMaxDatagram = 1400, kMaxStockDatagram = 1024;
constexpr double kRateBurst_s = 0.1;  // of sv_maxrate that may be saved up
constexpr int kMuzzleFlash = 2;       // of `effects`

std::size_t max_datagram(const Game& game) {
  return game.setup().dialect.protocol == net::Protocol::kNetQuake ? kMaxStockDatagram : kMaxDatagram;
}

}  // namespace

double Server::until_next_tick_s(double now_s) const {
  return std::max(0.0, setup_.settings.tick_s() - unplayed_s_ - (now_s - now_s_));
}

void Server::step(double now_s) {
  unplayed_s_ += has_started_ ? std::min(now_s - now_s_, kMaxWait_s) : 0;
  has_started_ = true;
  now_s_ = now_s;
  take_events();
  console_.run();
  send_changed_rules();
  const double tick_s = setup_.settings.tick_s();
  while (game_ && unplayed_s_ >= tick_s) {
    unplayed_s_ -= tick_s;
    run_tick();
  }
  if (!game_) unplayed_s_ = 0;
  drop_failed_clients();
  clients_.send_waiting();
  endpoint_.set_remote_password(setup_.settings.rcon_password());
  endpoint_.set_timeout(setup_.settings.timeout_s());
  endpoint_.update(now_s);
  autosave();
}

void Server::run_tick() {
  game_->world().settings = setup_.settings.physics();
  game_->world().tick_s = setup_.settings.world_tick_s();
  game_->world().ideal_pitch_scale = setup_.settings.ideal_pitch_scale();
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    Client& client = clients_[slot];
    client.input.is_active = client.is_in_game();
    inputs_[slot] = client.input;
    client.input.impulse = 0;
    if (!client.moves.has_begun()) continue;
    if (const base::Status status = take_numbered_moves(slot); !status.ok()) return fail(status.error());
  }
  send_move_parameters();
  if (!is_paused_) {
    if (const base::Status status = game_->tick(inputs_); !status.ok()) return fail(status.error());
    ++ticks_;
  }
  take_in_bots();
  send_tick();
  do_requests();
}

// The last of those whose turn it is becomes this tick's input; where there is none, the player stays.
base::Status Server::take_numbered_moves(std::size_t slot) {
  MoveQueue& moves = clients_[slot].moves;
  inputs_[slot].is_active = false;
  if (is_paused_) {
    moves.skip();
    return base::Ok{};
  }
  const std::span<const PlayerInput> turn = moves.take();
  if (turn.empty()) return base::Ok{};
  for (const PlayerInput& input : turn.first(turn.size() - 1)) TRY_STATUS(game_->play_move(slot, input));
  inputs_[slot] = turn.back();
  inputs_[slot].is_active = true;
  return base::Ok{};
}

// Stock clients take it for comment.
void Server::send_move_parameters() {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    if (!clients_[slot].is_in_game()) continue;
    offer_delta_compression(slot);
    const net::MoveParameters terms = move_parameters(game_->world(), slot, setup_.settings.tick_s());
    if (clients_[slot].sent_move_parameters == terms) continue;
    clients_[slot].sent_move_parameters = terms;
    clients_.tell(slot, net::StuffText{net::line_of(terms)});
  }
}

// As stock servers do; players see why they fall more slowly.
void Server::send_changed_rules() {
  const ServerVariables& settings = setup_.settings;
  if (game_)
    for (const auto& [name, value] : settings.rules_changed_since(told_rules_version_))
      clients_.print_everyone(fmt::format("\"{}\" changed to \"{}\"\n", name, value));
  told_rules_version_ = settings.variables().version();
}

// Only to clients of ours, who number their moves.
void Server::offer_delta_compression(std::size_t slot) {
  Client& client = clients_[slot];
  if (!client.moves.has_begun() || client.was_offered_deltas) return;
  client.was_offered_deltas = true;
  clients_.tell(slot, net::StuffText{net::format_delta_offer()});
}

void Server::acknowledge_moves(std::size_t slot) {
  Client& client = clients_[slot];
  if (!client.moves.has_begun()) return;
  net::write_line(acknowledgement(*game_, slot, client.moves.played()), client.untold.acknowledgement);
}

void Server::send_tick() {
  take_snapshot(game_->world(), game_->machine(), game_->look_fields(), game_->setup().dialect, snapshot_);
  if (snapshot_.unnumbered > 0 && !has_told_of_numbers_) {
    print(fmt::format("{} no number in protocol 15; sv_protocol 666 has\n",
                      snapshot_.unnumbered == 1 ? std::string("an entity has")
                                                : fmt::format("{} entities have", snapshot_.unnumbered)));
    has_told_of_numbers_ = true;
  }
  send_frags();
  Outbox& outbox = game_->outbox();
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    clients_.queue(slot, outbox.reliable().view());
    if (const base::ByteWriter* own = outbox.reliable_to(Game::player_index(slot)))
      clients_.queue(slot, own->view());
    if (clients_[slot].stage != ClientStage::kPlaying) continue;
    if (recorder_ && recorder_->slot() == slot) record_of(slot, clients_.take_heard());
    if (take_turn(slot))
      send_to(slot);
    else
      keep_events(*game_, slot, max_datagram(*game_), scratch_, clients_[slot].untold);
  }
  clear_flashes();
  outbox.clear_tick();
}

// Whether this client gets an update of this tick, once a tick: not while one that must arrive is under way,
// nor when it has had more bytes than it may.
bool Server::take_turn(std::size_t slot) {
  Client& client = clients_[slot];
  const bool waits = setup_.settings.has_reliable_updates() && clients_.has_update_under_way(slot);
  const double rate = setup_.settings.max_rate_bytes_per_second();
  if (rate == 0) {
    client.rate_credit_bytes = 0;
    return !waits;
  }
  client.rate_credit_bytes =
      std::min(client.rate_credit_bytes + rate * setup_.settings.tick_s(), rate * kRateBurst_s);
  return !waits && client.rate_credit_bytes > 0;
}

void Server::record_of(std::size_t slot, base::Bytes messages) {
  if (recorder_ && recorder_->slot() == slot)
    recorder_->add(game_->player(slot)[field::kViewAngles], messages);
}

void Server::send_to(std::size_t slot) {
  Client& client = clients_[slot];
  datagram_.truncate(0);
  acknowledge_moves(slot);
  write_datagram(*game_, slot, snapshot_, max_datagram(*game_), client.untold, scratch_, datagram_);
  const bool is_reliable = setup_.settings.has_reliable_updates();
  const bool is_delta = !is_reliable && client.accepts_deltas && write_delta(slot);
  const base::Bytes sent = is_delta ? difference_.view() : datagram_.view();
  client.rate_credit_bytes -= static_cast<double>(sent.size());
  if (is_reliable)
    clients_.queue_update(slot, sent);
  else
    clients_.send_unreliable(slot, sent);
  record_of(slot, datagram_.view());
}

// The datagram as what differs from one that the client has. False: it is no shorter so, and is told as it
// is.
bool Server::write_delta(std::size_t slot) {
  net::SentSnapshots& told = *clients_[slot].sent_snapshots;
  difference_.truncate(0);
  if (!take_datagram_apart(datagram_.view(), snapshot_, game_->setup().dialect, scratch_, told.next()))
    return false;
  told.write(difference_);
  if (difference_.size() >= datagram_.size()) return false;
  told.tell();
  return true;
}

void Server::send_frags() {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    Client& client = clients_[slot];
    if (!client.is_in_game()) continue;
    const float frags = std::clamp(game_->player(slot)[field::kFrags], -32768.0f, 32767.0f);
    const auto now = static_cast<std::int16_t>(std::isfinite(frags) ? frags : 0.0f);
    if (now == client.sent_frags) continue;
    client.sent_frags = now;
    clients_.tell_everyone(net::UpdateFrags{static_cast<std::uint8_t>(slot), now});
  }
}

// Bots that have come or gone, and what they call themselves now.
void Server::take_in_bots() {
  for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
    Client& client = clients_[slot];
    if (client.is_bot() && !game_->is_bot(slot)) {
      clients_.release(slot, "");
      tell_of_leaving(slot);
    }
    if (!game_->is_bot(slot)) continue;
    if (client.is_free()) {
      client.stage = ClientStage::kBot;
      client.address = "bot";
      client.joined_at_s = now_s_;
    }
    const auto number = static_cast<std::uint8_t>(slot);
    const std::string_view name = game_->machine().text(game_->player(slot)[field::kNetName]);
    if (name != client.name) clients_.tell_everyone(net::UpdateName{number, client.name = name});
    const std::uint8_t colors = game_->bot_colors(slot);
    if (colors != client.colors) clients_.tell_everyone(net::UpdateColors{number, client.colors = colors});
  }
}

// They are seen for one tick.
void Server::clear_flashes() {
  Edicts& edicts = game_->world().edicts;
  for (std::uint32_t number = 1; number < edicts.count(); ++number) {
    if (edicts.is_free(vm::EntityIndex{number})) continue;
    const Edict edict = edicts[vm::EntityIndex{number}];
    const int effects = edict.whole(field::kEffects);
    if ((effects & kMuzzleFlash) != 0)
      edict.set(field::kEffects, static_cast<float>(effects & ~kMuzzleFlash));
  }
}

// A game of several is nobody's own; one that is over, and one that nobody sees, are not kept either.
bool Server::can_autosave() const {
  if (setup_.settings.autosave_s() <= 0 || !setup_.write_file || setup_.write_folder.empty() || !game_ ||
      clients_.size() > 1 || clients_.all()[0].stage != ClientStage::kPlaying)
    return false;
  const Edict player = game_->player(0);
  return player[field::kHealth] > 0 && player.move_type() != MoveType::kNone;
}

void Server::autosave() {
  if (is_paused_ || !can_autosave()) return;
  const Edict player = game_->player(0);
  autosave_.watch({.health = player[field::kHealth],
                   .stands = player.move_type() != MoveType::kWalk || player.has_flag(flag::kOnGround) ||
                             player[field::kWaterLevel] > 0},
                  now_s_);
  if (autosave_.is_due(setup_.settings.autosave_s(), now_s_)) save_unasked();
}

// In the middle of a game, or because it is left. One that fails is tried again when the next is due.
void Server::save_unasked() {
  if (!saves_when_left()) return;
  const std::string name = autosave_.choose_name(setup_.write_folder);
  if (const base::Status saved = save(name); saved.ok())
    autosaved_ = name;
  else
    print_if_error(saved);
  autosave_.note_save(now_s_);
}

}  // namespace temblor::server

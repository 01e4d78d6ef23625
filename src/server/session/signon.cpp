#include "server/session/signon.h"

#include <algorithm>

#include "net/protocol/message_writer.h"
#include "server/session/client_datagram.h"

namespace temblor::server {
namespace {

// Bytes of a reliable message that clients of protocol 15, and of the later protocols, have a buffer for; and
// the size of the message that ends step 2.
constexpr std::size_t kMaxStockMessage = 8000;
constexpr std::size_t kMaxLargeMessage = 64000;
constexpr std::size_t kSignonNumberBytes = 2;

// The world's `sounds` key.
std::uint8_t music_track(const Edict& world) {
  return sent_u8(world[field::kSounds]);
}

// Messages in the game's dialect, and where each of them ends.
class MessageList {
 public:
  explicit MessageList(const net::Dialect& dialect) : dialect_(dialect) {}
  base::Status add(const net::ServerMessage& message) {
    TRY_STATUS(net::write_message(message, dialect_, bytes_));
    ends_.push_back(bytes_.size());
    return base::Ok{};
  }
  // Skips a message if QuakeC has set a value that the dialect cannot express.
  void add_if_possible(const net::ServerMessage& message) {
    if (const base::Status status = add(message); !status.ok()) return;
  }
  std::size_t size() const { return bytes_.size(); }
  base::Bytes bytes() const { return bytes_.view(); }
  const std::vector<std::size_t>& ends() const { return ends_; }
  base::ByteVector take() && { return std::move(bytes_).take(); }

 private:
  net::Dialect dialect_;
  base::ByteWriter bytes_;
  std::vector<std::size_t> ends_;
};

// Splits `bytes` into parts of at most `max_bytes`, only at `ends`, where whole messages end. kTooLarge if
// one of these pieces is longer.
base::Result<std::vector<base::ByteVector>> cut(base::Bytes bytes, const std::vector<std::size_t>& ends,
                                                std::size_t max_bytes) {
  std::vector<base::ByteVector> parts;
  std::size_t begin = 0, end = 0;  // of the current piece
  const auto finish_part = [&] {
    const base::Bytes part = bytes.subspan(begin, end - begin);
    parts.emplace_back(part.begin(), part.end());
    begin = end;
  };
  for (const std::size_t next : ends) {
    if (next - begin > max_bytes && end > begin) finish_part();
    if (next - begin > max_bytes)
      return base::error(base::ErrorCode::kTooLarge,
                         "game code sends joining clients {} bytes in one piece; the limit is {}",
                         next - begin, max_bytes);
    end = next;
  }
  finish_part();
  return parts;
}

}  // namespace

std::size_t max_reliable_bytes(const net::Dialect& dialect) {
  return dialect.protocol == net::Protocol::kNetQuake ? kMaxStockMessage : kMaxLargeMessage;
}

// Model and sound lists are ordered: a number in later messages is an index into them. Entry 0 is not sent.
base::Result<base::ByteVector> make_level_message(Game& io_game, std::size_t slot) {
  std::vector<std::string_view> models, sounds;
  for (std::size_t i = 1; i < io_game.world().models.size(); ++i)
    models.push_back(io_game.world().models[i].name);
  for (std::size_t i = 1; i < io_game.precache().sounds.size(); ++i)
    sounds.push_back(io_game.precache().sounds[i]);
  const GameSetup& setup = io_game.setup();
  const Edict world = io_game.world().edicts.world();

  const std::string level_name = io_game.localize(io_game.machine().text(world[field::kMessage]));
  MessageList messages(setup.dialect);
  TRY_STATUS(messages.add(
      net::ServerInfo{.dialect = setup.dialect,
                      .max_clients = static_cast<std::uint8_t>(setup.max_clients),
                      .game_type = static_cast<std::uint8_t>(setup.kind == GameKind::kDeathmatch ? 1 : 0),
                      .level_name = level_name,
                      .models = models,
                      .sounds = sounds}));
  const std::uint8_t track = music_track(world);
  messages.add_if_possible(net::CdTrack{track, track});
  messages.add_if_possible(net::SetView{static_cast<std::uint16_t>(slot + 1)});
  messages.add_if_possible(net::SignonNumber{1});
  if (messages.size() > max_reliable_bytes(setup.dialect))
    return base::error(
        base::ErrorCode::kTooLarge,
        "the names of {} models and {} sounds take {} bytes, more than protocol {} has room for",
        models.size(), sounds.size(), messages.size(), static_cast<int>(setup.dialect.protocol));
  return std::move(messages).take();
}

base::Result<std::vector<base::ByteVector>> make_signon_messages(Game& io_game) {
  const net::Dialect& dialect = io_game.setup().dialect;
  const std::size_t max_bytes = max_reliable_bytes(dialect) - kSignonNumberBytes;
  TRY(std::vector<base::ByteVector> parts,
      cut(io_game.outbox().signon().view(), io_game.signon_ends(), max_bytes));
  MessageList last(dialect);
  TRY_STATUS(last.add(net::SignonNumber{2}));
  parts.back().insert(parts.back().end(), last.bytes().begin(), last.bytes().end());
  return parts;
}

// Score boards first, for all slots: free ones get empty names, because the client may have names of the last
// level.
base::Result<std::vector<base::ByteVector>> make_state_messages(Game& io_game,
                                                                std::span<const Client> clients,
                                                                std::size_t slot) {
  MessageList messages(io_game.setup().dialect);
  messages.add_if_possible(net::Time{static_cast<float>(io_game.time_s())});
  for (std::size_t i = 0; i < clients.size(); ++i) {
    const auto number = static_cast<std::uint8_t>(i);
    messages.add_if_possible(net::UpdateName{number, clients[i].is_free() ? "" : clients[i].name});
    messages.add_if_possible(net::UpdateFrags{number, clients[i].sent_frags});
    messages.add_if_possible(net::UpdateColors{number, clients[i].colors});
  }
  const world::LightStylePatterns& styles = io_game.context().light_styles;
  for (std::size_t i = 0; i < styles.size(); ++i)
    messages.add_if_possible(net::LightStyle{static_cast<std::uint8_t>(i), styles[i]});
  const auto add_total = [&](std::uint8_t stat, vm::GlobalIndex total) {
    const float value = io_game.machine().global_float(total);
    messages.add_if_possible(net::UpdateStat{stat, static_cast<std::int32_t>(sent_u16(value))});
  };
  add_total(11, global::kTotalSecrets);
  add_total(12, global::kTotalMonsters);
  add_total(13, global::kFoundSecrets);
  add_total(14, global::kKilledMonsters);

  const Edict edict = io_game.player(slot);
  // Without roll: a player who died in the last level looks straight again.
  const math::Vec3 angles = finite(edict[field::kAngles]);
  messages.add_if_possible(net::SetAngle{{angles.x, angles.y, 0}});
  messages.add_if_possible(make_client_data(io_game, slot));
  messages.add_if_possible(net::SignonNumber{3});
  return cut(messages.bytes(), messages.ends(), max_reliable_bytes(io_game.setup().dialect));
}

}  // namespace temblor::server

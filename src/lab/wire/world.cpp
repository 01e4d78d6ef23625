#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/check.h"
#include "lab/wire.h"
#include "math/vec.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

namespace temblor::lab::wire {
namespace {

// Where the messages of a state begin and end in a datagram.
struct StateParts {
  base::Bytes time, client_data;
  std::vector<base::Bytes> entities;
};

base::Result<StateParts> split_state(base::Bytes datagram, const net::Dialect& dialect) {
  StateParts parts;
  net::MessageReader reader(dialect);
  reader.begin(datagram);
  for (std::size_t begin = 0;; begin = reader.offset_in_file()) {
    TRY(const std::optional<net::ServerMessage> message, reader.next());
    if (!message) return parts;
    const base::Bytes bytes = datagram.subspan(begin, reader.offset_in_file() - begin);
    if (std::holds_alternative<net::Time>(*message)) parts.time = bytes;
    if (std::holds_alternative<net::ClientData>(*message)) parts.client_data = bytes;
    if (std::holds_alternative<net::EntityUpdate>(*message)) parts.entities.push_back(bytes);
  }
}

constexpr double kTickRate = 72, kMonsterRate = 10;
constexpr int kMonsters = 12, kMissiles = 4, kItems = 16;

class BuiltInWorld {
 public:
  explicit BuiltInWorld(int players) : players_(players) {}

  base::ByteVector write_tick(std::size_t tick) {
    writer_ = {};
    time_s_ = static_cast<double>(tick) / kTickRate;
    write(net::Time{static_cast<float>(1 + time_s_)});
    const math::Vec3d velocity = (place_player(0, time_s_ + 0.01) - place_player(0, time_s_)) * 100.0;
    write(net::ClientData{.velocity = math::Vec3(velocity),
                          .items = 0x1001,
                          .on_ground = true,
                          .health = static_cast<std::int16_t>(100 - tick / 300 % 50),
                          .ammo = static_cast<std::uint16_t>(100 - tick / 20 % 100),
                          .active_weapon = 1});
    std::uint16_t number = 1;
    for (int player = 0; player < players_; ++player) write_player(number++, player);
    for (int monster = 0; monster < kMonsters; ++monster) write_monster(number++, monster);
    for (int missile = 0; missile < kMissiles; ++missile) write_missile(number++, missile);
    // Items do not differ from their baselines.
    for (int item = 0; item < kItems; ++item) write(net::EntityUpdate{.number = number++});
    return std::move(writer_).take();
  }

 private:
  static constexpr net::Dialect kBuiltInDialect{};

  void write(const net::ServerMessage& message) {
    CHECK(net::write_message(message, kBuiltInDialect, writer_).ok());
  }

  // On a winding way that never repeats soon.
  static math::Vec3d place_player(int player, double time_s) {
    const double way = 0.9 * time_s + 2.1 * player;
    return {500 * std::sin(way) + 200 * std::sin(1.7 * way), 500 * std::cos(0.83 * way),
            24 + 40 * std::max(0.0, std::sin(3.1 * way))};
  }

  static net::EntityUpdate place(std::uint16_t number, const math::Vec3d& origin) {
    net::EntityUpdate update{.number = number};
    for (int axis = 0; axis < 3; ++axis)
      update.origin[static_cast<std::size_t>(axis)] = static_cast<float>(origin[axis]);
    return update;
  }

  void write_player(std::uint16_t number, int player) {
    net::EntityUpdate update = place(number, place_player(player, time_s_));
    update.frame = static_cast<std::uint16_t>(6 + static_cast<int>(time_s_ * 10) % 6);
    update.angles_deg[1] = static_cast<float>(std::remainder(70 * time_s_ + 90 * player, 360));
    write(update);
  }

  void write_monster(std::uint16_t number, int monster) {
    const double step = std::floor(time_s_ * kMonsterRate + monster * 0.37);
    const double way = step * 0.05 + monster;
    net::EntityUpdate update =
        place(number, {900 * std::cos(way * 0.3 + monster), 700 * std::sin(way * 0.4), 24});
    update.frame = static_cast<std::uint16_t>(static_cast<int>(step) % 8);
    update.angles_deg[1] = static_cast<float>(std::remainder(20 * way, 360));
    update.step = true;
    write(update);
  }

  // Each flies for a second, 1000 units.
  void write_missile(std::uint16_t number, int missile) {
    const double flight = time_s_ + missile * 0.25, way = 1000 * (flight - std::floor(flight));
    const double direction = 2.4 * std::floor(flight) + missile;
    net::EntityUpdate update = place(number, {way * std::cos(direction), way * std::sin(direction), 40});
    update.angles_deg[1] = static_cast<float>(std::remainder(direction * 57.3, 360));
    write(update);
  }

  int players_;
  double time_s_ = 0;
  base::ByteWriter writer_;
};

}  // namespace

base::Result<WorldTick> keep_state(base::Bytes datagram, const net::Dialect& dialect) {
  TRY(StateParts parts, split_state(datagram, dialect));
  WorldTick tick;
  if (!net::parse_snapshot({.time = parts.time, .client_data = parts.client_data}, dialect, tick.state))
    return base::malformed("a state cannot be restored from its words");
  if (!tick.state.has_time) return base::malformed("a state has no time");
  for (const base::Bytes entity : parts.entities)
    if (!net::parse_entity_update(entity, dialect, tick.state.entities.emplace_back()))
      return base::malformed("an entity cannot be restored from its words");
  std::ranges::stable_sort(tick.state.entities, {}, &net::SnapshotState::Entity::number);
  base::ByteWriter messages;
  net::SnapshotWriter().write(tick.state, dialect, messages);
  tick.messages = std::move(messages).take();
  tick.time_s = std::bit_cast<float>(tick.state.time);
  return tick;
}

World make_built_in_world(double seconds, int players) {
  CHECK(players >= 1);
  World world;
  BuiltInWorld writer(players);
  const auto count = static_cast<std::size_t>(std::ceil(seconds * kTickRate));
  for (std::size_t tick = 0; tick < count; ++tick)
    world.ticks.push_back(keep_state(writer.write_tick(tick), world.dialect).value());
  return world;
}

World make_slower(const World& world, std::size_t interval) {
  World slower{.dialect = world.dialect, .tick_s = world.tick_s * static_cast<double>(interval), .ticks = {}};
  for (std::size_t tick = 0; tick < world.ticks.size(); tick += interval)
    slower.ticks.push_back(world.ticks[tick]);
  return slower;
}

}  // namespace temblor::lab::wire

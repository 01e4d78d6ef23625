// Feeds arbitrary bytes to the demo player. It must reject them or play them to an end, packet by packet and
// frame by frame, and the entities must be valid for drawing at every moment.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "client/demo/demo_index.h"
#include "client/demo/demo_player.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

bool is_finite(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_moment(client::DemoPlayer& io_player, const client::ClientSettings& settings) {
  const double time_s = io_player.server_time_s();
  CHECK(std::isfinite(time_s) && std::isfinite(io_player.packet_time_s()));
  CHECK(is_finite(io_player.view_angles_at(time_s, settings)));
  const client::Game& game = io_player.state().game();
  std::uint32_t number_before = 0;
  for (const client::InterpolatedEntity& entity : io_player.state().interpolate_entities(time_s, settings)) {
    CHECK(entity.number > number_before, "{} after {}", entity.number, number_before);
    number_before = entity.number;
    CHECK(is_finite(entity.origin_world) && is_finite(entity.previous_origin_world));
    CHECK(is_finite(entity.angles_deg));
    CHECK(entity.blend >= 0 && entity.blend <= 1);
    CHECK(entity.colormap <= game.players.size());
  }
  const client::FrameBlend weapon = io_player.state().interpolate_weapon_frame(time_s, settings);
  CHECK(weapon.blend >= 0 && weapon.blend <= 1);
  io_player.state().events().clear();
}

// A demo that has ended, normally or by an error, stays at its end.
void check_end(client::DemoPlayer& io_player) {
  for (int i = 0; i < 2; ++i) {
    const auto read = io_player.read_packet();
    CHECK(read.ok() && !*read);
  }
}

std::size_t count_packets(client::DemoPlayer player) {
  std::size_t packets = 0;
  while (true) {
    const auto read = player.read_packet();
    if (!read.ok() || !*read) break;
    check_moment(player, {.interpolate = false, .no_lerp_models = {}});
    ++packets;
  }
  check_end(player);
  return packets;
}

void play_frames(client::DemoPlayer player, const client::DemoLength& length) {
  for (double time_s = length.first_time_s; time_s <= length.last_time_s; time_s += 1.0 / 20) {
    const auto advanced = player.advance_to(time_s);
    CHECK(advanced.ok() && *advanced);
    check_moment(player, {});
  }
  const auto past_its_end = player.advance_to(length.last_time_s + 1);
  CHECK(past_its_end.ok() ? !*past_its_end : length.damage.has_value());
  check_end(player);
}

// Continuing from any saved position gives the same packets as the first reading.
void play_from_places(client::DemoPlayer player, const client::DemoLength& length) {
  const auto index = client::DemoIndex::make(player);
  CHECK(index.ok() && index->length().packets == length.packets);
  CHECK(index->packet_times_s().size() == length.packets);
  for (int i = 0; i <= 8; ++i) {
    const double time_s = std::lerp(length.first_time_s, length.last_time_s, i / 8.0);
    for (const client::DemoIndex::Entry* entry :
         {&index->find_entry_before(time_s, 1), &index->find_level_start(time_s)}) {
      CHECK(entry->time_s <= time_s);
      player.restore(entry->place);
      CHECK(player.packet_time_s() == entry->time_s);
      const auto advanced = player.advance_to(time_s);
      CHECK(advanced.ok() && *advanced && player.packet_time_s() >= time_s);
      check_moment(player, {});
    }
  }
}

}  // namespace

int temblor::fuzz::fuzz_demo(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const base::ByteVector copy(bytes.begin(), bytes.end());
  const auto length = client::DemoPlayer::scan(bytes, "fuzz.dem");
  auto player = client::DemoPlayer::open(copy, "fuzz.dem");
  CHECK(player.ok() || !length.ok());
  if (!player.ok()) return 0;
  const std::size_t packets = count_packets(std::move(*player));
  CHECK(packets == (length.ok() ? length->packets : 0));
  if (!length.ok()) return 0;
  play_frames(client::DemoPlayer::open(copy, "fuzz.dem").value(), *length);
  play_from_places(client::DemoPlayer::open(copy, "fuzz.dem").value(), *length);
  return 0;
}

#include "client/demo_player.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/interpolation.h"

namespace temblor::client {

namespace {

// The original's rule for a client that has fallen behind.
constexpr double kLongestGap_s = 0.1;

}  // namespace

struct DemoPlayer::Record {
  bool has_time = false;
  bool is_last = false;
  std::optional<math::Vec3> set_angles_deg;
};

base::Result<DemoPlayer> DemoPlayer::open(base::ByteVector bytes, std::string name) {
  auto demo = formats::DemReader::open(bytes).with_file(name);
  if (!demo.ok()) return demo.error();
  return DemoPlayer(std::move(bytes), *demo, std::move(name));
}

base::Result<DemoLength> DemoPlayer::scan(base::Bytes bytes, std::string name) {
  auto demo = formats::DemReader::open(bytes).with_file(name);
  if (!demo.ok()) return demo.error();
  DemoPlayer player({}, *demo, std::move(name));
  DemoLength length;
  while (true) {
    const auto read = player.read_packet();
    if (!read.ok()) length.damage = read.error();
    if (!read.ok() || !*read) break;
    if (player.state_.events().new_level) length.levels.push_back(player.state_.game().models[1]);
    player.state_.events().clear();
    if (length.packets == 0) length.first_time_s = player.packet_time_s_;
    length.last_time_s = player.packet_time_s_;
    ++length.packets;
  }
  length.cut_short = player.cut_short();
  if (length.packets > 0) return length;
  if (length.damage) return *length.damage;
  return base::Result<DemoLength>(base::malformed("the recording ends before the game in it begins"))
      .with_file(player.name_);
}

base::Result<bool> DemoPlayer::advance_to(double time_s) {
  while (!has_ended_ && (!is_playing() || packet_time_s_ < time_s)) TRY_STATUS(read_record());
  const PacketWindow window = packet_window(state_.previous_time_s(), state_.time_s());
  server_time_s_ = std::clamp(time_s + server_ahead_s_, std::min(window.begin_s, window.end_s), window.end_s);
  return !has_ended_;
}

base::Result<bool> DemoPlayer::read_packet() {
  do TRY_STATUS(read_record());
  while (!has_ended_ && !is_playing());
  server_time_s_ = state_.time_s();
  return !has_ended_;
}

base::Result<bool> DemoPlayer::begin_packet() {
  TRY(const bool goes_on, read_packet());
  const PacketWindow window = packet_window(state_.previous_time_s(), state_.time_s());
  server_time_s_ = std::min(window.begin_s, window.end_s);
  return goes_on;
}

base::Result<bool> DemoPlayer::read_record() {
  if (has_ended_) return false;
  auto read = play_record();
  has_ended_ = !read.ok() || !*read;
  return std::move(read).with_file(name_);
}

// False: there is none.
base::Result<bool> DemoPlayer::play_record() {
  TRY(const auto packet, demo_.next());
  if (!packet) return false;
  const double previous_time_s = state_.time_s();
  Record record;
  TRY_STATUS(apply_messages(*packet, record));
  state_.end_packet();
  if (record.has_time) {
    run_clock(previous_time_s);
    const bool turned_at_once = state_.view_has_jumped();
    previous_angles_deg_ = turned_at_once ? packet->view_angles_deg : angles_deg_;
    angles_deg_ = packet->view_angles_deg;
  }
  // A record holds where the player looked before he read its messages.
  if (record.set_angles_deg) previous_angles_deg_ = angles_deg_ = *record.set_angles_deg;
  return !record.is_last;
}

base::Status DemoPlayer::apply_messages(const formats::DemMessage& packet, Record& out_record) {
  messages_.begin(packet.message, packet.offset);
  while (true) {
    const std::size_t offset = messages_.offset_in_file();
    TRY(const auto message, messages_.next());
    if (!message) return base::Ok{};
    if (auto status = state_.apply(*message); !status.ok())
      return base::error(status.error().code, "offset {}: {}: {}", offset, net::name_of(*message),
                         status.error().what);
    if (std::holds_alternative<net::Time>(*message)) {
      out_record.has_time = true;
    } else if (const auto* set = std::get_if<net::SetAngle>(&*message)) {
      out_record.set_angles_deg = set->angles_deg;
    } else if (std::holds_alternative<net::ServerInfo>(*message)) {
      out_record = {};
      level_begins_ = true;
    } else if (std::holds_alternative<net::Disconnect>(*message)) {
      out_record.is_last = true;
    }
  }
}

void DemoPlayer::run_clock(double previous_time_s) {
  const double now_s = state_.time_s(), gap_s = now_s - previous_time_s;
  if (!clock_runs_) {
    packet_time_s_ = now_s;
  } else if (!level_begins_ && gap_s >= 0 && gap_s <= kLongestGap_s) {
    packet_time_s_ = now_s - server_ahead_s_;
  } else {
    if (!level_begins_) packet_time_s_ += std::clamp(gap_s, 0.0, kLongestGap_s);
    server_ahead_s_ = now_s - packet_time_s_;
  }
  clock_runs_ = true;
  level_begins_ = false;
}

math::Vec3 DemoPlayer::view_angles_at(double server_time_s, const ClientSettings& settings) const {
  if (!settings.interpolate) return angles_deg_;
  const PacketWindow window = packet_window(state_.previous_time_s(), state_.time_s());
  return blend_angles_deg(previous_angles_deg_, angles_deg_,
                          fraction_passed(window.begin_s, window.end_s, server_time_s));
}

}  // namespace temblor::client

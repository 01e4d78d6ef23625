#include "client/demo/demo_player.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/session/interpolation.h"

namespace temblor::client {

namespace {

// The longest gap between packets that the demo's clock counts. Stock clients use the same limit when they
// fall behind.
constexpr double kMaxGap_s = 0.1;

}  // namespace

// The findings of play_record() among the messages of one record.
struct DemoPlayer::Record {
  bool has_time = false;
  // The server disconnected: nothing follows.
  bool is_last = false;
  bool is_whole = true;  // false: the rest of the packet could not be read
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
  return player.play_to_end([] {});
}

// Damage at the end is part of the result, not a failure.
base::Result<DemoLength> DemoPlayer::play_to_end(base::FunctionRef<void()> on_packet) {
  DemoLength length;
  while (true) {
    const auto read = read_packet();
    if (!read.ok()) length.damage = read.error();
    if (!read.ok() || !*read) break;
    if (now_.state.events().new_level) length.levels.push_back(now_.state.game().models[1]);
    on_packet();
    now_.state.events().clear();
    if (length.packets == 0) length.first_time_s = now_.packet_time_s;
    length.last_time_s = now_.packet_time_s;
    ++length.packets;
  }
  length.is_truncated = is_truncated();
  if (length.packets > 0) return length;
  if (length.damage) return *length.damage;
  return base::Result<DemoLength>(base::malformed("the demo ends before its game begins")).with_file(name_);
}

// The packet at `time_s` is the one that interpolation heads for, so reading stops as soon as a packet is not
// before `time_s`.
base::Result<bool> DemoPlayer::advance_to(double time_s) {
  while (!now_.has_ended && (!is_playing() || now_.packet_time_s < time_s)) TRY_STATUS(read_record());
  const PacketWindow window = make_packet_window(now_.state.previous_time_s(), now_.state.time_s());
  now_.server_time_s =
      std::clamp(time_s + now_.server_ahead_s, std::min(window.begin_s, window.end_s), window.end_s);
  return !now_.has_ended;
}

base::Result<bool> DemoPlayer::read_packet() {
  do TRY_STATUS(read_record());
  while (!now_.has_ended && !is_playing());
  now_.server_time_s = now_.state.time_s();
  return !now_.has_ended;
}

// A packet without a time, for example with only text, belongs to the end of the one before.
base::Result<bool> DemoPlayer::begin_packet() {
  const double previous_time_s = now_.state.time_s();
  TRY(const bool goes_on, read_packet());
  if (now_.state.time_s() == previous_time_s) return goes_on;
  const PacketWindow window = make_packet_window(now_.state.previous_time_s(), now_.state.time_s());
  now_.server_time_s = std::min(window.begin_s, window.end_s);
  return goes_on;
}

base::Result<bool> DemoPlayer::read_record() {
  if (now_.has_ended) return false;
  auto read = play_record();
  now_.has_ended = !read.ok() || !*read;
  return std::move(read).with_file(name_);
}

// Returns false at the end of the file.
base::Result<bool> DemoPlayer::play_record() {
  TRY(const auto packet, now_.demo.next());
  if (!packet) return false;
  const double previous_time_s = now_.state.time_s();
  Record record;
  TRY_STATUS(apply_messages(*packet, record));
  if (record.is_whole) now_.state.end_packet();
  if (record.has_time) {
    run_clock(previous_time_s);
    const bool turned_at_once = now_.state.has_view_jumped();
    now_.previous_angles_deg = turned_at_once ? packet->view_angles_deg : now_.angles_deg;
    now_.angles_deg = packet->view_angles_deg;
  }
  // A record contains the view angles from before its messages were read.
  if (record.set_angles_deg) now_.previous_angles_deg = now_.angles_deg = *record.set_angles_deg;
  return !record.is_last;
}

base::Status DemoPlayer::apply_messages(const formats::DemMessage& packet, Record& out_record) {
  now_.messages.begin(packet.message, packet.offset);
  while (true) {
    const std::size_t offset = now_.messages.offset_in_file();
    auto next = now_.messages.next();
    if (!next.ok() && now_.messages.is_at_unknown()) {
      out_record.is_whole = false;
      return now_.state.pass_over_unknown(next.error());
    }
    TRY(const auto message, std::move(next));
    if (!message) return base::Ok{};
    if (auto status = now_.state.apply(*message); !status.ok())
      return base::error(status.error().code, "offset {}: {}: {}", offset, net::message_name(*message),
                         status.error().what);
    if (std::holds_alternative<net::Time>(*message)) {
      out_record.has_time = true;
    } else if (const auto* set = std::get_if<net::SetAngle>(&*message)) {
      out_record.set_angles_deg = set->angles_deg;
    } else if (std::holds_alternative<net::ServerInfo>(*message)) {
      out_record = {};
      now_.level_begins = true;
    } else if (std::holds_alternative<net::Disconnect>(*message)) {
      out_record.is_last = true;
    }
  }
}

// Advances the demo's clock by the server's. A level change takes no time, and a jump at most kMaxGap_s.
void DemoPlayer::run_clock(double previous_time_s) {
  const double now_s = now_.state.time_s(), gap_s = now_s - previous_time_s;
  if (!now_.clock_runs) {
    now_.packet_time_s = now_s;
  } else if (!now_.level_begins && gap_s >= 0 && gap_s <= kMaxGap_s) {
    now_.packet_time_s = now_s - now_.server_ahead_s;
  } else {
    if (!now_.level_begins) now_.packet_time_s += std::clamp(gap_s, 0.0, kMaxGap_s);
    now_.server_ahead_s = now_s - now_.packet_time_s;
  }
  now_.clock_runs = true;
  now_.level_begins = false;
}

math::Vec3 DemoPlayer::view_angles_at(double server_time_s, const ClientSettings& settings) const {
  if (!settings.interpolate) return now_.angles_deg;
  const PacketWindow window = make_packet_window(now_.state.previous_time_s(), now_.state.time_s());
  return blend_angles_deg(now_.previous_angles_deg, now_.angles_deg,
                          compute_elapsed_fraction(window.begin_s, window.end_s, server_time_s));
}

}  // namespace temblor::client

// Recordings: what game they are of, and how far they can be played.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/game/dem.h"
#include "net/protocol/message_reader.h"

namespace temblor::app {
namespace {

// Names and titles may be written in the second half of the character set, which shows the first in bronze.
std::string plain(std::string_view text) {
  std::string line(text);
  for (char& c : line) c = static_cast<char>(c & 0x7f);
  return base::printable(line);
}

Inspection flag_names(std::uint32_t flags) {
  struct Flag {
    net::ProtocolFlags flag;
    const char* name;
  };
  constexpr std::array<Flag, 7> kFlags = {{{net::kShortAngle, "SHORTANGLE"},
                                           {net::kFloatAngle, "FLOATANGLE"},
                                           {net::k24BitCoord, "24BITCOORD"},
                                           {net::kFloatCoord, "FLOATCOORD"},
                                           {net::kEdictScale, "EDICTSCALE"},
                                           {net::kAlphaSanity, "ALPHASANITY"},
                                           {net::kInt32Coord, "INT32COORD"}}};
  Inspection names = Inspection::array();
  for (const Flag& known : kFlags)
    if (flags & known.flag) names.push_back(known.name);
  return names;
}

// One level of a recording, from one ServerInfo to the next.
struct RecordedLevel {
  net::Dialect dialect;
  std::string name, file;
  std::optional<float> first_time_s;
  float last_time_s = 0;

  double seconds() const { return first_time_s ? std::max(0.0, double{last_time_s} - *first_time_s) : 0; }
};

struct Recording {
  std::vector<RecordedLevel> levels;
  std::vector<std::string> players;  // in the order that they came in
  std::map<std::string, std::size_t> message_counts;
  std::size_t packets = 0;
  bool disconnected = false;  // by the last message
  std::size_t unreadable_packets = 0;
  std::string first_unreadable;  // what is said of it

  void add(const net::ServerMessage& message) {
    ++message_counts[net::name_of(message)];
    disconnected = std::holds_alternative<net::Disconnect>(message);
    if (const auto* info = std::get_if<net::ServerInfo>(&message)) {
      const std::string_view file = info->models.empty() ? std::string_view{} : info->models[0];
      levels.push_back({info->dialect, plain(info->level_name), base::printable(file), {}, 0});
    } else if (const auto* time = std::get_if<net::Time>(&message); time != nullptr && !levels.empty()) {
      if (!levels.back().first_time_s) levels.back().first_time_s = time->time_s;
      levels.back().last_time_s = time->time_s;
    } else if (const auto* update = std::get_if<net::UpdateName>(&message)) {
      const std::string name = plain(update->name);
      if (!name.empty() && std::find(players.begin(), players.end(), name) == players.end())
        players.push_back(name);
    }
  }
  void add_unreadable(const base::Error& error) {
    if (unreadable_packets++ == 0) first_unreadable = error.message();
  }
};

void add_packet(const formats::DemMessage& packet, net::MessageReader& io_reader, Recording& io_recording) {
  ++io_recording.packets;
  io_reader.begin(packet.message, packet.offset);
  while (true) {
    const base::Result<std::optional<net::ServerMessage>> message = io_reader.next();
    if (!message.ok()) return io_recording.add_unreadable(message.error());
    if (!message->has_value()) return;
    io_recording.add(**message);
  }
}

Inspection list_problems(const Recording& recording, const formats::DemReader& reader) {
  Inspection problems = Inspection::array();
  if (recording.unreadable_packets > 0)
    problems.push_back(fmt::format("{} of {} packets cannot be read to their end; the first: {}",
                                   recording.unreadable_packets, recording.packets,
                                   recording.first_unreadable));
  if (reader.cut_short())
    problems.push_back(
        fmt::format("cut short: the last packet, at offset {}, is not all there", reader.offset()));
  else if (!recording.disconnected)
    problems.push_back("ends without svc_disconnect");
  if (recording.levels.empty()) problems.push_back("no svc_serverinfo: nothing says which level is played");
  return problems;
}

double milliseconds_of(double seconds) {
  return std::round(seconds * 1000) / 1000;
}

Inspection describe(const Recording& recording) {
  Inspection result, further = Inspection::array();
  double seconds = 0;
  for (const RecordedLevel& level : recording.levels) {
    seconds += level.seconds();
    if (&level != recording.levels.data())
      further.push_back(
          {{"level", level.name}, {"file", level.file}, {"seconds", milliseconds_of(level.seconds())}});
  }
  if (!recording.levels.empty()) {
    const RecordedLevel& first = recording.levels.front();
    result["protocol"] = static_cast<int>(first.dialect.protocol);
    result["protocol flags"] = flag_names(first.dialect.flags);
    result["level"] = first.name;
    result["level file"] = first.file;
  }
  result["further levels"] = further;
  result["seconds"] = milliseconds_of(seconds);
  result["packets"] = recording.packets;
  result["players"] = recording.players;
  result["messages"] = recording.message_counts;
  return result;
}

}  // namespace

base::Result<Inspection> inspect_dem(base::Bytes bytes) {
  TRY(formats::DemReader reader, formats::DemReader::open(bytes));
  net::MessageReader messages;
  Recording recording;
  std::string unreadable_rest;
  while (true) {
    const base::Result<std::optional<formats::DemMessage>> packet = reader.next();
    if (!packet.ok()) {
      if (recording.packets == 0) return packet.error();
      unreadable_rest = packet.error().message();
      break;
    }
    if (!packet->has_value()) break;
    add_packet(**packet, messages, recording);
  }
  Inspection result = {{"forced track", reader.forced_track()}};
  result.update(describe(recording));
  Inspection problems = list_problems(recording, reader);
  if (!unreadable_rest.empty()) problems.push_back("the rest cannot be read: " + unreadable_rest);
  result["problems"] = problems;
  return result;
}

}  // namespace temblor::app

// Demos (.dem): the levels and players in them, and how far they can be played.
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

// Removes the high bit of characters, which only makes them bronze, from names and titles.
std::string remove_bronze(std::string_view text) {
  std::string line(text);
  for (char& c : line) c = static_cast<char>(c & 0x7f);
  return base::printable(line);
}

// Returns the names of the protocol flags of RMQ (999), as other programs write them.
Inspection list_flag_names(std::uint32_t flags) {
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

// One level of a demo, from one ServerInfo message to the next.
struct DemoLevel {
  net::Dialect dialect;
  std::string name, file;
  std::optional<float> first_time_s;
  float last_time_s = 0;

  // 0 without any svc_time message.
  double seconds() const { return first_time_s ? std::max(0.0, double{last_time_s} - *first_time_s) : 0; }
};

// Facts about a demo, collected message by message.
struct DemoContents {
  std::vector<DemoLevel> levels;
  // In the order in which they joined.
  std::vector<std::string> players;
  std::map<std::string, std::size_t> message_counts;
  std::size_t packets = 0;
  // The last message was a disconnect.
  bool disconnected = false;
  // Damaged packets, and the error of the first one.
  std::size_t unreadable_packets = 0;
  std::string first_unreadable;

  void add(const net::ServerMessage& message) {
    ++message_counts[net::message_name(message)];
    disconnected = std::holds_alternative<net::Disconnect>(message);
    if (const auto* info = std::get_if<net::ServerInfo>(&message)) {
      const std::string_view file = info->models.empty() ? std::string_view{} : info->models[0];
      levels.push_back({info->dialect, remove_bronze(info->level_name), base::printable(file), {}, 0});
    } else if (const auto* time = std::get_if<net::Time>(&message); time != nullptr && !levels.empty()) {
      if (!levels.back().first_time_s) levels.back().first_time_s = time->time_s;
      levels.back().last_time_s = time->time_s;
    } else if (const auto* update = std::get_if<net::UpdateName>(&message)) {
      const std::string name = remove_bronze(update->name);
      if (!name.empty() && std::find(players.begin(), players.end(), name) == players.end())
        players.push_back(name);
    }
  }
  void add_unreadable(const base::Error& error) {
    if (unreadable_packets++ == 0) first_unreadable = error.message();
  }
};

// Reads the messages of a packet up to its end or the first damage. The next packet can be read anyway.
void add_packet(const formats::DemMessage& packet, net::MessageReader& io_reader, DemoContents& io_contents) {
  ++io_contents.packets;
  io_reader.begin(packet.message, packet.offset);
  while (true) {
    const base::Result<std::optional<net::ServerMessage>> message = io_reader.next();
    if (!message.ok()) return io_contents.add_unreadable(message.error());
    if (!message->has_value()) return;
    io_contents.add(**message);
  }
}

Inspection list_problems(const DemoContents& contents, const formats::DemReader& reader) {
  Inspection problems = Inspection::array();
  if (contents.unreadable_packets > 0)
    problems.push_back(fmt::format("{} of {} packets damaged; the first: {}", contents.unreadable_packets,
                                   contents.packets, contents.first_unreadable));
  if (reader.is_truncated())
    problems.push_back(
        fmt::format("truncated: the last packet, at offset {}, is incomplete", reader.offset()));
  else if (!contents.disconnected)
    problems.push_back("ends without svc_disconnect");
  if (contents.levels.empty()) problems.push_back("no svc_serverinfo, so the level is unknown");
  return problems;
}

double round_to_milliseconds(double seconds) {
  return std::round(seconds * 1000) / 1000;
}

Inspection describe(const DemoContents& contents) {
  Inspection result, further = Inspection::array();
  double seconds = 0;
  for (const DemoLevel& level : contents.levels) {
    seconds += level.seconds();
    if (&level != contents.levels.data())
      further.push_back(
          {{"level", level.name}, {"file", level.file}, {"seconds", round_to_milliseconds(level.seconds())}});
  }
  if (!contents.levels.empty()) {
    const DemoLevel& first = contents.levels.front();
    result["protocol"] = static_cast<int>(first.dialect.protocol);
    result["protocol flags"] = list_flag_names(first.dialect.flags);
    result["level"] = first.name;
    result["level file"] = first.file;
  }
  result["further levels"] = further;
  result["seconds"] = round_to_milliseconds(seconds);
  result["packets"] = contents.packets;
  result["players"] = contents.players;
  result["messages"] = contents.message_counts;
  return result;
}

}  // namespace

// Damage of the file's structure is an error only if there is nothing before it.
base::Result<Inspection> inspect_dem(base::Bytes bytes) {
  TRY(formats::DemReader reader, formats::DemReader::open(bytes));
  net::MessageReader messages;
  DemoContents contents;
  std::string unreadable_rest;
  while (true) {
    const base::Result<std::optional<formats::DemMessage>> packet = reader.next();
    if (!packet.ok()) {
      if (contents.packets == 0) return packet.error();
      unreadable_rest = packet.error().message();
      break;
    }
    if (!packet->has_value()) break;
    add_packet(**packet, messages, contents);
  }
  Inspection result = {{"forced track", reader.forced_track()}};
  result.update(describe(contents));
  Inspection problems = list_problems(contents, reader);
  if (!unreadable_rest.empty()) problems.push_back("the rest cannot be read: " + unreadable_rest);
  result["problems"] = problems;
  return result;
}

}  // namespace temblor::app

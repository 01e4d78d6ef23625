#include "host/commands/chat_macros.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "client/hud/items.h"
#include "formats/levels/locations.h"
#include "host/commands/command_adder.h"
#include "host/commands/shown_state.h"
#include "host/session/session.h"

namespace temblor::host {
namespace {

constexpr std::string_view kSomewhere = "somewhere";

// Joins the names of the bits that are set.
template <std::size_t kCount>
std::string list_items(std::uint32_t items,
                       const std::array<std::pair<std::uint32_t, std::string_view>, kCount>& names,
                       std::string_view none) {
  std::string list;
  for (const auto& [bit, name] : names)
    if ((items & bit) != 0) list += fmt::format("{}{}", list.empty() ? "" : " ", name);
  return list.empty() ? std::string(none) : list;
}

std::string list_weapons(std::uint32_t items) {
  constexpr std::array<std::pair<std::uint32_t, std::string_view>, 6> kNames = {{{1u << 1, "ssg"},
                                                                                 {1u << 2, "ng"},
                                                                                 {1u << 3, "sng"},
                                                                                 {1u << 4, "gl"},
                                                                                 {1u << 5, "rl"},
                                                                                 {1u << 6, "lg"}}};
  return list_items(items, kNames, "no weapons");
}

std::string list_powerups(std::uint32_t items) {
  constexpr std::array<std::pair<std::uint32_t, std::string_view>, 4> kNames = {
      {{client::kItemQuad, "quad"},
       {client::kItemInvulnerability, "pent"},
       {client::kItemInvisibility, "ring"},
       {client::kItemSuit, "suit"}}};
  return list_items(items, kNames, "no powerups");
}

// The text for a macro's letter; nothing for other letters.
std::optional<std::string> find_macro(char letter, const client::Game& game, const ChatPlaces& places,
                                      double time_s) {
  const auto stat = [&](client::Stat which) { return std::to_string(game.stat(which)); };
  switch (letter) {
    case 'h':
      return stat(client::Stat::kHealth);
    case 'a':
      return stat(client::Stat::kArmor);
    case 'r':
      return stat(client::Stat::kRockets);
    case 'c':
      return stat(client::Stat::kCells);
    case 'w':
      return list_weapons(game.data.items);
    case 'p':
      return list_powerups(game.data.items);
    case 'l':
      return places.here;
    case 'd':
      return places.of_death;
    case 't':
      return fmt::format("{}:{:02}", static_cast<long>(time_s) / 60, static_cast<long>(time_s) % 60);
    case '%':
      return "%";
    default:
      return std::nullopt;
  }
}

// The places of the level, from locs/NAME.loc or else maps/NAME.loc; empty if there is neither.
std::vector<formats::Location> load_locations(Host& io_host, const client::Game& game) {
  if (game.models.size() < 2) return {};
  const std::string level = std::filesystem::path(game.models[1]).stem().string();
  const vfs::FileSystem& files = io_host.game.data->library.files();
  for (const char* folder : {"locs", "maps"})
    if (const auto bytes = files.read(fmt::format("{}/{}.loc", folder, level)); bytes.ok())
      return formats::read_locations(base::as_text(*bytes));
  return {};
}

// Where the player was in the last update; nothing if the server has not sent the player yet.
std::optional<math::Vec3> find_player(const client::ClientState& state) {
  std::vector<client::EntityPlace> places;
  state.copy_latest_places(places);
  const auto found = std::ranges::find(places, state.game().view_entity, &client::EntityPlace::number);
  return found == places.end() ? std::nullopt : std::optional(found->origin_world);
}

std::optional<std::string> find_name(const std::vector<formats::Location>& locations,
                                     const std::optional<math::Vec3>& place_world) {
  if (!place_world) return std::nullopt;
  const formats::Location* location = formats::find_location(locations, *place_world);
  return location == nullptr ? std::nullopt : std::optional(location->name);
}

void location_command(Host& io_host, command::Console::Arguments arguments) {
  const client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  const std::optional<std::string> name =
      find_name(load_locations(io_host, state->game()), find_player(*state));
  print_line(io_host,
             name ? fmt::format("You are at: {}", *name)
                  : std::string("This level has no names for its places: there is no .loc file for it."));
}

}  // namespace

std::string expand_chat_macros(std::string_view text, const client::Game& game, const ChatPlaces& places,
                               double time_s) {
  std::string expanded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool may_be_macro = text[i] == '%' && i + 1 < text.size();
    if (const auto macro = may_be_macro ? find_macro(text[i + 1], game, places, time_s) : std::nullopt) {
      expanded += *macro;
      ++i;
    } else {
      expanded += text[i];
    }
  }
  return expanded;
}

std::string expand_chat_macros(Host& io_host, std::string_view text) {
  const client::Connection* const connection = io_host.game.session->connection();
  if (connection == nullptr || text.find('%') == std::string_view::npos) return std::string(text);
  const client::ClientState& state = connection->state();
  const std::vector<formats::Location> locations = load_locations(io_host, state.game());
  const auto name_or_somewhere = [&](const std::optional<math::Vec3>& place_world) {
    return find_name(locations, place_world).value_or(std::string(kSomewhere));
  };
  return expand_chat_macros(
      text, state.game(),
      {name_or_somewhere(find_player(state)), name_or_somewhere(state.game().death_place)}, state.time_s());
}

void add_location_command(Host& io_host) {
  make_adder(io_host)("loc", "Shows the name of the place where you are, from a .loc file.",
                      location_command);
}

}  // namespace temblor::host

#include "host/commands/view_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "command/text.h"
#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

// The state of the demo or game that is shown. Prints an error and returns null if there is none.
client::ClientState* find_state(Host& io_host, Arguments arguments) {
  if (io_host.demos.session) return &io_host.demos.session->state();
  if (io_host.game.session->is_playing()) return &io_host.game.session->connection()->state();
  io_host.console.commands.print_error(fmt::format("{}: start or join a game first", arguments[0]));
  return nullptr;
}

void apply_message(Host& io_host, client::ClientState& io_state, const net::ServerMessage& message) {
  if (const base::Status applied = io_state.apply(message); !applied.ok())
    io_host.console.commands.print_error(applied.error().message());
}

// All arguments as numbers; nothing if one of them is none.
std::optional<std::vector<float>> parse_numbers(Arguments arguments) {
  std::vector<float> numbers;
  for (const std::string& word : arguments.subspan(1)) {
    const std::optional<double> number = command::parse_number(word);
    if (!number) return std::nullopt;
    numbers.push_back(static_cast<float>(*number));
  }
  return numbers;
}

void print_fog(Host& io_host, const net::Fog& fog) {
  print_line(io_host, fmt::format("fog: density {:g}, color {:g} {:g} {:g}", fog.density, fog.color.r,
                                  fog.color.g, fog.color.b));
}

// The number of arguments tells what they are, as in other engines: DENSITY; DENSITY SECONDS; RED GREEN BLUE;
// DENSITY RED GREEN BLUE; DENSITY RED GREEN BLUE SECONDS.
void fog_command(Host& io_host, Arguments arguments) {
  client::ClientState* const state = find_state(io_host, arguments);
  if (state == nullptr) return;
  net::Fog fog = {.density = io_host.game.data->presentation.scene().fog.density,
                  .color = io_host.game.data->presentation.scene().fog.color};
  if (arguments.size() == 1) return print_fog(io_host, fog);
  const std::optional<std::vector<float>> numbers = parse_numbers(arguments);
  const std::size_t count = numbers ? numbers->size() : 0;
  if (count == 0 || count > 5)
    return io_host.console.commands.print_error(
        "fog DENSITY, fog RED GREEN BLUE, or fog DENSITY RED GREEN BLUE [SECONDS]; colors are 0 to 1");
  const std::size_t first_color = count == 3 ? 0 : 1;
  if (count != 3) fog.density = std::max((*numbers)[0], 0.0f);
  if (count >= 3)
    for (std::size_t i = 0; i < 3; ++i)
      fog.color[static_cast<int>(i)] = std::clamp((*numbers)[first_color + i], 0.0f, 1.0f);
  if (count == 2 || count == 5) fog.fade_s = std::max(numbers->back(), 0.0f);
  apply_message(io_host, *state, fog);
}

void sky_command(Host& io_host, Arguments arguments) {
  client::ClientState* const state = find_state(io_host, arguments);
  if (state == nullptr) return;
  if (arguments.size() > 1) return apply_message(io_host, *state, net::Skybox{arguments[1]});
  const std::optional<std::string>& name = state->game().skybox;
  print_line(io_host, name ? fmt::format("sky: \"{}\"", base::quotable(*name)) : "sky: that of the level");
}

void flash_command(Host& io_host, Arguments arguments) {
  if (client::ClientState* const state = find_state(io_host, arguments)) ++state->events().bonus_flashes;
}

void list_entities(Host& io_host, Arguments arguments) {
  client::ClientState* const state = find_state(io_host, arguments);
  if (state == nullptr) return;
  const std::vector<std::string>& models = state->game().models;
  std::size_t count = 0;
  for (const client::InterpolatedEntity& entity : state->interpolate_entities(state->time_s(), {})) {
    if (entity.number >= client::InterpolatedEntity::kFirstStatic) break;
    const math::Vec3& at = entity.origin_world;
    print_line(io_host, fmt::format("{:4}: {} at {:.0f} {:.0f} {:.0f}, frame {}", entity.number,
                                    entity.model < models.size() ? models[entity.model] : "?", at.x, at.y,
                                    at.z, entity.to_frame));
    ++count;
  }
  print_line(io_host, fmt::format("{} {}", count, count == 1 ? "entity" : "entities"));
}

}  // namespace

void add_view_commands(Host& io_host) {
  const auto add = [&](std::string_view name, std::string_view help, auto run) {
    io_host.console.commands.add_command(
        name, help, [host = &io_host, run](Arguments arguments) { run(*host, arguments); });
  };
  add("fog", "fog DENSITY [RED GREEN BLUE [SECONDS]]: changes the fog of this level.", fog_command);
  add("sky", "sky NAME: shows the skybox gfx/env/NAME; sky \"\": the level's sky texture.", sky_command);
  add("bf", "Flashes the screen, as when you pick something up.", flash_command);
  add("entities", "Lists the entities that the server has sent.", list_entities);
}

}  // namespace temblor::host

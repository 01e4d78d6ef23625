#include "host/commands/view_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "command/text.h"
#include "formats/levels/pts.h"
#include "host/commands/command_adder.h"
#include "host/commands/shown_state.h"
#include "host/frame/host_parts.h"
#include "vfs/disk.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

constexpr std::uint64_t kMaxLeakPathBytes = 1 << 24;

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
  client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  const render::Fog& shown = io_host.game.data->presentation.fog();
  net::Fog fog = {.density = shown.density, .color = shown.color};
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
  client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  if (arguments.size() > 1) return apply_message(io_host, *state, net::Skybox{arguments[1]});
  const std::string& name = io_host.game.data->presentation.skybox_name(state->game());
  print_line(io_host, name.empty() ? "sky: the level's own texture"
                                   : fmt::format("sky: \"{}\"", base::quotable(name)));
}

void flash_command(Host& io_host, Arguments arguments) {
  if (client::ClientState* const state = find_shown_state(io_host, arguments))
    ++state->events().bonus_flashes;
}

// "v_cshift RED GREEN BLUE PERCENT": colors and percentage go up to 255, as in the original.
void tint_command(Host& io_host, Arguments arguments) {
  const std::optional<std::vector<float>> numbers = parse_numbers(arguments);
  if (!numbers || numbers->size() > 4)
    return io_host.console.commands.print_error("v_cshift RED GREEN BLUE OPACITY, each 0 to 255");
  std::array<float, 4> tint{};
  for (std::size_t i = 0; i < numbers->size(); ++i) tint[i] = std::clamp((*numbers)[i], 0.0f, 255.0f);
  io_host.video.server_tint = {{tint[0], tint[1], tint[2]}, tint[3] / 256};
}

void list_entities(Host& io_host, Arguments arguments) {
  client::ClientState* const state = find_shown_state(io_host, arguments);
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

// Compilers write the path beside the level, often after the game began, so the disk comes first. The level
// may also be in an archive.
void show_leak_path(Host& io_host, Arguments arguments) {
  client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  const std::vector<std::string>& models = state->game().models;
  const std::string level = models.size() > 1 ? models[1] : "";
  const std::string name = base::printable(std::filesystem::path(level).replace_extension(".pts").string());
  const vfs::FileSystem& files = io_host.game.data->library.files();
  std::filesystem::path file = files.where(level);
  const bool is_loose = file.extension() == ".bsp";
  const std::string shown = is_loose ? file.replace_extension(".pts").string() : name;
  const base::Result<base::ByteVector> bytes =
      is_loose ? vfs::read_disk_file(file, kMaxLeakPathBytes) : files.read(name);
  if (!bytes.ok())
    return io_host.console.commands.print_error(
        bytes.error().code == base::ErrorCode::kNotFound
            ? fmt::format("pointfile: there is no {}. Compilers write one for a level that leaks", shown)
            : bytes.error().message());
  base::Result<std::vector<math::Vec3>> points = formats::read_pts(base::as_text(*bytes)).with_file(shown);
  if (!points.ok()) return io_host.console.commands.print_error(points.error().message());
  print_line(io_host, fmt::format("{}: {}", shown, base::counted(points->size(), "point")));
  state->events().leak_path = std::move(points).value();
}

}  // namespace

void add_view_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  add("fog", "fog DENSITY [RED GREEN BLUE [SECONDS]]: changes the fog of this level.", fog_command);
  add("sky", "sky NAME: shows the skybox gfx/env/NAME; sky \"\": the level's sky texture.", sky_command);
  add("v_cshift", "v_cshift RED GREEN BLUE OPACITY: tints the view, until you leave the game; 0 to 255.",
      tint_command);
  add("bf", "Flashes the screen, as when you pick something up.", flash_command);
  add("pointfile", "Shows where the level leaks: the line from maps/NAME.pts, until the level ends.",
      show_leak_path);
  add("entities", "Lists the entities that the server has sent.", list_entities);
}

}  // namespace temblor::host

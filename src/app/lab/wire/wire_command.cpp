#include "app/lab/wire/wire_command.h"

#include <fmt/format.h>

#include <initializer_list>
#include <optional>

#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "app/lab/wire/recorded_game.h"
#include "base/text.h"
#include "command/text.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr double kMaxLoss_percent = 50, kMaxLatency_ms = 1000;
constexpr int kMinSeconds = 5, kMaxSeconds = 120;

base::Result<ValueRange> parse_range(std::string_view text, double max) {
  const std::size_t colon = text.find(':');
  const std::optional<double> low = command::parse_number(text.substr(0, colon));
  const std::optional<double> high =
      colon == std::string_view::npos ? low : command::parse_number(text.substr(colon + 1));
  if (low && high && *low >= 0 && *low <= *high && *high <= max) return ValueRange{*low, *high};
  return base::error(ErrorCode::kUsage, "\"{}\" is not N or LOW:HIGH, from 0 to {:g}", base::quotable(text),
                     max);
}

base::Result<ValueRange> parse_loss(std::string_view text) {
  return parse_range(text, kMaxLoss_percent);
}

base::Result<ValueRange> parse_latency(std::string_view text) {
  return parse_range(text, kMaxLatency_ms);
}

std::vector<double> choose_values(const ValueRange& range, std::initializer_list<double> round) {
  std::vector<double> values{range.low};
  for (const double value : round)
    if (value > range.low && value < range.high) values.push_back(value);
  if (range.high > range.low) values.push_back(range.high);
  return values;
}

}  // namespace

void add_wire_options(Command& command, WireOptions& io_options) {
  add_parsed_option(command, "--loss", io_options.loss_percent, parse_loss,
                    "Lost packets in percent: one value, or a range (default: 0:10)")
      ->type_name("LOW:HIGH");
  add_parsed_option(command, "--latency", io_options.latency_ms, parse_latency,
                    "Round trip in milliseconds: one value, or a range (default: 0:300)")
      ->type_name("LOW:HIGH");
  command.add_option("--seconds", io_options.seconds, "Length of the game")
      ->type_name("N")
      ->check(in_range(kMinSeconds, kMaxSeconds))
      ->capture_default_str();
  command.add_option("--players", io_options.players, "Number of players, 2 to 4; the peers of lockstep")
      ->type_name("N")
      ->check(in_range(2, lab::wire::kMaxPeers))
      ->capture_default_str();
  command
      .add_option("--map", io_options.map,
                  "Level of the game, played as a deathmatch (default: a small built-in world)")
      ->type_name("NAME");
}

WireGrid make_wire_grid(const WireOptions& options) {
  WireGrid grid{.losses = choose_values(options.loss_percent, {1, 2, 5, 10, 20}),
                .pings_ms = choose_values(options.latency_ms, {100, 200, 300, 500}),
                .players = options.players};
  for (double& loss : grid.losses) loss /= 100;
  return grid;
}

base::Result<WireResults> measure_wire(const WireOptions& options, const GameFolders& folders) {
  TRY(const lab::wire::World world, record_game(folders, {.map = options.map,
                                                          .seconds = static_cast<double>(options.seconds),
                                                          .players = options.players}));
  return measure_wire(options.map.empty() ? "Built-in world" : options.map, world, make_wire_grid(options));
}

base::Status run_wire(const WireOptions& options, const GameFolders& folders, bool json,
                      const std::string& out) {
  if (!out.empty() && !base::to_lower(out).ends_with(".svg"))
    return base::error(ErrorCode::kUnsupported, "-o {}: wire writes plots (.svg)", out);
  TRY(const WireResults results, measure_wire(options, folders));
  if (!out.empty()) TRY_STATUS(replace_file(out, base::as_bytes(draw_svg_file(plot_wire(results)))));
  if (json)
    fmt::print("{}\n", make_wire_json(results));
  else
    fmt::print("{}", describe_wire(results));
  return base::Ok{};
}

std::string describe_wire_methods() {
  std::string text = fmt::format(
      "{}: Ways to send a game to its players (`temblor lab {}`)\n  From \"Quake's 3-D Engine: The Big "
      "Picture\".\n  Expected: without reliable packets, a lost one freezes the world for a tick.\n",
      kWireName, kWireName);
  for (const lab::wire::MethodInfo& info : lab::wire::list_methods())
    text += fmt::format("  {}: {}\n", info.name, info.summary);
  return text;
}

}  // namespace temblor::app

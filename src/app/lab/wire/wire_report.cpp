#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/lab/wire/wire_figures.h"

namespace temblor::app {
namespace {

namespace wire = lab::wire;

std::vector<double> list_pings(const WireResults& results) {
  std::vector<double> pings_ms;
  for (const WireFreeze& freeze : results.freezes)
    if (freeze.method == results.freezes.front().method) pings_ms.push_back(freeze.ping_ms);
  return pings_ms;
}

std::string describe_freezes(const WireResults& results) {
  const std::vector<double> pings_ms = list_pings(results);
  std::string text = fmt::format(
      "One lost packet: longest time without a newer state, ms, without and with the loss\n{:<22}",
      "round trip");
  for (const double ping_ms : pings_ms) text += fmt::format("{:>15}", fmt::format("{:g} ms", ping_ms));
  text += "\n";
  for (const wire::MethodInfo& info : wire::list_methods()) {
    text += fmt::format("{:<22}", info.name);
    for (const double ping_ms : pings_ms) {
      const WireFreeze& freeze = results.freeze(info.method, ping_ms);
      text += fmt::format("{:>15}", fmt::format("{:.0f} {:>5.0f}", freeze.gap_ms, freeze.lost_gap_ms));
    }
    text += "\n";
  }
  for (const WireFreeze& freeze : results.slower)
    text += fmt::format("{:<22}{:>15}\n", fmt::format("whole-state, {:.0f} Hz", 1000 / freeze.tick_ms),
                        fmt::format("{:.0f} {:>5.0f}", freeze.gap_ms, freeze.lost_gap_ms));
  return text;
}

nlohmann::json make_json(const WireFreeze& f) {
  return {{"method", find_method_info(f.method).name},
          {"round_trip_ms", f.ping_ms},
          {"tick_ms", f.tick_ms},
          {"longest_gap_ms", f.gap_ms},
          {"longest_gap_after_loss_ms", f.lost_gap_ms},
          {"frozen_ms", f.frozen_ms()}};
}

std::string describe_link(const WireFigures& f) {
  return fmt::format(
      "{:<22}{:>5.3g}%{:>9.2f}{:>7.2f}{:>8.0f}{:>6.0f}{:>9.0f}{:>6.0f}{:>7.0f}{:>9.0f}{:>6.0f}\n",
      find_method_info(f.method).name, f.loss * 100, f.bytes_in / 1000, f.bytes_out / 1000, f.packets_in,
      f.packets_out, f.gap_ms.p50, f.gap_ms.p99, f.gap_ms.max, f.picture_ms.p50, f.picture_ms.p99);
}

nlohmann::json make_json_distribution(const Distribution& values) {
  return {{"median", values.p50}, {"p99", values.p99}, {"max", values.max}};
}

}  // namespace

std::string describe_wire(const WireResults& results) {
  std::string text = fmt::format(
      "{}, {} players, {:.0f} s at {:.0f} ticks per second, {} runs of each. Each packet counts {} bytes of "
      "IP and UDP.\n\n{}",
      results.world, results.players, static_cast<double>(results.ticks) * results.tick_s, 1 / results.tick_s,
      kWireRuns, wire::kInternetHeaderBytes, describe_freezes(results));
  double ping_ms = -1;
  for (const WireFigures& figures : results.figures) {
    if (figures.ping_ms != ping_ms) {
      ping_ms = figures.ping_ms;
      text += fmt::format(
          "\nRound trip {:g} ms, random "
          "loss\n{:<22}{:>6}{:>16}{:>14}{:>22}{:>15}\n{:<22}{:>6}{:>9}{:>7}{:>8}{:>6}"
          "{:>9}{:>6}{:>7}{:>9}{:>6}\n",
          ping_ms, "", "", "KB/s", "packets/s", "newer state after, ms", "to picture, ms", "method", "loss",
          "in", "out", "in", "out", "median", "99 %", "worst", "median", "99 %");
    }
    text += describe_link(figures);
  }
  return text +
         "\nTo picture: from input to a picture that shows it, at 60 per second, without prediction. "
         "Prediction\n"
         "hides it for the player's own movement, with whole states and deltas, but not for anything else.\n";
}

std::string make_wire_json(const WireResults& results) {
  nlohmann::json freezes = nlohmann::json::array(), list = nlohmann::json::array();
  for (const WireFreeze& f : results.freezes) freezes.push_back(make_json(f));
  for (const WireFreeze& f : results.slower) freezes.push_back(make_json(f));
  for (const WireFigures& f : results.figures)
    list.push_back({{"method", find_method_info(f.method).name},
                    {"round_trip_ms", f.ping_ms},
                    {"loss", f.loss},
                    {"bytes_in_per_s", f.bytes_in},
                    {"bytes_out_per_s", f.bytes_out},
                    {"packets_in_per_s", f.packets_in},
                    {"packets_out_per_s", f.packets_out},
                    {"gap_ms", make_json_distribution(f.gap_ms)},
                    {"input_to_picture_ms", make_json_distribution(f.picture_ms)}});
  const nlohmann::json result = {{"world", results.world},
                                 {"players", results.players},
                                 {"ticks", results.ticks},
                                 {"tick_ms", results.tick_s * 1000},
                                 {"header_bytes", wire::kInternetHeaderBytes},
                                 {"jitter_ms", kWireJitter_ms},
                                 {"runs", kWireRuns},
                                 {"one_lost_packet", std::move(freezes)},
                                 {"random_loss", std::move(list)}};
  return result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<Plot> plot_wire(const WireResults& results) {
  const double ping_ms = choose_plotted_ping(results);
  const double seconds = static_cast<double>(results.ticks) * results.tick_s;
  Plot freezes{.title = fmt::format("The longest time without a newer state in {} runs of {:.0f} s, with a "
                                    "round trip of {:g} ms.",
                                    kWireRuns, seconds, ping_ms),
               .x_label = "lost packets, %",
               .y_label = "longest gap, ms",
               .y_axis = Axis::kLogarithmic};
  Plot bytes{.title = fmt::format("Bytes to the player, with a round trip of {:g} ms.", ping_ms),
             .x_label = "lost packets, %",
             .y_label = "KB per second"};
  for (const wire::MethodInfo& info : wire::list_methods()) {
    PlotSeries gap_series{std::string(info.name), {}}, byte_series = gap_series;
    for (const WireFigures& figures : results.figures) {
      if (figures.method != info.method || figures.ping_ms != ping_ms) continue;
      gap_series.points.push_back({figures.loss * 100, figures.gap_ms.max});
      byte_series.points.push_back({figures.loss * 100, figures.bytes_in / 1000});
    }
    freezes.series.push_back(std::move(gap_series));
    bytes.series.push_back(std::move(byte_series));
  }
  return {std::move(freezes), std::move(bytes)};
}

}  // namespace temblor::app

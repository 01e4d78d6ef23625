#include "app/lab/wire/wire_figures.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace temblor::app {
namespace {

namespace wire = lab::wire;

constexpr double kPictureRate = 60;
constexpr int kLostMoments = 5;
constexpr double kArticleRates[] = {20, 10};  // ticks per second

wire::Setup make_setup(wire::Method method, double ping_ms, int players) {
  return {.method = method, .link = {.delay_s = ping_ms / 2000}, .players = players};
}

// States that arrive at once count as one: only the last of them gets into a picture.
std::vector<double> list_gaps_ms(const wire::Transcript& transcript, double warm_s) {
  std::vector<double> gaps_ms;
  for (std::size_t i = 1; i < transcript.shown.size(); ++i) {
    const double at_s = transcript.shown[i].at_s, gap_s = at_s - transcript.shown[i - 1].at_s;
    if (gap_s > 0 && at_s >= warm_s && at_s < transcript.end_s) gaps_ms.push_back(gap_s * 1000);
  }
  return gaps_ms;
}

double find_longest_gap_ms(const wire::World& world, const wire::Setup& setup) {
  return compute_distribution(list_gaps_ms(wire::simulate(world, setup), setup.warm_s)).max;
}

// Inputs are in the order of time, and so are the ticks that they are played in.
std::vector<double> list_picture_delays_ms(const wire::Transcript& transcript) {
  std::vector<double> delays_ms;
  std::size_t next = 0;
  for (const wire::PlayedInput& input : transcript.inputs) {
    while (next < transcript.shown.size() && transcript.shown[next].tick < input.tick) ++next;
    if (next == transcript.shown.size()) break;
    const double picture_s = std::ceil(transcript.shown[next].at_s * kPictureRate) / kPictureRate;
    delays_ms.push_back((picture_s - input.at_s) * 1000);
  }
  return delays_ms;
}

std::size_t choose_interval(const wire::World& world, double rate) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(1 / (rate * world.tick_s))));
}

void add(const wire::Traffic& traffic, wire::Traffic& io_sum) {
  io_sum.bytes += traffic.bytes;
  io_sum.packets += traffic.packets;
}

void append(const std::vector<double>& values, std::vector<double>& io_all) {
  io_all.insert(io_all.end(), values.begin(), values.end());
}

// The methods must work: figures of wrong states would be worthless.
void check_faults(const wire::Transcript& transcript) {
  CHECK(transcript.wrong_states == 0 && transcript.unreadable == 0 && transcript.wrong_inputs == 0);
}

}  // namespace

WireFreeze measure_freeze(const wire::World& world, wire::Method method, double ping_ms, int players) {
  wire::Setup setup = make_setup(method, ping_ms, players);
  WireFreeze freeze{.method = method, .ping_ms = ping_ms, .tick_ms = world.tick_s * 1000};
  freeze.gap_ms = find_longest_gap_ms(world, setup);
  const double end_s = static_cast<double>(world.ticks.size()) * world.tick_s;
  std::vector<double> gaps_ms;
  for (int moment = 1; moment <= kLostMoments; ++moment) {
    setup.lose_one_at_s = setup.warm_s + (end_s - setup.warm_s) * moment / (kLostMoments + 1);
    gaps_ms.push_back(find_longest_gap_ms(world, setup));
  }
  freeze.lost_gap_ms = compute_distribution(gaps_ms).p50;
  return freeze;
}

WireFigures measure_link(const wire::World& world, wire::Method method, double ping_ms, double loss,
                         int players) {
  wire::Setup setup = make_setup(method, ping_ms, players);
  setup.link.loss = loss;
  setup.link.jitter_s = kWireJitter_ms / 1000;
  wire::Traffic in, out;
  double seconds = 0;
  std::vector<double> gaps_ms, delays_ms;
  for (setup.seed = 1; setup.seed <= std::uint64_t{kWireRuns}; ++setup.seed) {
    const wire::Transcript transcript = wire::simulate(world, setup);
    check_faults(transcript);
    add(transcript.to_viewer, in);
    add(transcript.from_viewer, out);
    seconds += transcript.end_s - setup.warm_s;
    append(list_gaps_ms(transcript, setup.warm_s), gaps_ms);
    append(list_picture_delays_ms(transcript), delays_ms);
  }
  const auto rate = [&](std::uint64_t count) { return static_cast<double>(count) / seconds; };
  return {.method = method,
          .ping_ms = ping_ms,
          .loss = loss,
          .bytes_in = rate(in.bytes),
          .bytes_out = rate(out.bytes),
          .packets_in = rate(in.packets),
          .packets_out = rate(out.packets),
          .gap_ms = compute_distribution(std::move(gaps_ms)),
          .picture_ms = compute_distribution(std::move(delays_ms))};
}

const WireFreeze& WireResults::freeze(wire::Method method, double ping_ms) const {
  const auto found = std::ranges::find_if(
      freezes, [&](const WireFreeze& f) { return f.method == method && f.ping_ms == ping_ms; });
  CHECK(found != freezes.end());
  return *found;
}

WireResults measure_wire(const std::string& name, const wire::World& world, const WireGrid& grid) {
  WireResults results{
      .world = name, .ticks = world.ticks.size(), .tick_s = world.tick_s, .players = grid.players};
  for (const wire::MethodInfo& info : wire::list_methods())
    for (const double ping_ms : grid.pings_ms)
      results.freezes.push_back(measure_freeze(world, info.method, ping_ms, grid.players));
  for (const double ping_ms : grid.pings_ms)
    for (const wire::MethodInfo& info : wire::list_methods())
      for (const double loss : grid.losses)
        results.figures.push_back(measure_link(world, info.method, ping_ms, loss, grid.players));
  for (const double rate : kArticleRates)
    results.slower.push_back(measure_freeze(make_slower(world, choose_interval(world, rate)),
                                            wire::Method::kWholeState, choose_plotted_ping(results),
                                            grid.players));
  return results;
}

const wire::MethodInfo& find_method_info(wire::Method method) {
  return *std::ranges::find(wire::list_methods(), method, &wire::MethodInfo::method);
}

double choose_plotted_ping(const WireResults& results) {
  double longest_ms = 0;
  for (const WireFigures& figures : results.figures) {
    if (figures.ping_ms == kArticlePing_ms) return kArticlePing_ms;
    longest_ms = std::max(longest_ms, figures.ping_ms);
  }
  return longest_ms;
}

}  // namespace temblor::app

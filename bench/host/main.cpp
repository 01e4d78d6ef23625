// Measures the delays that a player notices: until the first frame, until a level starts, and from a key to
// its picture. Frames are drawn at 1920 x 1080 into memory, and events come at random moments between two
// frames of a 60 Hz display. It also compares frames with and without a server tick in parallel with drawing,
// in alternating order.
//
// Usage: host_bench PROGS [MAP]..., with the basedir in TEMBLOR_DATA.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/client_server/crowd.h"
#include "host/frame/host_parts.h"
#include "platform/headless/window.h"
#include "support/random.h"

namespace temblor {
namespace {

constexpr double kDisplay_hz = 60;
constexpr int kEvents = 200;
// The length of the server's tick. The clock advances by one tick per frame.
constexpr double kTick_s = 1.0 / 72;
constexpr int kPairs = 600;
constexpr std::size_t kMonsters = 600;

[[noreturn]] void fail(const base::Error& error) {
  fmt::print(stderr, "host_bench: {}\n", error.message());
  std::exit(1);
}

void print_row(std::string_view what, std::string_view measured, std::string_view goal) {
  fmt::print("| {} | {} | {} |\n", what, measured, goal);
}

void run_until_playing(host::Host& io_host) {
  while (!io_host.game.session->is_playing() || !io_host.game.data->presentation.has_level())
    run_frame(io_host);
  run_frame(io_host);
}

void measure_latency(host::Host& io_host, platform::headless::HeadlessWindow& io_window,
                     std::string_view name) {
  test::Random random(1);
  std::vector<double> latencies_s, drawings_s;
  for (int i = 0; i < kEvents; ++i) {
    // The mouse moves at a random moment between this frame and the next.
    io_window.put_at(platform::MouseMoved{5, 0}, io_window.now_s() + random.uniform(0, 1 / kDisplay_hz));
    run_frame(io_host);
    if (frame_times(io_host).latency_s > 0) latencies_s.push_back(frame_times(io_host).latency_s);
    drawings_s.push_back(frame_times(io_host).drawing_s + frame_times(io_host).present_s);
  }
  std::sort(latencies_s.begin(), latencies_s.end());
  std::sort(drawings_s.begin(), drawings_s.end());
  const auto ms = [](const std::vector<double>& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))] * 1000;
  };
  print_row(fmt::format("{}: input to presented frame, median and 99 of 100", name),
            fmt::format("{:.1f}, {:.1f} ms", ms(latencies_s, 0.5), ms(latencies_s, 0.99)),
            fmt::format("at most {:.1f} ms", 1000 / kDisplay_hz + 5));
  print_row(fmt::format("{}: of that drawing and presenting, median", name),
            fmt::format("{:.1f} ms", ms(drawings_s, 0.5)), "-");
}

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Runs a frame that is one tick long, and measures it.
double timed_frame(host::Host& io_host, platform::headless::HeadlessWindow& io_window, double& io_now_s) {
  io_window.set_now(io_now_s += kTick_s);
  const double began_s = clock_s();
  run_frame(io_host);
  return clock_s() - began_s;
}

void measure_halves(host::Host& io_host, platform::headless::HeadlessWindow& io_window,
                    command::Variables& io_variables, std::string_view name, double& io_now_s) {
  constexpr int kWarm = 144;
  for (int i = 0; i < kWarm; ++i) timed_frame(io_host, io_window, io_now_s);
  std::array<std::vector<double>, 2> frames_s;
  std::vector<double> saved_s;
  for (int pair = 0; pair < kPairs; ++pair) {
    std::array<double, 2> frame_s{};
    // Each kind comes first in half of the pairs.
    for (const std::size_t parallel :
         {static_cast<std::size_t>(pair % 2), 1 - static_cast<std::size_t>(pair % 2)}) {
      if (!io_variables.set("host_parallel", std::to_string(parallel)).ok()) std::abort();
      frame_s[parallel] = timed_frame(io_host, io_window, io_now_s);
      frames_s[parallel].push_back(frame_s[parallel]);
    }
    saved_s.push_back(frame_s[0] - frame_s[1]);
  }
  print_row(fmt::format("{}: a frame with its tick, in order and beside it, median", name),
            fmt::format("{:.2f}, {:.2f} ms; saved {:.2f} ms", 1000 * median(frames_s[0]),
                        1000 * median(frames_s[1]), 1000 * median(saved_s)),
            "-");
}

// Runs on two cores, with the monsters of the level alone and with a crowd that chases the player.
void measure_two_halves(host::Host& io_host, platform::headless::HeadlessWindow& io_window,
                        command::Variables& io_variables) {
  double now_s = io_window.now_s();
  append_commands(io_host, "disconnect; host_maxfps 10000; sv_protocol 666; map lq_e1m2");
  while (!io_host.game.session->is_playing() || !io_host.game.data->presentation.has_level())
    timed_frame(io_host, io_window, now_s);
  measure_halves(io_host, io_window, io_variables, "lq_e1m2", now_s);
  server::Game& game = *io_host.game.session->server()->game;
  if (const base::Status added = bench::add_monsters(kMonsters, game); !added.ok()) fail(added.error());
  if (const base::Status set = bench::set_upon_player(game); !set.ok()) fail(set.error());
  measure_halves(
      io_host, io_window, io_variables,
      fmt::format("lq_e1m2, {} monsters after the player", bench::list_monsters(game.world()).size()), now_s);
}

int run(const char* data, const char* progs, std::span<const char* const> maps) {
  platform::headless::HeadlessWindow window({.size = {1920, 1080}});
  command::Variables variables;
  const host::HostVariables settings(variables);
  const double began_s = window.now_s();
  auto started = host::start_host(
      {.window = window,
       .write_file = [](const std::filesystem::path&, base::Bytes) { return base::Status(base::Ok{}); },
       .print_line = [](std::string_view) {}},
      settings,
      {.folders = {data, {}},
       .program_file = progs,
       .commands = {"host_maxfps 60; vid_width 1920; vid_height 1080"}});
  if (!started.ok()) fail(started.error());
  host::Host& host = **started;
  run_frame(host);
  fmt::print("| what | measured | goal |\n| --- | --- | --- |\n");
  print_row("program start to first frame", fmt::format("{:.2f} s", window.now_s() - began_s), "under 1 s");
  for (const char* const map : maps) {
    append_commands(host, "disconnect");
    run_frame(host);
    append_commands(host, fmt::format("map {}", map));
    const double typed_s = window.now_s();
    run_until_playing(host);
    print_row(fmt::format("`map {}` typed to playing", map),
              fmt::format("{:.2f} s", window.now_s() - typed_s), "under 0.5 s");
    measure_latency(host, window, map);
  }
  measure_two_halves(host, window, variables);
  return 0;
}

}  // namespace
}  // namespace temblor

int main(int argument_count, char** arguments) {
  const char* const data = std::getenv("TEMBLOR_DATA");
  if (argument_count < 2 || data == nullptr) {
    fmt::print(stderr, "usage: TEMBLOR_DATA=DIR host_bench PROGS [MAP]...\n");
    return 2;
  }
  std::vector<const char*> maps(arguments + 2, arguments + argument_count);
  if (maps.empty()) maps = {"lq_e1m2", "lq_e0m1", "start"};
  return temblor::run(data, arguments[1], maps);
}

// Measures the time from a key press or a movement of the mouse until a real window shows the turned view.
//
//   latency_bench temblor BASEDIR PROGS [VARIABLE=VALUE]...      runs the game as `temblor play` does
//   latency_bench quakespasm BASEDIR PROGS [VARIABLE=VALUE]...   for comparison
//
// Prints a row of a table for each kind of event. Needs an X display without a window manager and other
// windows: tools/measure_latency.sh makes one.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/latency/window_probe.h"
#include "host/host.h"
#include "host/host_variables.h"
#include "host/services.h"
#include "platform/sdl2/window.h"
#include "support/programs/background_program.h"
#include "support/programs/quakespasm_folder.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

namespace temblor::bench {
namespace {

constexpr int kEvents = 120;
constexpr double kRefresh_s = 1.0 / 60;

// A frame that showed the effect of an event, as scr_showlatency measures it.
struct ShownEvent {
  double shown_s = 0, latency_s = 0;
};

class ShownEvents {
 public:
  void add(ShownEvent event) {
    const std::lock_guard lock(mutex_);
    events_.push_back(event);
  }
  // Returns the latency of the first event that happened at `event_s` or later. X counts milliseconds.
  std::optional<double> find(double event_s) {
    const std::lock_guard lock(mutex_);
    std::optional<double> latency_s;
    for (const ShownEvent& event : events_)
      if (!latency_s && event.shown_s - event.latency_s >= event_s - 0.002) latency_s = event.latency_s;
    events_.clear();
    return latency_s;
  }

 private:
  std::mutex mutex_;
  std::vector<ShownEvent> events_;
};

// The probe's clock. The window's has another start.
double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double part(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0
                        : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string format_ms(const std::vector<double>& values_s) {
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", 1000 * part(values_s, 0.5), 1000 * part(values_s, 0.95),
                     1000 * part(values_s, 1));
}

// Prints the row of one kind of event. `shown` is null for another program.
void measure_events(Action action, std::string_view label, WindowProbe& io_probe, ShownEvents* shown) {
  test::Random random(1);
  std::vector<double> latencies_s, own_s;
  int lost = 0;
  for (int i = 0; i < kEvents; ++i) {
    // At any moment of a frame.
    std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0.02, 0.1)));
    const std::optional<double> latency_s = io_probe.measure(action);
    if (!latency_s) {
      ++lost;
      continue;
    }
    latencies_s.push_back(*latency_s);
    if (shown == nullptr) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(40));  // until the frame has ended
    if (const std::optional<double> own = shown->find(io_probe.sent_s())) own_s.push_back(*own);
  }
  fmt::print("| {} | {} | {} | {:.1f} | {} | {} |\n", label, action == Action::kTurnByKey ? "key" : "mouse",
             format_ms(latencies_s), part(latencies_s, 0.5) / kRefresh_s,
             own_s.empty() ? "-" : format_ms(own_s), lost);
  std::fflush(stdout);
}

bool measure_window(const std::string& title, std::string_view label, ShownEvents* shown) {
  const std::unique_ptr<WindowProbe> probe = WindowProbe::find(title);
  if (!probe) {
    fmt::print(stderr, "latency_bench: there is no display, or no window \"{}\"\n", title);
    return false;
  }
  std::this_thread::sleep_for(std::chrono::seconds(3));  // until the level is drawn and the player has landed
  for (const Action action : {Action::kTurnByKey, Action::kTurnByMouse})
    measure_events(action, label, *probe, shown);
  return true;
}

[[noreturn]] void fail(const base::Error& error) {
  fmt::print(stderr, "latency_bench: {}\n", error.message());
  std::exit(1);
}

struct Setup {
  const char* base_folder;
  const char* program_file;
  std::vector<std::string> commands;  // "VARIABLE VALUE"
};

std::string make_label(std::string_view name, const Setup& setup) {
  std::string label(name);
  for (const std::string& command : setup.commands) label += fmt::format(", `{}`", command);
  return label;
}

int measure_quakespasm(const Setup& setup) {
  const test::TemporaryFolder home;
  const auto folder = test::make_quakespasm_folder(home, setup.base_folder, setup.program_file);
  if (!folder) {
    fmt::print("latency: quakespasm is not installed\n");
    return 0;
  }
  // Its settings file, so that all words reach their variables in order.
  std::string script = "bind LEFTARROW +left; bind RIGHTARROW +right\n";
  for (const std::string& command : setup.commands) script += command + "\n";
  home.write("base/id1/quake.rc", script + "map start\n");
  const test::BackgroundProgram program(
      {"quakespasm", "-basedir", folder->string(), "-window", "-width", "1280", "-height", "720", "-nosound"},
      home.path());
  if (measure_window("QuakeSpasm", make_label("QuakeSpasm", setup), nullptr)) return 0;
  fmt::print(stderr, "{}\n", program.output());
  return 1;
}

// Runs the game on this thread, as `temblor play` does, and the probe on another one.
int measure_temblor(const Setup& setup) {
  command::Variables variables;
  const host::HostVariables host_variables(variables);
  std::string commands;
  for (const std::string& command : setup.commands) commands += command + ";";
  auto window = platform::sdl2::open_window("Temblor", host_variables.window());
  if (!window.ok()) fail(window.error());
  auto started = host::start_host(
      {.window = **window,
       .write_file = [](const std::filesystem::path&, base::Bytes) { return base::Status(base::Ok{}); },
       .print_line = [](std::string_view) {}},
      host_variables,
      {.folders = {setup.base_folder, {}},
       .program_file = setup.program_file,
       .commands = {commands + "vid_width 1280; vid_height 720; map start"}});
  if (!started.ok()) fail(started.error());
  ShownEvents shown;
  std::atomic<bool> is_over = false, is_measured = false;
  std::thread prober([&] {
    is_measured = measure_window("Temblor", make_label("Temblor", setup), &shown);
    is_over = true;
  });
  while (!is_over && host::run_frame(**started))
    if (const double latency_s = frame_times(**started).latency_s; latency_s > 0)
      shown.add({clock_s(), latency_s});
  prober.join();
  return is_measured ? 0 : 1;
}

}  // namespace
}  // namespace temblor::bench

int main(int argument_count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + argument_count);
  if (words.size() < 3 || (words[0] != "temblor" && words[0] != "quakespasm")) {
    fmt::print(stderr, "usage: latency_bench temblor|quakespasm BASEDIR PROGS [VARIABLE=VALUE]...\n");
    return 2;
  }
  temblor::bench::Setup setup{arguments[2], arguments[3], {words.begin() + 3, words.end()}};
  for (std::string& command : setup.commands) std::replace(command.begin(), command.end(), '=', ' ');
  return words[0] == "temblor" ? temblor::bench::measure_temblor(setup)
                               : temblor::bench::measure_quakespasm(setup);
}

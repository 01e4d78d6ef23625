// compile_bench PROGRAM: measures the map compiler on stock maps, compares it with the project's goals
// (docs/performance.md), and prints Markdown. TEMBLOR_DATA names the game data; PROGRAM is `temblor`, for
// measurements that need a whole process.
//
// Stages are timed in this process: CPU seconds with one thread, and wall seconds with one and with two
// threads in alternating runs, so that a machine that slows down affects both. All results are medians.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/compiled_maps.h"
#include "compiler/vis/sight_lines.h"
#include "support/pictures/seen_area.h"
#include "support/random.h"
#include "world/visibility.h"

namespace temblor::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 5;

struct Goals {
  const char* map;
  double bsp_s, visibility_s, light_s;  // CPU seconds
  double leaves_seen_percent;           // in the finished level
  double fast_s;                        // 0: none
  int runs;                             // with one thread and with two; short measurements need more of them
};
constexpr std::array<Goals, 3> kGoals = {{{"lq_e0m1", 0.5, 0.5, 7, 11.0, 1, 15},
                                          {"lq_e1m2", 1.2, 0.9, 1.7, 21.5, 0, 15},
                                          {"lqdm5", 1.0, 3.0, 11, 38.2, 0, kRuns}}};

double wall_now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_now_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

struct Seconds {
  double wall = 0, cpu = 0;
};

// A stage lasts until the next one begins, the last one until finish().
class StageClock : public compiler::CompileWatcher {
 public:
  void begin_stage(const char* name) override {
    finish();
    name_ = name;
    begin_ = {wall_now_s(), cpu_now_s()};
  }
  bool progress(std::size_t, std::size_t) override { return true; }
  void save(base::Bytes) override {}
  void finish() {
    if (!name_.empty()) stages_[name_] = {wall_now_s() - begin_.wall, cpu_now_s() - begin_.cpu};
  }
  const std::map<std::string, Seconds>& stages() const { return stages_; }

 private:
  std::string name_;
  Seconds begin_;
  std::map<std::string, Seconds> stages_;
};

struct Run {
  compiler::Build level;
  std::map<std::string, Seconds> stages;
};

class Bench {
 public:
  Bench(const fs::path& data, const std::string& name)
      : map_(test::read_stock_map(data, name)), textures_(test::read_stock_textures(data, map_)) {}

  Run run(int threads, int extra) const { return run(map_, threads, extra, {}); }

  // Compiles again after one lamp has moved by a few units.
  Run run_with_lamp_moved(const Run& before) const {
    formats::Map map = map_;
    for (formats::MapEntity& entity : map.entities) {
      const auto origin = entity.fields.find_vec3("origin");
      if (!entity.fields.classname().starts_with("light") || !origin) continue;
      for (auto& [key, value] : entity.fields.pairs)
        if (key == "origin") value = fmt::format("{} {} {}", origin->x, origin->y, origin->z + 4);
      break;
    }
    return run(map, 1, 1, before.level);
  }

 private:
  Run run(const formats::Map& map, int threads, int extra, compiler::Build build) const {
    base::Jobs jobs(threads);
    compiler::CompileOptions options;
    options.light.extra = extra;
    compiler::Warnings warnings;
    StageClock clock;
    const auto report = compiler::compile_level({map, textures_.sources, textures_.palette}, options,
                                                {jobs, clock, warnings}, build);
    CHECK(report.ok(), "{}", report.error().what);
    clock.finish();
    return {std::move(build), clock.stages()};
  }

  formats::Map map_;
  test::StockTextures textures_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Seconds compute_median(const std::vector<Run>& runs, const char* stage) {
  std::vector<double> wall, cpu;
  for (const Run& run : runs) {
    wall.push_back(run.stages.at(stage).wall);
    cpu.push_back(run.stages.at(stage).cpu);
  }
  return {median(wall), median(cpu)};
}

struct ProcessCost {
  double wall_s = 0, peak_megabytes = 0;
};

// Runs the whole program, from .map to .bsp. CHECKs that it succeeds.
ProcessCost run_program(const std::string& program, std::vector<std::string> words) {
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const double begin = wall_now_s();
  std::fflush(stdout);  // otherwise the child would print it again
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) != nullptr) execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  CHECK(child > 0 && wait4(child, &status, 0, &usage) == child && status == 0, "{} failed", program);
  return {wall_now_s() - begin, static_cast<double>(usage.ru_maxrss) / 1024};
}

// The area that our visibility lets through at 1,000 fixed points, divided by the finished level's.
double area_share(const fs::path& data, const std::string& name, const formats::Bsp& compiled) {
  const formats::Bsp finished = compiler::finished_level(data, name);
  const auto ours = world::make_level(compiled, name).value(),
             theirs = world::make_level(finished, name).value();
  const std::vector<double> our_areas = test::compute_face_areas(*ours),
                            their_areas = test::compute_face_areas(*theirs);
  test::Random random(1);
  double our_sum = 0, their_sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const math::Vec3 at(compiler::random_open_point(finished, random).value());
    our_sum += test::visible_area(*ours, world::find_leaf(*ours, at), our_areas);
    their_sum += test::visible_area(*theirs, world::find_leaf(*theirs, at), their_areas);
  }
  return our_sum / their_sum;
}

void print_row(const std::string& what, const std::string& measured, const std::string& goal) {
  fmt::print("| {} | {} | {} |\n", what, measured, goal);
}

struct ProgramCosts {
  double fast_s = 0, peak_megabytes = 0;
};

ProgramCosts measure_program(const std::string& program, const fs::path& data, const std::string& name) {
  const fs::path out = fs::temp_directory_path() / fmt::format("temblor_bench_{}.bsp", getpid());
  const auto compile = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"--basedir", data.string(),
                                      "compile",   (data / "mapsrc" / (name + ".map")).string(),
                                      "--wad",     (data / "wads").string(),
                                      "-o",        out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(program, words);
  };
  const ProcessCost whole = compile({});
  std::vector<double> fast_s;
  for (int i = 0; i < kRuns; ++i) fast_s.push_back(compile({"--fast", "--clean"}).wall_s);
  for (const char* ending : {".bsp", ".lit"}) {
    std::error_code ignored;
    fs::remove(fs::path(out).replace_extension(ending), ignored);
  }
  return {median(fast_s), whole.peak_megabytes};
}

void print_map(const fs::path& data, const Goals& goals, const ProgramCosts& costs) {
  const std::string name = goals.map;
  const Bench bench(data, name);
  std::vector<Run> one, two, fine, moved;
  for (int i = 0; i < goals.runs; ++i) {
    one.push_back(bench.run(1, 1));
    two.push_back(bench.run(2, 1));
    if (i >= kRuns) continue;
    fine.push_back(bench.run(1, 4));
    moved.push_back(bench.run_with_lamp_moved(one.back()));
  }
  fmt::print("\n### {}\n\n| what | measured | goal |\n| --- | --- | --- |\n", name);
  const std::array<std::pair<const char*, double>, 3> stages = {
      {{"bsp", goals.bsp_s}, {"visibility", goals.visibility_s}, {"light", goals.light_s}}};
  for (const auto& [stage, goal_s] : stages)
    print_row(fmt::format("{}, CPU seconds of one thread", stage),
              fmt::format("{:.2f}", compute_median(one, stage).cpu), fmt::format("at most {}", goal_s));
  for (const auto& [stage, goal_s] : stages)
    print_row(fmt::format("{}, two threads / one", stage),
              fmt::format("{:.2f} ({:.2f} s, {:.2f} s)",
                          compute_median(one, stage).wall / compute_median(two, stage).wall,
                          compute_median(one, stage).wall, compute_median(two, stage).wall),
              stage == stages[0].first ? "-" : "at least 1.9");
  print_row("light, 4x4 / plain",
            fmt::format("{:.2f}", compute_median(fine, "light").cpu / compute_median(one, "light").cpu),
            "at most 6");
  print_row("light after a lamp moved / all of it",
            fmt::format("{:.2f}", compute_median(moved, "light").cpu / compute_median(one, "light").cpu),
            "under a third");
  print_row("--fast, whole program", fmt::format("{:.2f} s", costs.fast_s),
            goals.fast_s > 0 ? fmt::format("under {} s", goals.fast_s) : "-");
  print_row("peak memory, whole program", fmt::format("{:.0f} MB", costs.peak_megabytes), "under 300 MB");
  const compiler::Build& level = one.front().level;
  print_row("leaves seen on average", fmt::format("{:.1f} %", level.mean_visible_share.value_or(1) * 100),
            fmt::format("(existing tool {} %)", goals.leaves_seen_percent));
  print_row("area of faces seen / finished level's", fmt::format("{:.3f}", area_share(data, name, level.bsp)),
            "at most 1.05");
}

}  // namespace
}  // namespace temblor::bench

int main(int count, char** arguments) {
  const char* data = std::getenv("TEMBLOR_DATA");
  if (count < 2 || data == nullptr) {
    fmt::print(stderr, "usage: TEMBLOR_DATA=FOLDER compile_bench PROGRAM [MAP...]\n");
    return 1;
  }
  std::vector<temblor::bench::Goals> maps;
  const std::span wanted(arguments + 2, static_cast<std::size_t>(count - 2));
  for (const temblor::bench::Goals& goals : temblor::bench::kGoals)
    if (wanted.empty() || std::ranges::count(wanted, std::string_view(goals.map)) > 0) maps.push_back(goals);
  if (maps.size() < wanted.size()) {
    fmt::print(stderr, "compile_bench: there are goals only for");
    for (const temblor::bench::Goals& goals : temblor::bench::kGoals) fmt::print(stderr, " {}", goals.map);
    fmt::print(stderr, "\n");
    return 1;
  }
  // Programs first: a child's peak of memory begins with that of its parent.
  std::vector<temblor::bench::ProgramCosts> costs;
  for (const temblor::bench::Goals& goals : maps)
    costs.push_back(temblor::bench::measure_program(arguments[1], data, goals.map));
  fmt::print("## Compiling\n");
  for (std::size_t i = 0; i < costs.size(); ++i) temblor::bench::print_map(data, maps[i], costs[i]);
}

// Runs the benchmarks; then, of those that were run, sets both rasterizers of alias models side by side, by
// size, with what the article tells of Quake's own: affine was about 20 percent slower over a whole model,
// and more than 50 percent in drawing alone ("Quake's Triangle Models", in Michael Abrash's Graphics
// Programming Black Book).
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace temblor::bench {
namespace {

// Nanoseconds by name; also passes everything on to the console.
class KeepingReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (!run.error_occurred)
        times_ns_[run.benchmark_name()] =
            run.real_accumulated_time * 1e9 / static_cast<double>(run.iterations);
  }
  const std::map<std::string, double>& times_ns() const { return times_ns_; }

 private:
  std::map<std::string, double> times_ns_;
};

struct Comparison {
  const char* title;
  const char* size_unit;
  double units_per_argument;
  const char *affine, *subdivision;  // names, the argument left out
  const char* article;
  std::vector<int> arguments;
};

void print(const Comparison& comparison, const std::map<std::string, double>& times_ns) {
  bool titled = false;
  for (const int argument : comparison.arguments) {
    const auto affine = times_ns.find(comparison.affine + std::to_string(argument));
    const auto subdivision = times_ns.find(comparison.subdivision + std::to_string(argument));
    if (affine == times_ns.end() || subdivision == times_ns.end()) continue;
    if (!titled)
      std::printf("\n| %s: %s | affine is slower by | article |\n| --- | --- | --- |\n", comparison.title,
                  comparison.size_unit);
    titled = true;
    std::printf("| %g | %.0f %% | %s |\n", argument * comparison.units_per_argument,
                100 * (affine->second / subdivision->second - 1), comparison.article);
  }
}

}  // namespace
}  // namespace temblor::bench

int main(int count, char** arguments) {
  using temblor::bench::Comparison;
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  temblor::bench::KeepingReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  const std::vector<int> sides = {5, 7, 10, 15, 20, 30, 60, 91}, areas = {1, 2, 3, 4, 8, 16, 32, 64, 128};
  for (const Comparison& comparison : {
           Comparison{"whole models, indexed", "mean side in pixels", 0.1, "models/indexed/affine/",
                      "models/indexed/subdivision/", "20 %", sides},
           Comparison{"whole models, rgb", "mean side in pixels", 0.1, "models/rgb/affine/",
                      "models/rgb/subdivision/", "20 %", sides},
           Comparison{"drawing alone, indexed", "area in pixels", 1, "triangles/indexed/affine/vector/",
                      "triangles/indexed/subdivision/", "50 %", areas},
           Comparison{"drawing alone, rgb", "area in pixels", 1, "triangles/rgb/affine/vector/",
                      "triangles/rgb/subdivision/", "50 %", areas},
       })
    print(comparison, reporter.times_ns());
}

// Runs the benchmarks. At the end, it compares both rasterizers of alias models by triangle size. In Quake,
// affine drawing was about 20 percent slower over a whole model and more than 50 percent slower in drawing
// alone (Michael Abrash, "Graphics Programming Black Book", 1997, "Quake's Triangle Models").
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace temblor::bench {
namespace {

// Collects nanoseconds by name, and forwards everything to the console.
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
  const char *affine, *subdivision;  // names without the argument
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

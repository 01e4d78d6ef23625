#include "app/compile/compile_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <system_error>

#include "app/files/diagnostics.h"
#include "compiler/stock_limits.h"
#include "formats/levels/bsp.h"

namespace temblor::app {

// A map may have thousands of equal warnings, so show the first three of each kind and count the rest.
void print_warnings(const compiler::Warnings& warnings) {
  std::map<std::string, std::vector<const compiler::Warning*>> by_kind;
  for (const compiler::Warning& warning : warnings) by_kind[warning.kind].push_back(&warning);
  constexpr std::size_t kMaxShown = 3;
  for (const auto& [kind, group] : by_kind) {
    std::string line = fmt::format("{} ({})", kind, group.size());
    for (std::size_t i = 0; i < std::min(group.size(), kMaxShown); ++i)
      line += fmt::format("{} {}", i == 0 ? ":" : ";", group[i]->what);
    if (group.size() > kMaxShown) line += "; ...";
    print_note(line);
  }
}

std::string describe_leak(const compiler::LeakPath& leak) {
  const math::Vec3d &inside = leak.points_world.front(), &outside = leak.points_world.back();
  return fmt::format(
      "the level leaks, so it has no visibility: entity {} ({}) at {:g} {:g} {:g}, line {} of the map, can "
      "reach the outside at {:.0f} {:.0f} {:.0f}",
      leak.entity, leak.classname, inside.x, inside.y, inside.z, leak.line, outside.x, outside.y, outside.z);
}

// The path itself is in the files; the message says where it starts and how to see it.
void print_leak(const compiler::LeakPath& leak, const LevelPaths& paths) {
  print_note(fmt::format("{}; {} and {} show the path", describe_leak(leak), paths.points.string(),
                         paths.leak_picture.string()));
}

void print_summary(const compiler::Build& build, const compiler::CompileReport& report,
                   const LevelPaths& paths) {
  const formats::Bsp& bsp = build.bsp;
  std::error_code ignored;
  fmt::print("{}: {} bytes, version {}\n", paths.bsp.string(), std::filesystem::file_size(paths.bsp, ignored),
             formats::version_name(bsp.version));
  for (const compiler::PartCount& part : compiler::count_parts(bsp))
    fmt::print("  {:<20} {:>8} of {}{}\n", part.what, part.count, part.limit,
               part.is_exceeded() ? "  exceeds the original engine's limit" : "");
  if (build.mean_visible_share)
    fmt::print("  average visible leaves {:.1f} %\n", *build.mean_visible_share * 100);
  for (const compiler::StageTime& time : report.times) {
    if (time.wall_s)
      fmt::print("  {:<20} {:>8.2f} s\n", time.name, *time.wall_s);
    else
      fmt::print("  {:<20} unchanged\n", time.name);
  }
}

void print_times(const compiler::CompileReport& report, const LevelPaths& paths) {
  std::string stages;
  double sum_s = 0;
  for (const compiler::StageTime& time : report.times) {
    stages += fmt::format("{}{} {}", stages.empty() ? "" : ", ", time.name,
                          time.wall_s ? fmt::format("{:.2f} s", *time.wall_s) : "unchanged");
    sum_s += time.wall_s.value_or(0);
  }
  fmt::print("{}: {:.2f} s ({})\n", paths.bsp.string(), sum_s, stages);
  std::fflush(stdout);
}

}  // namespace temblor::app

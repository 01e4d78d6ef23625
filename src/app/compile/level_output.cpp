#include "app/compile/level_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "app/compile/leak_picture.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "compiler/build_file.h"
#include "compiler/portal_file.h"
#include "formats/bspx/light_directions.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"
#include "formats/levels/prt.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Reads a file; empty if it cannot be read.
base::ByteVector read_file_or_empty(const fs::path& path) {
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(path);
  return bytes.ok() ? std::move(bytes).value() : base::ByteVector{};
}

// Between two corners of a leak's path.
constexpr double kMaxPathParts = 10'000;

// Formats a .pts file: one point per line, from the entity to the outside.
base::ByteVector format_leak_points(const compiler::LeakPath& leak) {
  std::string text;
  for (const math::Vec3d& point : leak.points_world)
    text += fmt::format("{:.2f} {:.2f} {:.2f}\n", point.x, point.y, point.z);
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
}

base::ByteVector format_portals(const compiler::Build& build) {
  const auto visible_leaves = static_cast<std::size_t>(build.bsp.models.front().visible_leaves);
  const std::string text = formats::write_prt(compiler::make_portal_file(build.portals, visible_leaves));
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
}

// Colored light that looks like the gray light of a level.
formats::Lit make_white_lit(const formats::Bsp& bsp) {
  formats::Lit lit;
  for (const std::uint8_t sample : bsp.lighting) lit.samples.insert(lit.samples.end(), 3, sample);
  return lit;
}

// Returns a change that writes the bytes, or removes the file if there are none.
base::Result<FileChange> prepare_change(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  if (bytes) return FileChange::replacement(path, *bytes);
  return FileChange::removal(path);
}

base::Status replace_or_remove(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  TRY(FileChange change, prepare_change(path, bytes));
  return change.commit();
}

}  // namespace

std::vector<math::Vec3d> space_points(const std::vector<math::Vec3d>& corners, double step) {
  std::vector<math::Vec3d> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points.push_back(corners[i]);
    if (i + 1 == corners.size()) break;
    const math::Vec3d way = corners[i + 1] - corners[i];
    const double parts = std::ceil(std::min(glm::length(way) / step, kMaxPathParts));
    for (double part = 1; part < parts; ++part) points.push_back(corners[i] + way * (part / parts));
  }
  return points;
}

LevelPaths make_level_paths(const fs::path& bsp) {
  const auto with = [&](const char* ending) { return fs::path(bsp).replace_extension(ending); };
  return {bsp,          with(".lit"),   with(".lux"),       with(".pts"), with(".leak.png"),
          with(".prt"), with(".build"), with(".visibility")};
}

// A build file is only an optimization, so one that cannot be read is a note. It is valid only together with
// the level and .lit that were written with it; if another program has changed them, the build is empty.
compiler::Build read_build_file(const LevelPaths& paths) {
  compiler::Build build;
  if (const base::ByteVector bytes = read_file_or_empty(paths.build); !bytes.empty()) {
    const base::ByteVector bsp = read_file_or_empty(paths.bsp), lit = read_file_or_empty(paths.lit);
    base::Result<compiler::Build> read = compiler::read_build(bytes, {bsp, lit});
    if (read.ok())
      build = std::move(read).value();
    else
      print_note(
          fmt::format("{}: ignored, everything is rebuilt: {}", paths.build.string(), read.error().what));
  }
  build.visibility_state = read_file_or_empty(paths.visibility);
  return build;
}

base::Result<PreparedLevel> prepare_level(const compiler::Build& build,
                                          const std::optional<compiler::LeakPath>& leak,
                                          const LevelPaths& paths, const SideFiles& wanted) {
  PreparedLevel level;
  TRY(level.bsp, formats::write_bsp(build.bsp, build.bsp.version).with_file(paths.bsp.string()));
  TRY(FileChange bsp_change, FileChange::replacement(paths.bsp, level.bsp));
  std::error_code ignored;
  // A device such as /dev/null: write nothing beside it.
  if (fs::is_other(paths.bsp, ignored)) {
    level.steps.push_back(std::move(bsp_change));
    return level;
  }
  std::optional<base::ByteVector> points, picture;
  // Version 30 has its colors in the .bsp.
  if (build.bsp.version != formats::BspVersion::k30) {
    if (build.lit) level.lit = formats::write_lit(*build.lit);
    if (!build.lit && wanted.lit && !build.bsp.lighting.empty())
      level.lit = formats::write_lit(make_white_lit(build.bsp));
  }
  TRY(const std::vector<std::uint8_t> directions, formats::read_light_directions(build.bsp));
  if (!directions.empty()) level.lux = formats::write_lux(directions);
  if (leak) {
    points = format_leak_points(*leak);
    TRY(picture, draw_leak(build.bsp, leak->points_world).with_file(paths.leak_picture.string()));
  }
  if (wanted.leak) {
    TRY(FileChange points_change, prepare_change(paths.points, points));
    TRY(FileChange picture_change, prepare_change(paths.leak_picture, picture));
    level.steps.push_back(std::move(points_change));
    level.steps.push_back(std::move(picture_change));
  }
  if (wanted.portals) {
    std::optional<base::ByteVector> portals;
    if (!leak) portals = format_portals(build);
    TRY(FileChange portals_change, prepare_change(paths.portals, portals));
    level.steps.push_back(std::move(portals_change));
  }
  // Unchanged light stays where it is. New files are removed first and added last, as the header explains.
  std::vector<FileChange> additions;
  for (const auto& [path, bytes] : {std::pair{&paths.lit, &level.lit}, std::pair{&paths.lux, &level.lux}}) {
    if (bytes->value_or(base::ByteVector{}) == read_file_or_empty(*path)) continue;
    level.steps.push_back(FileChange::removal(*path, bytes->has_value()));
    if (!bytes->has_value()) continue;
    TRY(FileChange addition, FileChange::replacement(*path, **bytes));
    additions.push_back(std::move(addition));
  }
  level.steps.push_back(std::move(bsp_change));
  for (FileChange& addition : additions) level.steps.push_back(std::move(addition));
  return level;
}

base::Status write_level(const compiler::Build& build, const std::optional<compiler::LeakPath>& leak,
                         const LevelPaths& paths, const SideFiles& wanted) {
  TRY(PreparedLevel level, prepare_level(build, leak, paths, wanted));
  for (FileChange& step : level.steps) TRY_STATUS(step.commit());
  std::error_code ignored;
  if (fs::is_other(paths.bsp, ignored)) return base::Ok{};
  std::optional<base::ByteVector> beside, begun;
  if (wanted.build)
    beside = compiler::write_build(build, {level.bsp, level.lit.value_or(base::ByteVector{})});
  // The level is complete without the build file, so a failure is only a note.
  if (const base::Status kept = replace_or_remove(paths.build, beside); !kept.ok())
    print_note(fmt::format("the next run will rebuild everything: {}", kept.error().message()));
  if (wanted.build && !build.visibility_state.empty()) begun = build.visibility_state;
  return replace_or_remove(paths.visibility, begun);
}

base::Status write_partial_visibility(base::Bytes visibility_state, const LevelPaths& paths) {
  return replace_file(paths.visibility, visibility_state);
}

}  // namespace temblor::app

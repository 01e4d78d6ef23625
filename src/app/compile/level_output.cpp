#include "app/compile/level_output.h"

#include <fmt/format.h>

#include <string>
#include <system_error>
#include <utility>

#include "app/compile/leak_picture.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "compiler/build_file.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Nothing where there is no such file.
base::ByteVector bytes_of(const fs::path& path) {
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(path);
  return bytes.ok() ? std::move(bytes).value() : base::ByteVector{};
}

base::ByteVector points_of(const compiler::LeakPath& leak) {
  std::string text;
  for (const math::Vec3d& point : leak.points_world)
    text += fmt::format("{:.2f} {:.2f} {:.2f}\n", point.x, point.y, point.z);
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
}

base::Result<FileChange> change_of(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  if (bytes) return FileChange::replacement(path, *bytes);
  return FileChange::removal(path);
}

base::Status replace_or_remove(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  TRY(FileChange change, change_of(path, bytes));
  return change.put_in_place();
}

}  // namespace

LevelPaths level_paths(const fs::path& bsp) {
  const auto with = [&](const char* ending) { return fs::path(bsp).replace_extension(ending); };
  return {bsp, with(".lit"), with(".pts"), with(".leak.png"), with(".build"), with(".visibility")};
}

compiler::Build read_build_file(const LevelPaths& paths) {
  compiler::Build build;
  if (const base::ByteVector bytes = bytes_of(paths.build); !bytes.empty()) {
    const base::ByteVector bsp = bytes_of(paths.bsp), lit = bytes_of(paths.lit);
    base::Result<compiler::Build> read = compiler::read_build(bytes, {bsp, lit});
    if (read.ok())
      build = std::move(read).value();
    else
      print_note(fmt::format("{}: everything is made anew: {}", paths.build.string(), read.error().what));
  }
  build.visibility_state = bytes_of(paths.visibility);
  return build;
}

base::Result<PreparedLevel> prepare_level(const compiler::Build& build,
                                          const std::optional<compiler::LeakPath>& leak,
                                          const LevelPaths& paths) {
  PreparedLevel level;
  TRY(level.bsp, formats::write_bsp(build.bsp, build.bsp.version).with_file(paths.bsp.string()));
  TRY(FileChange bsp_change, FileChange::replacement(paths.bsp, level.bsp));
  std::error_code ignored;
  if (fs::is_other(paths.bsp, ignored)) {  // beside a device lie other devices
    level.steps.push_back(std::move(bsp_change));
    return level;
  }
  std::optional<base::ByteVector> points, picture;
  if (build.lit) level.lit = formats::write_lit(*build.lit);
  if (leak) {
    points = points_of(*leak);
    TRY(picture, draw_leak(build.bsp, leak->points_world).with_file(paths.leak_picture.string()));
  }
  TRY(FileChange points_change, change_of(paths.points, points));
  TRY(FileChange picture_change, change_of(paths.leak_picture, picture));
  level.steps.push_back(std::move(points_change));
  level.steps.push_back(std::move(picture_change));
  const bool has_new_colors = level.lit.value_or(base::ByteVector{}) != bytes_of(paths.lit);
  if (has_new_colors) level.steps.push_back(FileChange::removal(paths.lit, level.lit.has_value()));
  level.steps.push_back(std::move(bsp_change));
  if (has_new_colors && level.lit) {
    TRY(FileChange lit_change, FileChange::replacement(paths.lit, *level.lit));
    level.steps.push_back(std::move(lit_change));
  }
  return level;
}

base::Status write_level(const compiler::Build& build, const std::optional<compiler::LeakPath>& leak,
                         const LevelPaths& paths, bool keep) {
  TRY(PreparedLevel level, prepare_level(build, leak, paths));
  for (FileChange& step : level.steps) TRY_STATUS(step.put_in_place());
  std::error_code ignored;
  if (fs::is_other(paths.bsp, ignored)) return base::Ok{};
  std::optional<base::ByteVector> beside, begun;
  if (keep) beside = compiler::write_build(build, {level.bsp, level.lit.value_or(base::ByteVector{})});
  // The level is whole without it.
  if (const base::Status kept = replace_or_remove(paths.build, beside); !kept.ok())
    print_note(fmt::format("the next run makes everything anew: {}", kept.error().message()));
  if (keep && !build.visibility_state.empty()) begun = build.visibility_state;
  return replace_or_remove(paths.visibility, begun);
}

base::Status write_visibility_begun(base::Bytes visibility_state, const LevelPaths& paths) {
  return replace_file(paths.visibility, visibility_state);
}

}  // namespace temblor::app

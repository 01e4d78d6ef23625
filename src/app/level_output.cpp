#include "app/level_output.h"

#include <fmt/format.h>

#include <string>
#include <system_error>
#include <utility>

#include "app/diagnostics.h"
#include "app/leak_picture.h"
#include "app/written_file.h"
#include "compiler/build_file.h"
#include "formats/bsp.h"
#include "formats/lit.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Nothing where there is no such file.
base::ByteVector bytes_of(const fs::path& path) {
  base::Result<base::ByteVector> bytes = vfs::read_disk_file(path);
  return bytes.ok() ? std::move(bytes).value() : base::ByteVector{};
}

base::ByteVector points_of(const compiler::LeakWay& leak) {
  std::string text;
  for (const math::Vec3d& point : leak.points_world)
    text += fmt::format("{:.2f} {:.2f} {:.2f}\n", point.x, point.y, point.z);
  const base::Bytes bytes = base::as_bytes(text);
  return {bytes.begin(), bytes.end()};
}

base::Status replace_or_remove(const fs::path& path, const std::optional<base::ByteVector>& bytes) {
  if (bytes) return replace_file(path, *bytes);
  std::error_code ignored;
  fs::remove(path, ignored);
  return base::Ok{};
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

base::Status write_level(const compiler::Build& build, const std::optional<compiler::LeakWay>& leak,
                         const LevelPaths& paths, bool keep) {
  TRY(const base::ByteVector bsp,
      formats::write_bsp(build.bsp, build.bsp.version).with_file(paths.bsp.string()));
  TRY_STATUS(replace_file(paths.bsp, bsp));
  std::error_code ignored;
  if (fs::is_other(paths.bsp, ignored)) return base::Ok{};  // beside a device lie other devices
  std::optional<base::ByteVector> lit, points, picture, beside;
  if (build.lit) lit = formats::write_lit(*build.lit);
  TRY_STATUS(replace_or_remove(paths.lit, lit));
  if (leak) {
    points = points_of(*leak);
    TRY(picture, draw_leak(build.bsp, leak->points_world).with_file(paths.leak_picture.string()));
  }
  TRY_STATUS(replace_or_remove(paths.points, points));
  TRY_STATUS(replace_or_remove(paths.leak_picture, picture));
  if (keep) beside = compiler::write_build(build, {bsp, lit.value_or(base::ByteVector{})});
  // The level is whole without it.
  if (const base::Status kept = replace_or_remove(paths.build, beside); !kept.ok())
    print_note(fmt::format("the next run makes everything anew: {}", kept.error().message()));
  std::optional<base::ByteVector> begun;
  if (keep && !build.visibility_state.empty()) begun = build.visibility_state;
  return replace_or_remove(paths.visibility, begun);
}

base::Status write_visibility_begun(base::Bytes visibility_state, const LevelPaths& paths) {
  return replace_file(paths.visibility, visibility_state);
}

}  // namespace temblor::app

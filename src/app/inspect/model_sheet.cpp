#include "app/inspect/model_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>

#include "app/files/diagnostics.h"
#include "app/files/picture_file.h"
#include "app/inspect/sheet_model.h"
#include "artgen/palette.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "compiler/compile_level.h"
#include "formats/archives/wad.h"
#include "formats/images/nearest_color.h"
#include "formats/images/palette.h"
#include "formats/images/wad_texture.h"
#include "formats/levels/map.h"
#include "math/angles.h"
#include "render/renderer.h"
#include "vfs/disk.h"
#include "world/level.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr std::size_t kDefaultFrames = 8;
// Narrow, so that perspective distorts the model little.
constexpr float kFovDeg = 30;
// A cell shows this much more than the model's box.
constexpr double kMargin = 1.05;
// Maximum side of the sheet.
constexpr std::size_t kMaxSide_px = 16384;
constexpr double kRoomSide = 3072, kRoomHeight = 1536, kWall_units = 16;

// The direction of the camera. Models face yaw 0, so a camera in front of them looks at yaw 180.
struct View {
  std::string_view name;
  float pitch_deg, yaw_deg;
};
constexpr std::array<View, 5> kViews = {
    {{"front", 8, 180}, {"side", 8, -90}, {"back", 8, 0}, {"above", 60, 180}, {"quarter", 15, 215}}};
constexpr std::string_view kHandView = "hand";

// Makes a texture of 32-texel tiles, which show distances on the floor; or of one color if both are the same.
// The colors are dark so that they do not outshine the model.
base::Result<base::ByteVector> make_texture_lump(const formats::Palette& palette, const std::string& name,
                                                 formats::Rgb first, formats::Rgb second) {
  constexpr std::uint32_t kSide = 64, kTile = 32;
  const formats::NearestColor nearest(palette, 0, formats::kFirstFullbright);
  const std::array<std::uint8_t, 2> colors = {nearest.find(first), nearest.find(second)};
  formats::WadTexture texture;
  texture.name = name;
  texture.width = texture.height = kSide;
  for (std::uint32_t level = 0; level < texture.mips.size(); ++level)
    for (std::uint32_t y = 0; y < kSide; y += 1u << level)
      for (std::uint32_t x = 0; x < kSide; x += 1u << level)
        texture.mips[level].push_back(colors[(x / kTile + y / kTile) % 2]);
  return formats::write_wad_texture(texture);
}

// Returns a WAD with the textures of floor and walls.
base::Result<base::ByteVector> make_studio_textures(const formats::Palette& palette) {
  TRY(base::ByteVector floor, make_texture_lump(palette, "floor", {104, 106, 110}, {124, 126, 130}));
  TRY(base::ByteVector wall, make_texture_lump(palette, "wall", {70, 72, 78}, {70, 72, 78}));
  std::vector<formats::WadLump> lumps;
  lumps.push_back({"floor", formats::kWadTexture, std::move(floor)});
  lumps.push_back({"wall", formats::kWadTexture, std::move(wall)});
  return formats::write_wad(lumps);
}

// Returns the map text of an axis-aligned brush: six planes, each given by three points.
std::string make_brush_text(const math::Vec3d& mins, const math::Vec3d& maxs, std::string_view texture) {
  const auto plane = [&](const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c) {
    return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) {} 0 0 0 1 1\n", a.x, a.y, a.z, b.x, b.y, b.z,
                       c.x, c.y, c.z, texture);
  };
  const math::Vec3d x(maxs.x - mins.x, 0, 0), y(0, maxs.y - mins.y, 0), z(0, 0, maxs.z - mins.z);
  return "{\n" + plane(mins, mins + y, mins + z) + plane(mins, mins + z, mins + x) +
         plane(mins, mins + x, mins + y) + plane(maxs, maxs - z, maxs - y) + plane(maxs, maxs - x, maxs - z) +
         plane(maxs, maxs - y, maxs - x) + "}\n";
}

// The compilation takes a fraction of a second, so it shows no progress and cannot be interrupted.
class StudioWatcher : public compiler::CompileWatcher {};

// Compiles a wide room with its floor at z = 0 and the same light (0 to 255) everywhere, so that models are
// lit by the same code as in the game.
base::Result<std::shared_ptr<const world::Level>> make_studio(const formats::Palette& palette, int light,
                                                              base::Jobs& jobs) {
  std::string text = "{\n\"classname\" \"worldspawn\"\n";
  text += fmt::format("\"light\" \"{}\"\n", light);
  const double half = kRoomSide / 2;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      math::Vec3d low(-half - kWall_units, -half - kWall_units, -kWall_units),
          high(half + kWall_units, half + kWall_units, kRoomHeight + kWall_units);
      (upper ? low : high)[axis] = upper ? high[axis] - kWall_units : low[axis] + kWall_units;
      text += make_brush_text(low, high, axis == 2 && !upper ? "floor" : "wall");
    }
  }
  text += "}\n{\n\"classname\" \"info_player_start\"\n\"origin\" \"0 0 32\"\n}\n";
  TRY(const formats::Map map, formats::read_map(text));
  compiler::CompileOptions options;
  options.visibility_policy = compiler::StagePolicy::kSkip;
  compiler::Build build;
  compiler::Warnings warnings;
  TRY(const base::ByteVector textures, make_studio_textures(palette));
  const compiler::TextureSource source{"studio.wad", textures};
  StudioWatcher watcher;
  TRY_STATUS(
      compiler::compile_level({map, {&source, 1}, palette}, options, {jobs, watcher, warnings}, build));
  return world::make_level(std::move(build.bsp), "studio");
}

// Returns gfx/palette.lmp of the game directory that contains progs/MODEL.mdl; Temblor's own palette if there
// is none.
formats::Palette load_palette(const std::filesystem::path& model_file) {
  const std::filesystem::path file = model_file.parent_path().parent_path() / "gfx" / "palette.lmp";
  const base::Result<base::ByteVector> bytes = vfs::read_disk_file(file);
  if (bytes.ok())
    if (const auto palette = formats::read_palette(*bytes); palette.ok()) return *palette;
  return artgen::make_palette();
}

// Empty parts, as in "a,,b", are kept; a comma at the end adds none.
std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// Finds a frame by number, otherwise by name.
base::Result<std::uint32_t> find_frame(const std::vector<SheetFrame>& all, const std::string& text) {
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure == std::errc() && end == text.data() + text.size() && number < all.size()) return number;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].name.empty() && base::equal_ignoring_case(all[i].name, text))
      return static_cast<std::uint32_t>(i);
  return base::error(ErrorCode::kUsage,
                     "--frames: unknown frame \"{}\"; the model has frames 0 to {}, named {} to {}",
                     base::quotable(text), all.size() - 1, base::quotable(all.front().name),
                     base::quotable(all.back().name));
}

// Returns the frames in the order of the text; for an empty text up to eight, evenly spaced.
base::Result<std::vector<std::uint32_t>> parse_frames(const std::vector<SheetFrame>& all,
                                                      const std::string& text) {
  std::vector<std::uint32_t> frames;
  for (const std::string& part : split_at_commas(text)) {
    TRY(const std::uint32_t frame, find_frame(all, part));
    frames.push_back(frame);
  }
  if (!frames.empty()) return frames;
  const std::size_t count = std::min(kDefaultFrames, all.size());
  for (std::size_t i = 0; i < count; ++i)
    frames.push_back(static_cast<std::uint32_t>(i * all.size() / count));
  return frames;
}

// Everything that the cells of a sheet share.
struct Studio {
  std::shared_ptr<const world::Level> level;
  std::shared_ptr<const render::AliasModel> model;
  formats::Palette palette;
  // Added to the model's origin, so that it stands on the floor.
  math::Vec3 lift{0.0f};
  // Boxes of the frames that are shown, in the model's space. All cells of a view use the same camera, so
  // that sizes can be compared.
  std::vector<math::Bounds> boxes;
};

Studio begin_studio(const SheetModel& sheet_model, const std::vector<std::uint32_t>& frames) {
  Studio studio;
  studio.model = sheet_model.model;
  // A model is lit at its origin, so lift it until the origin is above the floor.
  studio.lift.z = std::max(1.0f, -sheet_model.frames.front().box.mins.z);
  for (const std::uint32_t frame : frames) studio.boxes.push_back(sheet_model.frames[frame].box);
  return studio;
}

// The contents of one cell.
struct Shot {
  std::uint32_t frame = 0, skin = 0;
  std::string view;
};

// Returns the nearest camera position from which every box fits the square cell. For each corner, the
// distance along the view direction must be at least its distance from the axis divided by the slope of the
// frustum.
math::Vec3 place_camera(const std::vector<math::Bounds>& boxes, const math::Vec3& angles_deg) {
  math::Bounds all = boxes.front();
  for (const math::Bounds& box : boxes) all = {glm::min(all.mins, box.mins), glm::max(all.maxs, box.maxs)};
  const math::Vec3d middle(0.5f * (all.mins + all.maxs));
  const math::Basis basis = math::basis_from_angles(angles_deg);
  const double slope = std::tan(0.5 * kFovDeg * std::numbers::pi / 180) / kMargin;
  double back = 1;
  for (const math::Bounds& box : boxes) {
    for (int corner = 0; corner < 8; ++corner) {
      const math::Vec3d place((corner & 1) != 0 ? box.maxs.x : box.mins.x,
                              (corner & 2) != 0 ? box.maxs.y : box.mins.y,
                              (corner & 4) != 0 ? box.maxs.z : box.mins.z);
      const math::Vec3d offset = place - middle;
      const double aside =
          std::max(std::abs(glm::dot(offset, basis.right)), std::abs(glm::dot(offset, basis.up)));
      back = std::max(back, aside / slope - glm::dot(offset, basis.forward));
    }
  }
  return math::Vec3(middle - basis.forward * back);
}

// Draws a cell: as the view weapon through the player's camera, or standing in the room.
void draw_cell(const Studio& studio, const Shot& shot, render::Renderer& renderer,
               render::FrameBuffer& out_picture) {
  render::AliasInstance instance;
  instance.model = studio.model.get();
  instance.from_pose = instance.to_pose = render::pose_at(*studio.model, shot.frame, 0);
  instance.skin = render::skin_at(*studio.model, shot.skin, 0);
  render::Scene scene;
  scene.level = studio.level.get();
  if (shot.view == kHandView) {
    scene.camera.origin_world = instance.origin_world = {0, 0, 56};
    scene.view_weapon = &instance;
  } else {
    const auto* const view =
        std::find_if(kViews.begin(), kViews.end(), [&](const View& v) { return v.name == shot.view; });
    instance.origin_world = studio.lift;
    scene.camera.angles_deg = {view->pitch_deg, view->yaw_deg, 0};
    scene.camera.fov_deg = kFovDeg;
    scene.camera.origin_world = studio.lift + place_camera(studio.boxes, scene.camera.angles_deg);
    scene.alias_models = {&instance, 1};
  }
  renderer.render(scene, {}, out_picture);
}

// Returns an error for an unknown view, before anything is drawn.
base::Status check_views(const std::vector<std::string>& views) {
  for (const std::string& view : views) {
    if (view == kHandView ||
        std::any_of(kViews.begin(), kViews.end(), [&](const View& known) { return known.name == view; }))
      continue;
    return base::error(ErrorCode::kUsage,
                       "--views: unknown view \"{}\"; choose from front, side, back, above, quarter, hand",
                       base::quotable(view));
  }
  if (views.empty()) return base::error(ErrorCode::kUsage, "--views: name at least one view");
  return base::Ok{};
}

// Layout of one view's cells. With several views, each has one row; a single view is wrapped to about 3:2.
struct Grid {
  int columns = 1, rows_per_view = 1;
};

// Returns an error if the sheet would be too large.
base::Result<Grid> choose_grid(std::size_t frames, std::size_t views, const SheetOptions& options) {
  const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(frames) * 1.5)));
  const std::size_t columns = views > 1 ? frames : std::min(frames, square);
  const std::size_t rows_per_view = (frames + columns - 1) / columns;
  const auto cell = static_cast<std::size_t>(options.cell_px);
  if (std::max(columns, rows_per_view * views) * cell > kMaxSide_px)
    return base::error(
        ErrorCode::kUsage,
        "--frames, --views, --cell: the picture would be {} x {} pixels; the maximum side is {}",
        columns * cell, rows_per_view * views * cell, kMaxSide_px);
  return Grid{static_cast<int>(columns), static_cast<int>(rows_per_view)};
}

// Copies a cell into the sheet at that position.
void copy_into(const render::FrameBuffer& picture, int left, int top, render::FrameBuffer& io_sheet) {
  for (int row = 0; row < picture.height(); ++row) {
    const auto from = picture.rgb().begin() + std::ptrdiff_t{row} * picture.width();
    std::copy(from, from + picture.width(),
              io_sheet.rgb().begin() + std::ptrdiff_t{top + row} * io_sheet.width() + left);
  }
}

}  // namespace

// Draws cell by cell into one small frame and copies it into the sheet, whose rows are the views.
base::Status draw_model_sheet(const std::filesystem::path& model_file, const SheetOptions& options) {
  std::vector<std::string> notes;
  TRY(const SheetModel sheet_model, read_sheet_model(model_file, notes));
  for (const std::string& note : notes) print_note(note);
  TRY(const std::vector<std::uint32_t> frames, parse_frames(sheet_model.frames, options.frames));
  const std::vector<std::string> views = split_at_commas(options.views);
  TRY_STATUS(check_views(views));
  TRY(const Grid grid, choose_grid(frames.size(), views.size(), options));
  base::Jobs jobs(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  Studio studio = begin_studio(sheet_model, frames);
  studio.palette = load_palette(model_file);
  TRY(studio.level, make_studio(studio.palette, options.light, jobs));

  const auto count = static_cast<int>(frames.size());
  const auto [columns, rows_per_view] = grid;
  const int cell = options.cell_px;
  render::FrameBuffer sheet(columns * cell, rows_per_view * cell * static_cast<int>(views.size()),
                            render::PixelFormat::kRgb);
  std::fill(sheet.rgb().begin(), sheet.rgb().end(), 0xff000000u);
  render::FrameBuffer picture(cell, cell, render::PixelFormat::kRgb);
  render::Renderer renderer(studio.palette, formats::make_colormap(studio.palette));
  for (int view = 0; view < static_cast<int>(views.size()); ++view) {
    for (int i = 0; i < count; ++i) {
      const auto index = static_cast<std::size_t>(i);
      draw_cell(
          studio,
          {frames[index], static_cast<std::uint32_t>(options.skin), views[static_cast<std::size_t>(view)]},
          renderer, picture);
      copy_into(picture, i % columns * cell, (view * rows_per_view + i / columns) * cell, sheet);
    }
  }
  return write_picture_file(options.out, sheet, studio.palette);
}

}  // namespace temblor::app

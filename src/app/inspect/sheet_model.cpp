#include "app/inspect/sheet_model.h"

#include <fmt/format.h>

#include "assets/posed_models.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

math::Bounds find_box(const std::vector<math::Vec3>& positions) {
  math::Bounds box{math::Vec3(1e9f), math::Vec3(-1e9f)};
  for (const math::Vec3& position : positions) {
    box.mins = glm::min(box.mins, position);
    box.maxs = glm::max(box.maxs, position);
  }
  return box;
}

std::vector<SheetFrame> list_frames(const formats::Mdl& mdl) {
  std::vector<SheetFrame> frames;
  for (const formats::MdlFrame& frame : mdl.frames) {
    std::vector<math::Vec3> positions;
    for (const formats::MdlVertex& vertex : frame.poses.front().vertices)
      positions.push_back(mdl.scale * math::Vec3(vertex.position[0], vertex.position[1], vertex.position[2]) +
                          mdl.origin);
    frames.push_back({frame.poses.front().name, find_box(positions)});
  }
  return frames;
}

std::vector<SheetFrame> list_frames(const formats::PosedModel& model) {
  std::vector<SheetFrame> frames;
  for (const formats::PosedFrame& frame : model.frames) {
    std::vector<math::Vec3> positions;
    for (const formats::PosedMesh& mesh : model.meshes) {
      const auto first = mesh.positions.begin() +
                         static_cast<std::ptrdiff_t>(std::size_t{frame.first_pose} * mesh.texels.size());
      positions.insert(positions.end(), first, first + static_cast<std::ptrdiff_t>(mesh.texels.size()));
    }
    frames.push_back({std::string(), find_box(positions)});
  }
  return frames;
}

// Mounts the files of the model's folder as progs/, and the palette of the game directory around it.
vfs::FileSystem mount_folder(const std::filesystem::path& file) {
  vfs::FileSystem files;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    files.mount_file(fmt::format("progs/{}", entry.path().filename().string()), entry.path());
  const std::filesystem::path palette = folder.parent_path() / "gfx" / "palette.lmp";
  if (std::filesystem::exists(palette, ignored)) files.mount_file("gfx/palette.lmp", palette);
  return files;
}

base::Result<SheetModel> read_mdl_file(const std::filesystem::path& file) {
  TRY(const base::ByteVector bytes, vfs::read_disk_file(file));
  TRY(const formats::Mdl mdl, formats::read_mdl(bytes).with_file(file.string()));
  return SheetModel{render::make_alias_model(mdl, file.string()), list_frames(mdl)};
}

}  // namespace

base::Result<SheetModel> read_sheet_model(const std::filesystem::path& file,
                                          std::vector<std::string>& io_notes) {
  if (!assets::is_posed_model(file.string())) return read_mdl_file(file);
  const std::string name = fmt::format("progs/{}", file.filename().string());
  TRY(const formats::PosedModel posed, assets::load_posed_model(mount_folder(file), name, io_notes));
  TRY(auto model, render::make_alias_model(posed, file.string()).with_file(file.string()));
  return SheetModel{std::move(model), list_frames(posed)};
}

}  // namespace temblor::app

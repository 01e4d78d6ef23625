#include "assets/posed_models.h"

#include <fmt/format.h>

#include <algorithm>

#include "assets/models/skins.h"
#include "base/text.h"

namespace temblor::assets {
namespace {

constexpr std::string_view kMd3 = ".md3", kMd5Mesh = ".md5mesh", kMd5Animation = ".md5anim", kMdl = ".mdl";

std::string replace_extension(std::string_view path, std::string_view extension) {
  return fmt::format("{}{}", path.substr(0, path.rfind('.')), extension);
}

base::Result<formats::PosedModel> read_md3_file(const vfs::FileSystem& files, std::string_view path) {
  TRY(const base::ByteVector bytes, files.read(path));
  TRY(const formats::Md3 md3, formats::read_md3(bytes).with_file(files.describe(path)));
  return formats::pose_md3(md3).with_file(files.describe(path));
}

base::Result<formats::PosedModel> read_md5_files(const vfs::FileSystem& files, std::string_view path) {
  const std::string animation_path = replace_extension(path, kMd5Animation);
  TRY(const base::ByteVector mesh_bytes, files.read(path));
  TRY(const base::ByteVector animation_bytes, files.read(animation_path));
  TRY(const formats::Md5Model model,
      formats::read_md5_model(base::as_text(mesh_bytes)).with_file(files.describe(path)));
  TRY(const formats::Md5Animation animation,
      formats::read_md5_animation(base::as_text(animation_bytes)).with_file(files.describe(animation_path)));
  return formats::pose_md5(model, animation).with_file(files.describe(path));
}

base::Result<formats::PosedModel> read_posed_model(const vfs::FileSystem& files, std::string_view path) {
  return base::to_lower(path).ends_with(kMd3) ? read_md3_file(files, path) : read_md5_files(files, path);
}

// Skin groups play at the times of the MDL file, if it has as many pictures.
void take_skin_times(const formats::Mdl& mdl, formats::PosedModel& io_model) {
  for (std::size_t skin = 0; skin < std::min(mdl.skins.size(), io_model.skins.size()); ++skin)
    if (mdl.skins[skin].end_times_s.size() == io_model.skins[skin].pictures.size())
      io_model.skins[skin].end_times_s = mdl.skins[skin].end_times_s;
}

}  // namespace

bool is_posed_model(std::string_view path) {
  const std::string name = base::to_lower(path);
  return name.ends_with(kMd3) || name.ends_with(kMd5Mesh);
}

base::Result<formats::PosedModel> load_posed_model(const vfs::FileSystem& files, std::string_view path,
                                                   std::vector<std::string>& io_notes) {
  TRY(formats::PosedModel model, read_posed_model(files, path));
  std::vector<std::string> problems;
  model.skins = load_skins(files, path, model.meshes, problems);
  for (const std::string& problem : problems)
    io_notes.push_back(fmt::format("{}: {}. A checkerboard is drawn instead", files.describe(path), problem));
  return model;
}

base::Result<std::optional<formats::PosedModel>> load_md5_replacement(const vfs::FileSystem& files,
                                                                      std::string_view path,
                                                                      const formats::Mdl& mdl) {
  using Replacement = std::optional<formats::PosedModel>;
  if (!base::to_lower(path).ends_with(kMdl)) return Replacement();
  const std::string mesh_path = replace_extension(path, kMd5Mesh);
  if (!files.contains(mesh_path) || !files.contains(replace_extension(path, kMd5Animation)) ||
      files.find_game(mesh_path) < files.find_game(path))
    return Replacement();
  TRY(formats::PosedModel model, read_md5_files(files, mesh_path));
  std::vector<std::string> problems;
  model.skins = load_skins(files, mesh_path, model.meshes, problems);
  if (!problems.empty()) {
    base::Error error = base::error(base::ErrorCode::kNotFound, "{}", problems.front());
    error.file = files.describe(mesh_path);
    return error;
  }
  formats::take_frames(mdl, model);
  take_skin_times(mdl, model);
  return Replacement(std::move(model));
}

base::Result<math::Bounds> measure_posed_model(const vfs::FileSystem& files, std::string_view path) {
  TRY(const formats::PosedModel model, read_posed_model(files, path));
  return formats::compute_bounds(model);
}

}  // namespace temblor::assets

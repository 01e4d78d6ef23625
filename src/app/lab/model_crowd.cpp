#include "app/lab/model_crowd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/files/game_files.h"
#include "assets/library.h"
#include "math/angles.h"

namespace temblor::app {
namespace {

constexpr std::array kModelNames = {"progs/ogre.mdl", "progs/zombie.mdl", "progs/soldier.mdl",
                                    "progs/dog.mdl",  "progs/knight.mdl", "progs/armor.mdl"};

constexpr double kTurnPerMoment_deg = 4.5, kStepPerMoment = 5, kPosesPerMoment = 0.5;
// The distance between neighbors, divided by their size.
constexpr double kRoom = 1.05;
// At least, in units: models without an extent have a place, too.
constexpr double kMinPlace = 1;

// Spread evenly over 0 to 1, without a pattern: multiples of the golden ratio.
double spread(std::size_t i, std::size_t series) {
  const double value = static_cast<double>(i + 1) * (0.6180339887498949 + 0.1 * static_cast<double>(series));
  return value - std::floor(value);
}

base::Result<formats::Mdl> load_from_library(const assets::Library& library, const std::string& wanted) {
  if (wanted.empty()) {
    const auto found =
        std::ranges::find_if(kModelNames, [&](const char* name) { return library.files().contains(name); });
    if (found == kModelNames.end()) return make_lumpy_figure();
    return library.alias_model(*found);
  }
  const bool is_path = wanted.find('/') != std::string::npos;
  return library.alias_model(is_path ? wanted : "progs/" + wanted + ".mdl");
}

base::Result<formats::Mdl> load_model(const std::string& wanted, const GameFolders& folders,
                                      const LoadedMap& map) {
  if (map.library != nullptr) return load_from_library(*map.library, wanted);
  if (wanted.empty()) return make_lumpy_figure();
  TRY(vfs::FileSystem files, open_files(folders));
  return load_from_library(assets::Library(std::move(files)), wanted);
}

// The places of one layer, around the middle of the view.
struct Layer {
  double distance;
  std::size_t columns, rows;
};

}  // namespace

base::Result<ModelCrowd> ModelCrowd::load(const CrowdOptions& options, const GameFolders& folders,
                                          const LoadedMap& map) {
  ModelCrowd crowd;
  crowd.options_ = options;
  TRY(const formats::Mdl mdl, load_model(options.model, folders, map));
  crowd.model_ = render::make_alias_model(mdl, options.model.empty() ? "model" : options.model);
  return crowd;
}

const std::string& ModelCrowd::model_name() const {
  return render::model_name(*model_);
}

std::vector<render::AliasInstance> ModelCrowd::place(const render::Camera& camera, int moment) const {
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  const math::Bounds& bounds = render::model_bounds(*model_);
  const math::Vec3d size(bounds.maxs - bounds.mins);
  const math::Vec3d middle = math::Vec3d(bounds.mins + bounds.maxs) * 0.5;
  const double place_width = std::max(kRoom * std::hypot(size.x, size.y), kMinPlace);
  const double place_height = std::max(kRoom * size.z, kMinPlace);
  const double half_view = std::tan(double{camera.fov_deg} * std::numbers::pi / 360);
  const auto make_layer = [&](double distance) {
    const auto fit = [&](double room, double place) {
      return static_cast<std::size_t>(std::max(1.0, std::floor(room / place)));
    };
    return Layer{distance, fit(2 * half_view * distance, place_width),
                 fit(1.5 * half_view * distance, place_height)};
  };
  const auto count = static_cast<std::size_t>(options_.count);
  std::vector<render::AliasInstance> instances;
  Layer layer = make_layer(options_.distance);
  const auto poses = render::frame_count(*model_);
  for (std::size_t i = 0, place = 0, number = 0; i < count; ++i, ++place) {
    if (place == layer.columns * layer.rows) {
      layer = make_layer(layer.distance + place_width);
      place = 0;
      ++number;
    }
    const std::size_t left = count - i + place;  // models that this layer could have
    const std::size_t rows = std::min(layer.rows, (left + layer.columns - 1) / layer.columns);
    const std::size_t columns = std::min(layer.columns, left);
    const double shift = number % 2 == 0 ? 0 : 0.5;
    const auto offset = [](std::size_t at, std::size_t of) {
      return static_cast<double>(at) - 0.5 * static_cast<double>(of - 1);
    };
    const double walked = kStepPerMoment * (moment % 4) * (i % 2 == 0 ? 1 : -1);
    const double right = (offset(place % layer.columns, columns) + shift) * place_width + walked;
    const double up = (offset(place / layer.columns, rows) + shift) * place_height;
    const double yaw_deg = 360 * spread(i, 0) + kTurnPerMoment_deg * moment;

    render::AliasInstance& instance = instances.emplace_back();
    instance.model = model_.get();
    // Turned with the camera, so that all directions show the same picture.
    instance.angles_deg = {0, camera.angles_deg.y + static_cast<float>(yaw_deg), 0};
    const math::Basis turn = math::basis_from_angles(instance.angles_deg);
    const math::Vec3d to_middle = turn.forward * middle.x - turn.right * middle.y + turn.up * middle.z;
    instance.origin_world = math::Vec3(math::Vec3d(camera.origin_world) + axes.forward * layer.distance +
                                       axes.right * right + axes.up * up - to_middle);
    const double pose = spread(i, 1) * poses + kPosesPerMoment * moment;
    const auto from = static_cast<std::uint32_t>(pose);
    instance.from_pose = render::pose_at(*model_, from % poses, 0);
    instance.to_pose = render::pose_at(*model_, (from + 1) % poses, 0);
    instance.blend = static_cast<float>(pose - from);
    instance.skin = render::skin_at(*model_, 0, 0);
    // Places may be inside of walls, where there is no light.
    instance.min_light = 100;
  }
  return instances;
}

}  // namespace temblor::app

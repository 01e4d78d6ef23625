#include "render_gl/model_scenes.h"

#include "math/angles.h"
#include "support/game_data.h"
#include "support/models/drawable_models.h"
#include "support/models/posed_samples.h"
#include "support/pictures/frames.h"

namespace temblor::render_gl {

namespace {

constexpr std::uint32_t kSquareTexels = 8;
constexpr int kOwnTolerance = 8;

formats::MdlSkin make_skin(const formats::Mdl& mdl, std::size_t number) {
  std::vector<std::uint8_t> picture(std::size_t{mdl.skin_width} * mdl.skin_height);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const std::size_t column = i % mdl.skin_width / kSquareTexels, row = i / mdl.skin_width / kSquareTexels;
    picture[i] = static_cast<std::uint8_t>((column * 37 + row * 101 + number * 17) % 250);
  }
  return {{std::move(picture)}, {}};
}

formats::Mdl with_skins(formats::Mdl mdl, std::size_t count, float size) {
  mdl.skins.clear();
  for (std::size_t number = 0; number < count; ++number) mdl.skins.push_back(make_skin(mdl, number));
  mdl.scale *= size / 255;
  mdl.origin *= size / 255;
  return mdl;
}

std::vector<formats::Mdl> make_small_files() {
  constexpr std::size_t kSkins = 3;
  return {with_skins(test::box_mdl(), kSkins, 40), with_skins(test::sphere_mdl(), kSkins, 60),
          with_skins(test::many_pose_mdl(), kSkins, 50)};
}

ModelPtr convert_to_wide(const formats::Mdl& mdl) {
  const formats::Md3 md3 = formats::read_md3(test::write_md3(test::convert_to_md3(mdl, "skin"))).value();
  formats::PosedModel posed = formats::pose_md3(md3).value();
  for (const formats::MdlSkin& skin : mdl.skins)
    posed.skins.push_back({{{{mdl.skin_width, mdl.skin_height, skin.pictures.front()}}}, {}});
  return render::make_alias_model(posed, "wide").value();
}

render::FrameBuffer copy(const render::FrameBuffer& frame) {
  render::FrameBuffer copied(frame.width(), frame.height(), frame.format());
  std::ranges::copy(frame.rgb(), copied.rgb().begin());
  std::ranges::copy(frame.depth(), copied.depth().begin());
  return copied;
}

}  // namespace

render::Scene ModelScene::scene(const world::Level& level) const {
  render::Scene scene = viewpoint.scene(level);
  scene.alias_models = instances;
  scene.view_weapon = weapon ? &*weapon : nullptr;
  scene.fog = fog;
  scene.liquid_alpha = liquid_alpha;
  return scene;
}

std::vector<ModelPtr> make_small_models() {
  std::vector<ModelPtr> models;
  for (const formats::Mdl& mdl : make_small_files()) models.push_back(render::make_alias_model(mdl, "small"));
  return models;
}

std::vector<ModelPtr> make_wide_models() {
  std::vector<ModelPtr> models;
  for (const formats::Mdl& mdl : make_small_files()) models.push_back(convert_to_wide(mdl));
  return models;
}

ModelPtr load_model(const std::filesystem::path& path) {
  return render::make_alias_model(formats::read_mdl(test::read_file(path)).value(), path.filename().string());
}

ModelPtr make_box_with_skins(std::size_t count) {
  return render::make_alias_model(with_skins(test::box_mdl(), count, 40), "box");
}

render::AliasInstance random_instance(const ModelScene& scene, double distance, test::Random& io_random) {
  const render::Camera& camera = scene.viewpoint.camera;
  render::AliasInstance instance;
  instance.model = scene.models[io_random.below(scene.models.size())].get();
  const auto pose = [&] {
    const std::size_t frame = io_random.below(render::frame_count(*instance.model));
    return render::pose_at(*instance.model, static_cast<std::uint32_t>(frame), 0.35);
  };
  instance.from_pose = pose();
  instance.to_pose = pose();
  instance.blend = static_cast<float>(io_random.uniform(0, 1));
  instance.angles_deg = io_random.in_cube(180);
  const std::size_t skin = io_random.below(render::skin_count(*instance.model));
  instance.skin = render::skin_at(*instance.model, static_cast<std::uint32_t>(skin), 0);
  instance.min_light = 60;
  const math::Basis axes = math::basis_from_angles(camera.angles_deg);
  instance.origin_world =
      camera.origin_world + math::Vec3(axes.forward * distance) + io_random.in_cube(distance * 0.5);
  return instance;
}

ModelScene random_scene(std::vector<ModelPtr> models, const world::Level& level, int count,
                        test::Random& io_random) {
  ModelScene scene{.models = std::move(models)};
  scene.viewpoint.camera = test::random_camera(level, io_random);
  scene.viewpoint.brush_models = test::shown_brush_models(level);
  scene.viewpoint.time_s = io_random.uniform(0, 100);
  for (int i = 0; i < count; ++i)
    scene.instances.push_back(random_instance(scene, io_random.log_uniform(100, 600), io_random));
  return scene;
}

ModelShares compare_models(RendererPair& io_pair, const ModelScene& scene, const world::Level& level,
                           const render::Settings& settings) {
  render::Scene empty = scene.scene(level);
  empty.alias_models = {};
  empty.view_weapon = nullptr;
  io_pair.compare(empty, settings);
  const render::FrameBuffer without = copy(io_pair.cpu_frame());
  ModelShares shares;
  shares.whole = io_pair.compare(scene.scene(level), settings);
  const render::FrameBuffer &cpu = io_pair.cpu_frame(), &gl = io_pair.gl_frame();
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < cpu.pixel_count(); ++i) {
    if (cpu.rgb()[i] == without.rgb()[i] && cpu.depth()[i] == without.depth()[i]) continue;
    ++shares.own_pixels;
    agreeing += test::largest_difference(cpu.rgb()[i], gl.rgb()[i]) <= kOwnTolerance;
  }
  if (shares.own_pixels > 0)
    shares.own = static_cast<double>(agreeing) / static_cast<double>(shares.own_pixels);
  return shares;
}

}  // namespace temblor::render_gl

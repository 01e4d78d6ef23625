// Golden pictures of models, sprites, particles, and beams, and of what is drawn over the view.
#include <algorithm>
#include <array>
#include <string_view>

#include "artgen/palette.h"
#include "client/effects/effects.h"
#include "client/hud/hud.h"
#include "client/session/powerups.h"
#include "golden/golden_scenes.h"
#include "golden/golden_stage.h"
#include "support/models/box_models.h"
#include "support/models/drawable_models.h"
#include "support/pictures/small_pictures.h"

namespace temblor::test {
namespace {

std::shared_ptr<const render::AliasModel> drawable(const formats::Mdl& mdl) {
  return render::make_alias_model(mdl, "made in code");
}

// The client's effects of events in a level in which nothing moves.
class EventStage {
 public:
  void advance(const GoldenStage& stage, double time_s, const client::Events& events = {}) {
    effects_.advance(events, {stage.level(), time_s, {}, {}, 0}, {.marks = true});
  }
  const client::Effects& effects() const { return effects_; }
  void put_into(render::Scene& io_scene) const {
    io_scene.particles = effects_.particles();
    io_scene.lights = effects_.lights();
    io_scene.marks = &effects_.marks();
  }

 private:
  client::Effects effects_;
};

// A letter without symmetry, on a clear background; 32 texels around the origin.
formats::Spr letter_f(formats::SprOrientation orientation) {
  constexpr std::array<std::string_view, 8> kRows = {"........", ".######.", ".#......", ".####...",
                                                     ".#......", ".#......", ".#......", "........"};
  constexpr std::uint32_t kSide = 32, kDot = kSide / 8;
  formats::SprPicture picture{-16, 16, kSide, kSide, {}};
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const bool ink = kRows[y / kDot][x / kDot] == '#';
      const bool edge = std::min({x, y, kSide - 1 - x, kSide - 1 - y}) < 2;
      picture.texels.push_back(ink    ? artgen::ramp_color(artgen::Ramp::kFire, 0.6)
                               : edge ? artgen::ramp_color(artgen::Ramp::kElectric, 0.5)
                                      : artgen::kTransparent);
    }
  formats::Spr sprite;
  sprite.orientation = orientation;
  sprite.frames = {{{picture}, {}}};
  return sprite;
}

struct HudArt {
  TemporaryFolder folder;
  assets::Pictures pictures;
  HudArt() {
    write_small_pictures(folder);
    std::vector<std::string> notes;
    pictures = assets::Pictures::load(vfs::FileSystem::open(folder.path()).value(), notes);
    EXPECT_TRUE(notes.empty());
  }
};

void set(client::Game& io_game, client::Stat stat, std::int32_t value) {
  io_game.stats[static_cast<std::size_t>(stat)] = value;
}

void draw_hud(const client::Game& game, double time_s, render::Renderer& io_renderer,
              render::FrameBuffer& io_frame) {
  const HudArt art;
  const client::Hud hud(art.pictures);
  render::DrawList list;
  hud.draw(game, time_s, io_frame.width(), io_frame.height(), {}, list);
  render::FrameStats stats;
  io_renderer.draw_overlay(list, io_frame, stats);
}

}  // namespace

void draw_models_near(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  const auto ball = small_model(sphere_mdl(), 56), box = small_model(box_mdl(), 40);
  const auto walker = drawable(walker_mdl());
  const auto stride = render::pose_at(*walker, 1, 0), pass = render::pose_at(*walker, 2, 0);
  const render::AliasInstance models[] = {
      {.model = ball.get(), .origin_world = {190, 330, 40}, .angles_deg = {20, 30, 0}},
      {.model = box.get(), .origin_world = {160, 195, 34}, .angles_deg = {25, 40, 10}},
      {.model = walker.get(),
       .origin_world = {150, 280, 24},
       .angles_deg = {0, 215, 0},
       .from_pose = stride,
       .to_pose = stride},
      {.model = walker.get(),
       .origin_world = {150, 240, 24},
       .angles_deg = {0, 150, 0},
       .from_pose = stride,
       .to_pose = pass,
       .blend = 0.5f,
       .colors = render::PlayerColors{4, 13}}};
  render::Scene scene = stage.scene({.origin_world = {56, 260, 56}, .angles_deg = {6, 0, 0}});
  scene.alias_models = models;
  stage.draw(scene, io_frame, {.alias_raster = render::AliasRaster::kAffine});
}

void draw_models_far(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  const auto walker = drawable(walker_mdl()), ball = small_model(sphere_mdl(32, 17), 48);
  std::vector<render::AliasInstance> models;
  for (int row = 0; row < 6; ++row)
    for (int place = 0; place < 5; ++place) {
      render::AliasInstance instance;
      instance.model = (row + place) % 2 == 0 ? walker.get() : ball.get();
      instance.origin_world = {950 + 85 * row, 60 + 130 * place, -104};
      instance.angles_deg = {0, 180 + 20 * place, 0};
      instance.from_pose = instance.to_pose =
          render::pose_at(*instance.model, static_cast<std::uint32_t>(row), 0);
      models.push_back(instance);
    }
  render::Scene scene = stage.scene({.origin_world = {780, 320, 40}, .angles_deg = {14, 0, 0}});
  scene.alias_models = models;
  stage.draw(scene, io_frame);
}

void draw_weapon_wide(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  const render::Camera camera = {.origin_world = {140, 124, 46}, .angles_deg = {4, 160, 0}, .fov_deg = 130};
  const auto weapon = drawable(weapon_mdl());
  const render::AliasInstance held = {.model = weapon.get(),
                                      .origin_world = camera.origin_world,
                                      .angles_deg = {-4, 160, 0},
                                      .min_light = 24};
  render::Scene scene = stage.scene(camera);
  scene.view_weapon = &held;
  stage.draw(scene, io_frame);
}

void draw_sprites(render::FrameBuffer& io_frame) {
  using Orientation = formats::SprOrientation;
  GoldenStage stage;
  std::array<formats::Spr, 5> letters;
  std::array<render::SpriteInstance, 5> sprites;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    letters[i] = letter_f(static_cast<Orientation>(i));
    sprites[i].sprite = &letters[i];
    sprites[i].picture = &letters[i].frames[0].pictures[0];
    sprites[i].origin_world = {200, 352 - 48 * static_cast<int>(i), 60};
  }
  const auto of = [&](Orientation orientation) -> render::SpriteInstance& {
    return sprites[static_cast<std::size_t>(orientation)];
  };
  of(Orientation::kOriented).angles_deg = {0, 40, 0};
  of(Orientation::kParallelOriented).angles_deg = {0, 0, 45};
  of(Orientation::kFacingUpright).alpha = 0.5f;
  render::Scene scene = stage.scene({.origin_world = {70, 256, 110}, .angles_deg = {20, 0, 12}});
  scene.sprites = sprites;
  stage.draw(scene, io_frame);
}

void draw_explosion(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  EventStage happening;
  client::Events events;
  events.temp_entities.push_back({.kind = net::TempEntityKind::kExplosion, .origin = {240, 256, 20}});
  happening.advance(stage, 1, events);
  happening.advance(stage, 1.2);
  render::Scene scene = stage.scene({.origin_world = {48, 256, 60}, .angles_deg = {8, 0, 0}});
  scene.time_s = 1.2;
  happening.put_into(scene);
  stage.draw(scene, io_frame);
}

void draw_lightning(render::FrameBuffer& io_frame) {
  GoldenStage stage;
  EventStage happening;
  client::Events events;
  events.temp_entities.push_back({.kind = net::TempEntityKind::kLightning2,
                                  .origin = {80, 310, 60},
                                  .end = {480, 130, 90},
                                  .entity = 1});
  happening.advance(stage, 1, events);
  const auto bolt = drawable(bolt_mdl());
  std::vector<render::AliasInstance> pieces;
  for (const client::BeamPiece& piece : happening.effects().beams())
    pieces.push_back({.model = bolt.get(),
                      .origin_world = piece.origin_world,
                      .angles_deg = piece.angles_deg,
                      .full_bright = true});
  render::Scene scene = stage.scene({.origin_world = {48, 200, 60}, .angles_deg = {0, 10, 0}});
  scene.alias_models = pieces;
  stage.draw(scene, io_frame);
}

void draw_status_bar(render::FrameBuffer& io_frame) {
  using client::Stat;
  client::Game game;
  game.data.items = 1u << 0 | 1u << 1 | 1u << 5 | 1u << 10 | 1u << 14 | client::kItemSuit;
  set(game, Stat::kHealth, 42);
  set(game, Stat::kArmor, 75);
  set(game, Stat::kAmmo, 13);
  set(game, Stat::kRockets, 13);
  set(game, Stat::kShells, 25);
  set(game, Stat::kActiveWeapon, 1 << 5);
  game.center_text = "You need\nthe gold key";
  game.center_text_since_s = 0.5;
  GoldenStage stage;
  render::Scene scene = stage.scene({.origin_world = {48, 256, 46}});
  scene.tint = {{255, 0, 0}, 0.3f};
  stage.draw(scene, io_frame);
  draw_hud(game, 1, stage.renderer(), io_frame);
}

void draw_intermission(render::FrameBuffer& io_frame) {
  using client::Stat;
  client::Game game;
  game.ending = client::Ending::kIntermission;
  game.ending_since_s = 83;
  set(game, Stat::kSecrets, 1);
  set(game, Stat::kTotalSecrets, 3);
  set(game, Stat::kMonsters, 17);
  set(game, Stat::kTotalMonsters, 20);
  GoldenStage stage;
  stage.draw(stage.scene({.origin_world = {800, 32, 200}, .angles_deg = {20, 45, 0}}), io_frame);
  draw_hud(game, 90, stage.renderer(), io_frame);
}

}  // namespace temblor::test

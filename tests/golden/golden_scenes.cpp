#include "golden/golden_scenes.h"

namespace temblor::test {

std::span<const GoldenScene> golden_scenes() {
  using render::PixelFormat;
  static constexpr GoldenScene kScenes[] = {
      {"hall", "two pillars before brick walls, panels in the ceiling, a dark opening, a door at the end",
       PixelFormat::kIndexed, draw_hall},
      {"court", "stairs, a pool with opaque water, a stage lit red, clouds above; walls very bright up there",
       PixelFormat::kRgb, draw_court},
      {"dynamic_lights", "round patches of light: red before the left pillar, blue on the wall beyond it",
       PixelFormat::kRgb, draw_dynamic_lights},
      {"marks", "a corner: a scorch over both walls, bullet holes on the left one, blood on the right one",
       PixelFormat::kIndexed, draw_marks},
      {"marks_on_mover",
       "a door in the air, turned and tilted: a half clear F upright on it and leaning with it, another cut "
       "off "
       "at its edge, three bullet holes",
       PixelFormat::kRgb, draw_marks_on_mover},
      {"marks_on_mover_indexed", "the same in the palette's colors", PixelFormat::kIndexed,
       draw_marks_on_mover},
      {"see_through",
       "a pool whose ground shows through, a ball half in the water, a grating before it and a glassy one "
       "behind",
       PixelFormat::kIndexed, draw_see_through},
      {"see_through_rgb", "the same; no bright fringes along the gratings' bars", PixelFormat::kRgb,
       draw_see_through},
      // Two of 255: the precision of a step of fog.
      {"fog", "the court fades into violet, its sky half", PixelFormat::kRgb, draw_fog, {.step = 2}},
      {"fog_indexed", "the same in the palette's colors, where grays turn violet all at once",
       PixelFormat::kIndexed, draw_fog},
      {"skybox", "two sides and the top, checkered; along their edges bright squares meet dark ones",
       PixelFormat::kRgb, draw_skybox},
      {"under_water", "from the pool's ground: all sways and is brown; nothing empty at the borders",
       PixelFormat::kIndexed, draw_under_water},
      {"models_near",
       "a ball, a box, a walker in his own colors and one in red and green; no holes, no swimming textures",
       PixelFormat::kRgb, draw_models_near},
      {"models_far", "rows of walkers and balls that go away, the last ones a few pixels high, all with legs",
       PixelFormat::kIndexed, draw_models_far},
      {"weapon_wide", "field of view 130: the weapon is as long as ever, and before the pillar that it is in",
       PixelFormat::kRgb, draw_weapon_wide},
      {"sprites",
       "five letters F, the eye rolled and looking down: upright as the pillars, the same and half clear, "
       "square "
       "with the picture, turned away to the left, square but rolled",
       PixelFormat::kRgb, draw_sprites},
      {"explosion", "a cloud of golden sparks, 0.2 s old; the floor flooded with its light, a scorch below",
       PixelFormat::kIndexed, draw_explosion},
      {"lightning", "a row of bright blue pieces from the left to the right pillar, each turned its own way",
       PixelFormat::kRgb, draw_lightning},
      {"status_bar",
       "pain: the hall is red; over it, untinted, a text and the bar: 75 armor, 42 health, 13 rockets; "
       "weapons "
       "2, 3 and 7, a suit",
       PixelFormat::kRgb, draw_status_bar},
      {"intermission", "1:23, secrets 1 of 3, monsters 17 of 20, over a view of the court from above",
       PixelFormat::kIndexed, draw_intermission},
  };
  return kScenes;
}

}  // namespace temblor::test

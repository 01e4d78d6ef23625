// Marks on the faces of the world and of movers: bullet holes, scorches, and blood (stock Quake has none;
// r_marks turns them on), and pictures that the game asks for.
//
// A hit is a ball around the nearest point of a face; it marks every face whose plane the ball cuts, so that
// marks wrap around corners:
//
//      ____.-"-.____ wall        the ball's intersection with each plane is a circle,
//         (  +  )|               the mark on that face
//          `-.-' | other wall
//
// A picture stays in one plane: it is cut off at corners. Marks are kept in the space of their face's model,
// so they move and turn with a door or a lift.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/marks.h"
#include "render/scene.h"
#include "world/face_at.h"

namespace temblor::client {

// A shot or explosion near a wall, or a picture. `seed` chooses among variants of the mark's shape.
struct Hit {
  render::MarkKind kind{};
  math::Vec3 origin_world{0.0f};
  float reach = 0;   // maximum distance to the nearest face, units
  float radius = 0;  // of the ball, units; half the longer side of a picture
  std::uint32_t seed = 0;
  // Only for kPicture, and never null then.
  std::shared_ptr<const render::MarkPicture> picture{};
  // Pictures stand upright on walls; on floors and ceilings their upper edge points north (+y). Degrees from
  // there, clockwise.
  float turn_deg = 0;
  bool is_lasting = false;  // see render::Mark
};

class HitMarks {
 public:
  // Adds marks to the world and to `movers`, whose models must not be shown twice. Adds none if no lit face
  // is within reach or the nearest surface is sky. Liquids are ignored.
  void add(const world::Level& level, std::span<const render::BrushModelInstance> movers, const Hit& hit,
           render::MarkSet& io_marks);
  // The lit face that a hit at this place marks, and its normal in world space; nothing as for add().
  struct Surface {
    world::FaceIndex face{};
    math::Vec3 normal_world{0.0f};
  };
  std::optional<Surface> find_surface(const world::Level& level,
                                      std::span<const render::BrushModelInstance> movers, const Hit& hit);
  // Adds marks to one model only; the hit's origin is in the model's space.
  void add_to_model(const world::Level& level, world::ModelIndex model, const Hit& hit,
                    render::MarkSet& io_marks);

 private:
  // A model near the hit.
  struct Target {
    world::ModelIndex model{};
    math::Vec3d origin_world{0.0};
    // The model's axes in world space.
    math::Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

    math::Vec3d to_model(const math::Vec3d& world) const;
    math::Vec3d to_world(const math::Vec3d& model_point) const;
  };
  // A point of a face in front of which a hit happened.
  struct Place {
    Target target;
    world::NearFace near;
  };
  static Target make_target(const render::BrushModelInstance& mover);
  void find_targets(const world::Level& level, std::span<const render::BrushModelInstance> movers,
                    const Hit& hit);
  std::optional<Place> find_place(const world::Level& level, const Hit& hit);
  void add_to_targets(const world::Level& level, const Hit& hit, render::MarkSet& io_marks);
  bool is_in_sight(const world::Level& level, const math::Vec3d& from_world, const Place& place) const;
  void mark_faces(const world::Level& level, const Hit& hit, const Place& hit_place, const Target& target,
                  render::MarkSet& io_marks);

  world::NearFaceFinder faces_near_;
  std::vector<Target> targets_;
};

}  // namespace temblor::client

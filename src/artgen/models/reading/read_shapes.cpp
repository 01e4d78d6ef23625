#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "artgen/models/reading/read_parts.h"
#include "artgen/models/reading/values.h"
#include "artgen/models/rings.h"
#include "artgen/models/solids.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

using math::Vec3d;

// Radii below this are points.
constexpr double kSharp = 1e-6;

// A position in the model's coordinates, and the bones that move it. A star in a bone's name means the left
// one; the right side is added later as a mirror image.
struct BonePosition {
  Vec3d at{0.0};
  std::size_t bone_a = 0, bone_b = 0;
  double share_b = 0;
};

// Reads one line with a shape and adds the shape to the model's mesh.
class ShapeReader {
 public:
  ShapeReader(const ScriptLine& line, Model& io_model)
      : line_(line), arguments_(line), model_(io_model), rest_(rest_positions(io_model.skeleton)) {
    first_bone_ = arguments_.text();
    mirrored_ = is_pair(first_bone_);
  }

  // The shape's look is added first, because the mesh refers to it by index.
  base::Status read() {
    TRY_STATUS(read_look());
    const auto shape = static_cast<std::uint32_t>(model_.shapes.size() - 1);
    const std::size_t points = model_.mesh.points.size(), triangles = model_.mesh.triangles.size();
    const std::uint32_t smooth = model_.mesh.smooth_count;
    TRY_STATUS(add(shape));
    if (mirrored_) add_image(points, triangles, smooth);
    return base::Ok{};
  }

 private:
  // The paint and the patches.
  base::Status read_look() {
    ShapeLook look;
    TRY(look.paint, find_paint(arguments_.text("paint", ""), line_));
    for (const ScriptLine& below : line_.below) {
      if (below.keyword != "patch") return script_error(below, "only 'patch' lines can be under a shape");
      Arguments arguments(below);
      Patch patch;
      const std::string paint = arguments.text();
      std::tie(patch.along_low, patch.along_high) = arguments.range("along", {0, 1});
      std::tie(patch.around_low_deg, patch.around_high_deg) = arguments.range("around", {-180, 180});
      TRY_STATUS(arguments.finish());
      TRY(patch.paint, find_paint(paint, below));
      look.patches.push_back(patch);
    }
    model_.shapes.push_back(std::move(look));
    return base::Ok{};
  }

  // The index of a paint; an empty name means the first one.
  base::Result<std::size_t> find_paint(const std::string& name, const ScriptLine& line) const {
    const std::vector<Paint>& paints = model_.skins.front();
    if (paints.empty()) return script_error(line, "the model has no paint");
    if (name.empty()) return std::size_t{0};
    for (std::size_t i = 0; i < paints.size(); ++i)
      if (paints[i].name == name) return i;
    return script_error(line, fmt::format("no paint is named '{}'", base::quotable(name)));
  }

  base::Status add(std::uint32_t shape) {
    if (line_.keyword == "tube") return add_tube(shape);
    if (line_.keyword == "ball") return add_ball(shape);
    if (line_.keyword == "box") return add_one_box(shape);
    if (line_.keyword == "plate") return add_one_plate(shape);
    return add_spike(shape);
  }

  // "X,Y,Z" on the shape's bone, "BONE@X,Y,Z" on another one, or "BONE+BONE@X,Y,Z" between two bones
  // (relative to the last).
  base::Result<BonePosition> parse_position(std::string_view text) const {
    const std::size_t at_sign = text.find('@');
    std::string_view bones =
        at_sign == std::string_view::npos ? std::string_view(first_bone_) : text.substr(0, at_sign);
    const std::string_view where = at_sign == std::string_view::npos ? text : text.substr(at_sign + 1);
    const auto numbers = parse_numbers(where);
    if (!numbers || numbers->size() != 3)
      return script_error(line_, fmt::format("'{}' is not X,Y,Z", base::quotable(where)));
    BonePosition position;
    const std::size_t plus = bones.find('+');
    TRY(position.bone_a, find_bone(line_, model_.skeleton, select_side(bones.substr(0, plus), 'l')));
    position.bone_b = position.bone_a;
    if (plus != std::string_view::npos) {
      TRY(position.bone_b, find_bone(line_, model_.skeleton, select_side(bones.substr(plus + 1), 'l')));
      position.share_b = 0.5;
    }
    position.at = on_bone(position.bone_b, {(*numbers)[0], (*numbers)[1], (*numbers)[2]});
    return position;
  }

  // From a bone's coordinates to the model's at rest.
  Vec3d on_bone(std::size_t bone, const Vec3d& at) const {
    return rest_[bone] + at * model_.skeleton.bones[bone].scale;
  }

  // "X,Y,Z:RADIUS" or "X,Y,Z:WIDTHxDEPTH". Radii are scaled by the mean of the bone's scale.
  base::Result<Ring> parse_ring(std::string_view text) const {
    const std::size_t colon = text.find(':');
    TRY(const BonePosition position, parse_position(text.substr(0, colon)));
    const auto radii =
        colon == std::string_view::npos ? std::nullopt : parse_numbers(text.substr(colon + 1), 'x');
    if (!radii || radii->size() > 2 || radii->front() < 0 || radii->back() < 0)
      return script_error(line_,
                          fmt::format("'{}' is not X,Y,Z:RADIUS or X,Y,Z:WIDTHxDEPTH", base::quotable(text)));
    const Vec3d scale = model_.skeleton.bones[position.bone_b].scale;
    const double factor = std::cbrt(scale.x * scale.y * scale.z);
    return Ring{position.at,     radii->front() * factor, radii->back() * factor,
                position.bone_a, position.bone_b,         position.share_b};
  }

  base::Result<Edges> read_edges(Edges fallback) {
    const std::string edges = arguments_.text("edges", "");
    if (edges.empty()) return fallback;
    if (edges == "smooth") return Edges::kSmooth;
    if (edges == "rings") return Edges::kRings;
    if (edges == "hard") return Edges::kHard;
    return script_error(line_,
                        fmt::format("edges={} is not one of smooth, rings, hard", base::quotable(edges)));
  }

  // One word for both ends, or two with a comma.
  base::Status read_ends(RingSurface& io_surface) {
    const std::string ends = arguments_.text("ends", "round");
    constexpr std::array<std::string_view, 6> kEnds = {"round",      "flat",      "round,flat",
                                                       "flat,round", "flat,flat", "round,round"};
    if (std::find(kEnds.begin(), kEnds.end(), ends) == kEnds.end())
      return script_error(
          line_, fmt::format("ends={} is neither round, flat nor two of them", base::quotable(ends)));
    io_surface.first_end = ends.starts_with("flat") ? RingEnd::kFlat : RingEnd::kRound;
    io_surface.last_end = ends.ends_with("flat") ? RingEnd::kFlat : RingEnd::kRound;
    return base::Ok{};
  }

  // Rings from point to point. The first and the last may have a radius of 0.
  base::Status add_tube(std::uint32_t shape) {
    RingSurface surface;
    while (const auto text = arguments_.text_if_present()) {
      TRY(Ring ring, parse_ring(*text));
      surface.rings.push_back(ring);
    }
    surface.sides = arguments_.integer("sides", 6, 3, 64);
    surface.turn_deg = arguments_.number("turn", 0, -360, 360);
    TRY(surface.edges, read_edges(Edges::kSmooth));
    TRY_STATUS(read_ends(surface));
    TRY_STATUS(arguments_.finish());
    if (surface.rings.size() < 2) return script_error(line_, "a tube needs at least two positions");
    for (std::size_t i = 0; i < surface.rings.size(); ++i) {
      Ring& ring = surface.rings[i];
      const bool inside = i > 0 && i + 1 < surface.rings.size();
      if (std::min(ring.width, ring.depth) > kSharp) continue;
      if (inside || std::max(ring.width, ring.depth) > kSharp)
        return script_error(line_, "a tube's radii must be above 0, except for points at its ends");
      ring.width = ring.depth = 0;
    }
    if (surface.rings.size() == 2 && surface.rings[0].width <= 0 && surface.rings[1].width <= 0)
      return script_error(line_, "a tube needs a radius above 0 somewhere");
    add_rings(surface, shape, model_.mesh);
    return base::Ok{};
  }

  // An ellipsoid: rings around z, with points at the poles, then rotated.
  base::Status add_ball(std::uint32_t shape) {
    const std::string center = arguments_.text();
    const Vec3d radii(arguments_.vector());
    RingSurface surface;
    surface.sides = arguments_.integer("sides", 8, 3, 64);
    const std::int32_t rows = arguments_.integer("rows", 4, 2, 64);
    const glm::dmat3 turn = make_rotation(Vec3d(arguments_.vector("turn", math::Vec3(0.0f))));
    TRY(surface.edges, read_edges(Edges::kSmooth));
    TRY_STATUS(arguments_.finish());
    if (std::min({radii.x, radii.y, radii.z}) <= 0)
      return script_error(line_, "a ball's radii must be above 0");
    TRY(const BonePosition position, parse_position(center));
    const Vec3d scaled = radii * model_.skeleton.bones[position.bone_b].scale;
    for (std::int32_t row = 0; row <= rows; ++row) {
      const double angle = std::numbers::pi * row / rows;
      const bool pole = row == 0 || row == rows;
      Ring ring{
          Vec3d(0, 0, -scaled.z * std::cos(angle)), 0, 0, position.bone_a, position.bone_b, position.share_b};
      if (!pole) {
        ring.width = scaled.y * std::sin(angle);
        ring.depth = scaled.x * std::sin(angle);
      }
      surface.rings.push_back(ring);
    }
    const std::size_t first = model_.mesh.points.size();
    add_rings(surface, shape, model_.mesh);
    for (std::size_t i = first; i < model_.mesh.points.size(); ++i)
      model_.mesh.points[i].rest = position.at + turn * model_.mesh.points[i].rest;
    return base::Ok{};
  }

  base::Status add_one_box(std::uint32_t shape) {
    const std::string center = arguments_.text();
    BoxSurface surface;
    surface.size = Vec3d(arguments_.vector());
    surface.bevel = arguments_.number("bevel", 0, 0, 1000);
    const std::string taper = arguments_.text("taper", "1");
    const Vec3d turn_deg(arguments_.vector("turn", math::Vec3(0.0f)));
    TRY_STATUS(arguments_.finish());
    if (std::min({surface.size.x, surface.size.y, surface.size.z}) <= 0)
      return script_error(line_, "a box's sides must be above 0");
    const auto tapers = parse_numbers(taper);
    if (!tapers || tapers->size() > 2 || tapers->front() <= 0 || tapers->back() <= 0)
      return script_error(
          line_, fmt::format("taper={} is neither a number nor X,Y, above 0", base::quotable(taper)));
    surface.taper = {tapers->front(), tapers->back()};
    TRY(const BonePosition position, parse_position(center));
    surface.size *= model_.skeleton.bones[position.bone_b].scale;
    surface.transform = {make_rotation(turn_deg), position.at};
    surface.bone = position.bone_b;
    add_box(surface, shape, model_.mesh);
    return base::Ok{};
  }

  base::Status add_one_plate(std::uint32_t shape) {
    PlateSurface surface;
    surface.thickness = arguments_.number("thick", 1, 0.01, 1000);
    while (const auto text = arguments_.text_if_present()) {
      TRY(const BonePosition position, parse_position(*text));
      surface.outline.push_back({position.at, position.bone_a, position.bone_b, position.share_b});
    }
    TRY_STATUS(arguments_.finish());
    if (surface.outline.size() < 3) return script_error(line_, "a plate needs at least three corners");
    add_plate(surface, shape, model_.mesh);
    return base::Ok{};
  }

  // Spikes and crystals: a base, a shoulder, and a tip. A spike has its shoulder only if it is bent there.
  base::Status add_spike(std::uint32_t shape) {
    const bool is_crystal = line_.keyword == "crystal";
    const std::string from_text = arguments_.text(), to_text = arguments_.text();
    const double radius = arguments_.number("radius", 1, 0.01, 1000);
    const double shoulder = arguments_.number("shoulder", is_crystal ? 0.7 : 0.5, 0.05, 0.95);
    const Vec3d bend(arguments_.vector("bend", math::Vec3(0.0f)));
    RingSurface surface;
    surface.sides = arguments_.integer("sides", 5, 3, 64);
    surface.turn_deg = arguments_.number("turn", 0, -360, 360);
    TRY(surface.edges, read_edges(is_crystal ? Edges::kHard : Edges::kSmooth));
    TRY_STATUS(arguments_.finish());
    TRY(const BonePosition from, parse_position(from_text));
    TRY(const BonePosition to, parse_position(to_text));
    if (glm::distance(from.at, to.at) <= 0)
      return script_error(line_, "its two ends are at the same position");
    const auto ring = [&](double along, double wide, const Vec3d& aside) {
      const BonePosition& position = along < 0.5 ? from : to;
      surface.rings.push_back({glm::mix(from.at, to.at, along) + aside, wide, wide, position.bone_a,
                               position.bone_b, position.share_b});
    };
    ring(0, is_crystal ? 0.7 * radius : radius, Vec3d(0.0));
    if (is_crystal)
      ring(shoulder, radius, bend);
    else if (bend != Vec3d(0.0))
      ring(shoulder, radius * (1 - 0.75 * shoulder), bend);
    ring(1, 0, Vec3d(0.0));
    surface.first_end = RingEnd::kFlat;
    add_rings(surface, shape, model_.mesh);
    return base::Ok{};
  }

  // Adds the mirror image of everything from these indices on. It uses the same part of the skin. Mirroring
  // reverses triangles, so two corners are exchanged.
  void add_image(std::size_t first_point, std::size_t first_triangle, std::uint32_t first_smooth) {
    Mesh& mesh = model_.mesh;
    const std::size_t points = mesh.points.size(), triangles = mesh.triangles.size();
    for (std::size_t i = first_point; i < points; ++i) {
      MeshPoint image = mesh.points[i];
      image.rest.y = -image.rest.y;
      image.bone_a = other_side(image.bone_a);
      image.bone_b = other_side(image.bone_b);
      mesh.points.push_back(image);
    }
    const auto shift = static_cast<std::uint32_t>(points - first_point);
    const std::uint32_t smooth_shift = mesh.smooth_count - first_smooth;
    for (std::size_t i = first_triangle; i < triangles; ++i) {
      MeshTriangle image = mesh.triangles[i];
      for (MeshCorner& corner : image.corners) corner.point += shift;
      std::swap(image.corners[1], image.corners[2]);
      image.smooth += smooth_shift;
      mesh.triangles.push_back(image);
      mesh.is_image.push_back(true);
    }
    mesh.smooth_count += smooth_shift;
  }

  // The bone on the other side of the body; the bone itself if there is none.
  std::size_t other_side(std::size_t bone) const {
    return model_.skeleton.find(mirror_name(model_.skeleton.bones[bone].name)).value_or(bone);
  }

  const ScriptLine& line_;
  Arguments arguments_;
  Model& model_;
  // The bones' positions at rest.
  std::vector<Vec3d> rest_;
  // The shape's bone, which positions without a bone refer to.
  std::string first_bone_;
  bool mirrored_ = false;
};

}  // namespace

bool is_shape_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 6> kKeywords = {"tube", "ball", "box", "plate", "spike", "crystal"};
  return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

base::Status read_shape(const ScriptLine& line, Model& io_model) {
  return ShapeReader(line, io_model).read();
}

}  // namespace temblor::artgen

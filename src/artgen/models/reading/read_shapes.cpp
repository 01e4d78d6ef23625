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

constexpr double kSharp = 1e-6;  // radii below are points

// A place on a bone, in the model's space; stars stand for the left.
struct BonePlace {
  Vec3d at{0.0};
  std::size_t bone_a = 0, bone_b = 0;
  double share_b = 0;
};

// What the words of one shape's line are read with.
class ShapeReader {
 public:
  ShapeReader(const ScriptLine& line, Model& io_model)
      : line_(line), arguments_(line), model_(io_model), rest_(rest_places(io_model.skeleton)) {
    first_bone_ = arguments_.text();
    mirrored_ = is_pair(first_bone_);
  }

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
  base::Status read_look() {
    ShapeLook look;
    TRY(look.paint, find_paint(arguments_.text("paint", ""), line_));
    for (const ScriptLine& below : line_.below) {
      if (below.word != "patch") return script_error(below, "a shape has lines 'patch'");
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

  base::Result<std::size_t> find_paint(const std::string& name, const ScriptLine& line) const {
    const std::vector<Paint>& paints = model_.skins.front();
    if (paints.empty()) return script_error(line, "the model has no paint");
    if (name.empty()) return std::size_t{0};
    for (std::size_t i = 0; i < paints.size(); ++i)
      if (paints[i].name == name) return i;
    return script_error(line, fmt::format("there is no paint '{}'", base::quotable(name)));
  }

  base::Status add(std::uint32_t shape) {
    if (line_.word == "tube") return add_tube(shape);
    if (line_.word == "ball") return add_ball(shape);
    if (line_.word == "box") return add_one_box(shape);
    if (line_.word == "plate") return add_one_plate(shape);
    return add_spike(shape);
  }

  // "X,Y,Z" on the shape's bone, "BONE@X,Y,Z" on another, "BONE+BONE@X,Y,Z" between two (at a place of the
  // last).
  base::Result<BonePlace> place_in(std::string_view text) const {
    const std::size_t at_sign = text.find('@');
    std::string_view bones =
        at_sign == std::string_view::npos ? std::string_view(first_bone_) : text.substr(0, at_sign);
    const std::string_view where = at_sign == std::string_view::npos ? text : text.substr(at_sign + 1);
    const auto numbers = numbers_in(where);
    if (!numbers || numbers->size() != 3)
      return script_error(line_, fmt::format("'{}' is not X,Y,Z", base::quotable(where)));
    BonePlace place;
    const std::size_t plus = bones.find('+');
    TRY(place.bone_a, find_bone(line_, model_.skeleton, on_side(bones.substr(0, plus), 'l')));
    place.bone_b = place.bone_a;
    if (plus != std::string_view::npos) {
      TRY(place.bone_b, find_bone(line_, model_.skeleton, on_side(bones.substr(plus + 1), 'l')));
      place.share_b = 0.5;
    }
    place.at = on_bone(place.bone_b, {(*numbers)[0], (*numbers)[1], (*numbers)[2]});
    return place;
  }

  Vec3d on_bone(std::size_t bone, const Vec3d& at) const {
    return rest_[bone] + at * model_.skeleton.bones[bone].scale;
  }

  // "X,Y,Z:RADIUS" or "X,Y,Z:WIDTHxDEPTH".
  base::Result<Ring> ring_in(std::string_view text) const {
    const std::size_t colon = text.find(':');
    TRY(const BonePlace place, place_in(text.substr(0, colon)));
    const auto radii =
        colon == std::string_view::npos ? std::nullopt : numbers_in(text.substr(colon + 1), 'x');
    if (!radii || radii->size() > 2 || radii->front() < 0 || radii->back() < 0)
      return script_error(line_,
                          fmt::format("'{}' is not X,Y,Z:RADIUS or X,Y,Z:WIDTHxDEPTH", base::quotable(text)));
    const Vec3d scale = model_.skeleton.bones[place.bone_b].scale;
    const double factor = std::cbrt(scale.x * scale.y * scale.z);
    return Ring{place.at,     radii->front() * factor, radii->back() * factor, place.bone_a, place.bone_b,
                place.share_b};
  }

  base::Result<Edges> read_edges(Edges otherwise) {
    const std::string edges = arguments_.text("edges", "");
    if (edges.empty()) return otherwise;
    if (edges == "smooth") return Edges::kSmooth;
    if (edges == "rings") return Edges::kRings;
    if (edges == "hard") return Edges::kHard;
    return script_error(line_, fmt::format("edges={} is none of smooth, rings, hard", base::quotable(edges)));
  }

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

  base::Status add_tube(std::uint32_t shape) {
    RingSurface surface;
    while (const auto text = arguments_.text_if_there()) {
      TRY(Ring ring, ring_in(*text));
      surface.rings.push_back(ring);
    }
    surface.sides = arguments_.integer("sides", 6, 3, 64);
    surface.turn_deg = arguments_.number("turn", 0, -360, 360);
    TRY(surface.edges, read_edges(Edges::kSmooth));
    TRY_STATUS(read_ends(surface));
    TRY_STATUS(arguments_.finish());
    if (surface.rings.size() < 2) return script_error(line_, "a tube has at least two places");
    for (std::size_t i = 0; i < surface.rings.size(); ++i) {
      Ring& ring = surface.rings[i];
      const bool inside = i > 0 && i + 1 < surface.rings.size();
      if (std::min(ring.width, ring.depth) > kSharp) continue;
      if (inside || std::max(ring.width, ring.depth) > kSharp)
        return script_error(line_, "a tube has radii above 0, but for points at its ends");
      ring.width = ring.depth = 0;
    }
    if (surface.rings.size() == 2 && surface.rings[0].width <= 0 && surface.rings[1].width <= 0)
      return script_error(line_, "a tube has a radius somewhere");
    add_rings(surface, shape, model_.mesh);
    return base::Ok{};
  }

  base::Status add_ball(std::uint32_t shape) {
    const std::string center = arguments_.text();
    const Vec3d radii(arguments_.vector());
    RingSurface surface;
    surface.sides = arguments_.integer("sides", 8, 3, 64);
    const std::int32_t rows = arguments_.integer("rows", 4, 2, 64);
    const glm::dmat3 turn = rotation(Vec3d(arguments_.vector("turn", math::Vec3(0.0f))));
    TRY(surface.edges, read_edges(Edges::kSmooth));
    TRY_STATUS(arguments_.finish());
    if (std::min({radii.x, radii.y, radii.z}) <= 0) return script_error(line_, "a ball has radii above 0");
    TRY(const BonePlace place, place_in(center));
    const Vec3d scaled = radii * model_.skeleton.bones[place.bone_b].scale;
    for (std::int32_t row = 0; row <= rows; ++row) {
      const double angle = std::numbers::pi * row / rows;
      const bool pole = row == 0 || row == rows;
      Ring ring{Vec3d(0, 0, -scaled.z * std::cos(angle)), 0, 0, place.bone_a, place.bone_b, place.share_b};
      if (!pole) {
        ring.width = scaled.y * std::sin(angle);
        ring.depth = scaled.x * std::sin(angle);
      }
      surface.rings.push_back(ring);
    }
    const std::size_t first = model_.mesh.points.size();
    add_rings(surface, shape, model_.mesh);
    for (std::size_t i = first; i < model_.mesh.points.size(); ++i)
      model_.mesh.points[i].rest = place.at + turn * model_.mesh.points[i].rest;
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
      return script_error(line_, "a box has sides above 0");
    const auto tapers = numbers_in(taper);
    if (!tapers || tapers->size() > 2 || tapers->front() <= 0 || tapers->back() <= 0)
      return script_error(
          line_, fmt::format("taper={} is neither a number nor X,Y, above 0", base::quotable(taper)));
    surface.taper = {tapers->front(), tapers->back()};
    TRY(const BonePlace place, place_in(center));
    surface.size *= model_.skeleton.bones[place.bone_b].scale;
    surface.place = {rotation(turn_deg), place.at};
    surface.bone = place.bone_b;
    add_box(surface, shape, model_.mesh);
    return base::Ok{};
  }

  base::Status add_one_plate(std::uint32_t shape) {
    PlateSurface surface;
    surface.thickness = arguments_.number("thick", 1, 0.01, 1000);
    while (const auto text = arguments_.text_if_there()) {
      TRY(const BonePlace place, place_in(*text));
      surface.outline.push_back({place.at, place.bone_a, place.bone_b, place.share_b});
    }
    TRY_STATUS(arguments_.finish());
    if (surface.outline.size() < 3) return script_error(line_, "a plate has at least three corners");
    add_plate(surface, shape, model_.mesh);
    return base::Ok{};
  }

  // Spikes and crystals: a foot, a shoulder, a tip.
  base::Status add_spike(std::uint32_t shape) {
    const bool is_crystal = line_.word == "crystal";
    const std::string from_text = arguments_.text(), to_text = arguments_.text();
    const double radius = arguments_.number("radius", 1, 0.01, 1000);
    const double shoulder = arguments_.number("shoulder", is_crystal ? 0.7 : 0.5, 0.05, 0.95);
    const Vec3d bend(arguments_.vector("bend", math::Vec3(0.0f)));
    RingSurface surface;
    surface.sides = arguments_.integer("sides", 5, 3, 64);
    surface.turn_deg = arguments_.number("turn", 0, -360, 360);
    TRY(surface.edges, read_edges(is_crystal ? Edges::kHard : Edges::kSmooth));
    TRY_STATUS(arguments_.finish());
    TRY(const BonePlace from, place_in(from_text));
    TRY(const BonePlace to, place_in(to_text));
    if (glm::distance(from.at, to.at) <= 0) return script_error(line_, "its two places are one");
    const auto ring = [&](double along, double wide, const Vec3d& aside) {
      const BonePlace& place = along < 0.5 ? from : to;
      surface.rings.push_back(
          {glm::mix(from.at, to.at, along) + aside, wide, wide, place.bone_a, place.bone_b, place.share_b});
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

  // The same on the other side, seen in a mirror, with the same part of the skin.
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

  std::size_t other_side(std::size_t bone) const {
    return model_.skeleton.find(mirrored_name(model_.skeleton.bones[bone].name)).value_or(bone);
  }

  const ScriptLine& line_;
  Arguments arguments_;
  Model& model_;
  std::vector<Vec3d> rest_;
  std::string first_bone_;
  bool mirrored_ = false;
};

}  // namespace

bool is_shape_word(std::string_view word) {
  constexpr std::array<std::string_view, 6> kWords = {"tube", "ball", "box", "plate", "spike", "crystal"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

base::Status read_shape(const ScriptLine& line, Model& io_model) {
  return ShapeReader(line, io_model).read();
}

}  // namespace temblor::artgen

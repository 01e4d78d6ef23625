#include "lab/models/leaves/leaf_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace temblor::lab {

namespace {

// A corner of a part, with everything that is interpolated along an edge.
struct Corner {
  math::Vec3d world;
  double light, s, t;
  std::uint32_t vertex;
};

// A triangle has three corners, and each plane adds at most one. A part with more is not cut any further.
constexpr std::size_t kMaxCorners = 16;

struct Part {
  world::NodeIndex parent;
  std::size_t side;
  std::size_t count = 0;
  std::array<Corner, kMaxCorners> corners;

  void add(const Corner& corner) { corners[count++] = corner; }
};

class LeafCutter {
 public:
  LeafCutter(const CutRules& rules, const render::AliasPlacement& placement, const render::TriangleJob& job,
             std::uint32_t model, base::Arena& arena)
      : rules_(rules),
        placement_(placement),
        job_(job),
        model_(model),
        vertices_(arena, job.vertex_count + 64),
        texels_(arena, job.vertex_count + 64),
        worlds_(arena.allocate<math::Vec3d>(job.vertex_count)),
        triangles_(arena, job.triangle_count + 64),
        parts_(arena, job.triangle_count + 64),
        open_(arena, 16) {
    for (std::size_t i = 0; i < job.vertex_count; ++i) {
      vertices_.push_back(job.vertices[i]);
      texels_.push_back(job.texels[i]);
      worlds_[i] = find_world(job.vertices[i]);
    }
  }

  LeafParts cut() {
    const Start start = rules_.cuts ? find_start() : find_middle_leaf();
    for (std::size_t i = 0; i < job_.triangle_count; ++i) {
      const std::uint32_t* const corner = job_.triangles + 3 * i;
      if (!is_front(corner)) continue;
      if (start.is_leaf || !rules_.cuts)
        add_triangle(start.place, {corner[0], corner[1], corner[2]});
      else
        cut_triangle(start.child, corner);
    }
    LeafParts result{job_, parts_.view(), splits_};
    result.job.vertices = vertices_.view().data();
    result.job.texels = texels_.view().data();
    result.job.vertex_count = vertices_.view().size();
    result.job.triangle_count = triangles_.view().size();
    result.job.triangles = triangles_.view().empty() ? nullptr : triangles_.view().front().data();
    return result;
  }

 private:
  // The part of the tree that holds the model.
  struct Start {
    world::Child child;
    bool is_leaf;
    LeafPlace place;  // of a leaf
  };

  bool is_view_weapon() const { return placement_.depth_scale != 1; }

  // From the projection: parts that were clipped have no other position.
  math::Vec3d find_world(const render::ScreenVertex& vertex) const {
    const render::ViewFrame& view = rules_.view;
    const double nearness = double{vertex.depth} / double{placement_.depth_scale};
    const double z = placement_.perspective ? 1 / nearness : -nearness;
    const double units = (placement_.perspective ? z : 1) / double{placement_.pixels_per_unit};
    const double right = (vertex.x * (1.0 / render::kSubpixels) - view.center_x) * units;
    const double up = (view.center_y - vertex.y * (1.0 / render::kSubpixels)) * units;
    return view.eye_world + view.axes.right * right + view.axes.up * up + view.axes.forward * z;
  }

  Start find_start() const {
    if (is_view_weapon()) return {{}, true, kBeforeAll};
    math::Vec3d mins(1e30), maxs(-1e30);
    for (const math::Vec3d& p : worlds_) {
      mins = glm::min(mins, p);
      maxs = glm::max(maxs, p);
    }
    const math::Vec3d middle = (mins + maxs) * 0.5, half = (maxs - mins) * 0.5;
    return descend(middle, [&](const world::Plane& plane) {
      return glm::dot(glm::abs(math::Vec3d(plane.normal)), half) + 1e-6;
    });
  }
  Start find_middle_leaf() const {
    if (is_view_weapon()) return {{}, true, kBeforeAll};
    math::Vec3d sum(0.0);
    for (const math::Vec3d& p : worlds_) sum += p;
    return descend(sum / std::max<double>(1, static_cast<double>(worlds_.size())),
                   [](const world::Plane&) { return 0.0; });
  }
  // Goes down as long as everything within `reach` of the point is on one side.
  template <typename Reach>
  Start descend(const math::Vec3d& point, Reach reach) const {
    Start start{rules_.level.world().head, rules_.level.world().head.is_leaf(), {0, kBehindAll}};
    while (!start.is_leaf) {
      const world::NodeIndex index = start.child.node();
      const world::Node& node = rules_.level.node(index);
      const world::Plane& plane = rules_.level.planes[node.plane];
      const double distance = world::distance_to(plane, point);
      if (std::abs(distance) < reach(plane)) break;
      const std::size_t side = distance >= 0 ? 0 : 1;
      start.child = node.children[side];
      start.is_leaf = start.child.is_leaf();
      if (start.is_leaf) start.place = rules_.order.find(index, side);
    }
    return start;
  }

  bool is_front(const std::uint32_t* corner) const {
    const render::ScreenVertex &a = job_.vertices[corner[0]], &b = job_.vertices[corner[1]],
                               &c = job_.vertices[corner[2]];
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
               (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y) >
           0;
  }

  void cut_triangle(world::Child from, const std::uint32_t* corner) {
    Part whole{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = corner[i];
      whole.add({worlds_[v], job_.vertices[v].light, job_.texels[v].s, job_.texels[v].t, v});
    }
    cut_at(from.node(), whole);
    while (!open_.view().empty()) {
      const Part part = open_.view().back();
      open_.pop_back();
      const world::Child child = rules_.level.node(part.parent).children[part.side];
      if (child.is_leaf())
        add_part(rules_.order.find(part.parent, part.side), part);
      else
        cut_at(child.node(), part);
    }
  }

  // Leaves the parts on both sides of the node's plane in `open_`.
  void cut_at(world::NodeIndex index, const Part& part) {
    const world::Plane& plane = rules_.level.planes[rules_.level.node(index).plane];
    std::array<double, kMaxCorners> distances;
    std::size_t fronts = 0;
    for (std::size_t i = 0; i < part.count; ++i) {
      distances[i] = world::distance_to(plane, part.corners[i].world);
      fronts += distances[i] >= 0;
    }
    const bool is_full = part.count + 1 >= kMaxCorners;
    if (fronts == 0 || fronts == part.count || is_full) {
      Part same = part;
      same.parent = index;
      same.side = 2 * fronts >= part.count ? 0 : 1;
      open_.push_back(same);
      return;
    }
    ++splits_;
    Part front{index, 0, 0, {}}, back{index, 1, 0, {}};
    for (std::size_t i = 0; i < part.count; ++i) {
      const std::size_t next = i + 1 < part.count ? i + 1 : 0;
      const Corner &here = part.corners[i], &there = part.corners[next];
      (distances[i] >= 0 ? front : back).add(here);
      if ((distances[i] >= 0) == (distances[next] >= 0)) continue;
      // Computed from the front corner, so that both triangles at an edge get the same point.
      const Corner middle = distances[i] >= 0 ? cut_edge(here, there, distances[i], distances[next])
                                              : cut_edge(there, here, distances[next], distances[i]);
      front.add(middle);
      back.add(middle);
    }
    open_.push_back(front);
    open_.push_back(back);
  }

  Corner cut_edge(const Corner& front, const Corner& back, double d_front, double d_back) {
    const double along = d_front / (d_front - d_back);
    const auto mix = [along](const auto& from, const auto& to) { return from + (to - from) * along; };
    Corner corner{mix(front.world, back.world), mix(front.light, back.light), mix(front.s, back.s),
                  mix(front.t, back.t), static_cast<std::uint32_t>(vertices_.view().size())};
    const math::Vec3d view = rules_.view.to_view(corner.world);
    const double nearness = 1 / std::max(view.z, double{placement_.near_z});
    const double pixels = double{placement_.pixels_per_unit} * (placement_.perspective ? nearness : 1);
    const auto to_subpixels = [](double p) {
      return static_cast<std::int32_t>(std::nearbyint(p * render::kSubpixels));
    };
    vertices_.push_back({to_subpixels(rules_.view.center_x + view.x * pixels),
                         to_subpixels(rules_.view.center_y - view.y * pixels),
                         static_cast<float>(placement_.perspective ? nearness : -view.z),
                         static_cast<float>(corner.light)});
    texels_.push_back({static_cast<float>(corner.s), static_cast<float>(corner.t)});
    return corner;
  }

  void add_part(const LeafPlace& place, const Part& part) {
    for (std::size_t i = 2; i < part.count; ++i)
      add_triangle(place, {part.corners[0].vertex, part.corners[i - 1].vertex, part.corners[i].vertex});
  }

  void add_triangle(const LeafPlace& place, const render::MeshTriangle& triangle) {
    const auto vertex = [&](std::size_t i) -> const render::ScreenVertex& {
      return vertices_.view()[triangle[i]];
    };
    const auto [top, bottom] = std::minmax({vertex(0).y, vertex(1).y, vertex(2).y});
    const float depth = (vertex(0).depth + vertex(1).depth + vertex(2).depth) * (1.0f / 3);
    parts_.push_back({place, model_, static_cast<std::uint32_t>(triangles_.view().size()), depth, top >> 8,
                      (bottom >> 8) + 1});
    triangles_.push_back(triangle);
  }

  const CutRules& rules_;
  const render::AliasPlacement& placement_;
  const render::TriangleJob& job_;
  const std::uint32_t model_;
  base::ArenaVector<render::ScreenVertex> vertices_;
  base::ArenaVector<render::TexelPoint> texels_;
  std::span<math::Vec3d> worlds_;
  base::ArenaVector<render::MeshTriangle> triangles_;
  base::ArenaVector<LeafPart> parts_;
  base::ArenaVector<Part> open_;
  std::uint64_t splits_ = 0;
};

}  // namespace

LeafParts cut_into_leaves(const CutRules& rules, const render::AliasPlacement& placement,
                          const render::PreparedAlias& alias, std::uint32_t model, base::Arena& arena) {
  return LeafCutter(rules, placement, alias.job, model, arena).cut();
}

}  // namespace temblor::lab

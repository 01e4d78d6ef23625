#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "lab/models/stack/command_stream.h"

namespace temblor::lab {

namespace {

constexpr std::uint32_t kNoNumber = 0xffffffff;

using Numbers = std::vector<std::uint32_t>;

// Halves sets of triangles. Vertices that are in the stack count as cut away.
class Separator {
 public:
  Separator(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count)
      : triangles_(triangles),
        is_stacked_(vertex_count),
        seen_(vertex_count),
        first_corner_(vertex_count),
        next_corner_(3 * triangles.size()),
        visited_(triangles.size()) {}

  struct Halves {
    Numbers first, second;
    Numbers shared;  // vertices that both have
  };
  Halves halve(const Numbers& part) {
    // From one end of the part to the other, so that the middle is narrow.
    const Numbers order = order_by_distance(part, order_by_distance(part, part.front()).back());
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
    Halves halves{{order.begin(), middle}, {middle, order.end()}, {}};
    const std::uint32_t in_first = ++time_;
    for_each_vertex(halves.first, [&](std::uint32_t vertex) { seen_[vertex] = in_first; });
    for_each_vertex(halves.second, [&](std::uint32_t vertex) {
      if (seen_[vertex] != in_first) return;
      seen_[vertex] = 0;
      halves.shared.push_back(vertex);
    });
    return halves;
  }

  // The part's vertices that are not in the stack.
  std::size_t count_vertices(const Numbers& part) {
    const std::uint32_t now = ++time_;
    std::size_t count = 0;
    for_each_vertex(part, [&](std::uint32_t vertex) {
      count += seen_[vertex] != now;
      seen_[vertex] = now;
    });
    return count;
  }

  // The places in which the part can be drawn with one push for each vertex, or more than `most`.
  std::size_t find_room(const Numbers& part, std::size_t most) {
    const std::size_t all = count_vertices(part);
    if (all <= kMinStack || part.size() < 2) return all;
    const Halves halves = halve(part);
    const std::size_t shared = halves.shared.size();
    if (shared >= most) return all;
    set_stacked(halves.shared, true);
    std::size_t room = find_room(halves.first, most - shared);
    if (room <= most - shared) room = std::max(room, find_room(halves.second, most - shared));
    set_stacked(halves.shared, false);
    return std::min(all, shared + room);
  }

  void set_stacked(const Numbers& vertices, bool is_stacked) {
    for (const std::uint32_t vertex : vertices) is_stacked_[vertex] = is_stacked;
  }

 private:
  // Calls use(vertex) for corners that are not in the stack.
  template <typename Use>
  void for_each_vertex(const Numbers& part, Use use) const {
    for (const std::uint32_t triangle : part)
      for (const std::uint32_t vertex : triangles_[triangle])
        if (!is_stacked_[vertex]) use(vertex);
  }

  // Breadth first, from neighbor to neighbor across vertices that are not in the stack. Pieces that `start`
  // does not reach follow.
  Numbers order_by_distance(const Numbers& part, std::uint32_t start) {
    link_corners(part);
    Numbers order;
    order.reserve(part.size());
    const std::uint32_t now = ++time_;
    const auto visit = [&](std::uint32_t triangle) {
      if (visited_[triangle] == now) return;
      visited_[triangle] = now;
      order.push_back(triangle);
    };
    visit(start);
    std::size_t done = 0;
    for (const std::uint32_t piece : part) {
      for (; done < order.size(); ++done)
        for (const std::uint32_t vertex : triangles_[order[done]]) {
          if (is_stacked_[vertex]) continue;
          for (std::uint32_t& corner = first_corner_[vertex]; corner != kNoNumber;
               corner = next_corner_[corner])
            visit(corner / 3);  // each list is walked once
        }
      visit(piece);
    }
    return order;
  }

  // Lists the corners of the part by vertex.
  void link_corners(const Numbers& part) {
    for_each_vertex(part, [&](std::uint32_t vertex) { first_corner_[vertex] = kNoNumber; });
    for (const std::uint32_t triangle : part)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = triangles_[triangle][i], corner = 3 * triangle + i;
        next_corner_[corner] = first_corner_[vertex];
        first_corner_[vertex] = corner;
      }
  }

  const std::span<const render::MeshTriangle> triangles_;
  std::vector<bool> is_stacked_;  // by vertex
  Numbers seen_;                  // by vertex: a time
  Numbers first_corner_, next_corner_;
  Numbers visited_;  // by triangle: a time
  std::uint32_t time_ = 0;
};

class SeparatedFinder {
 public:
  SeparatedFinder(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                  std::size_t places)
      : triangles_(triangles),
        separator_(triangles, vertex_count),
        places_(places),
        position_(vertex_count, kNoNumber) {}

  CommandStream find() {
    Numbers all(triangles_.size());
    std::iota(all.begin(), all.end(), 0u);
    if (!all.empty()) divide(all);
    return std::move(stream_);
  }

 private:
  // Draws a part with an empty stack. If it does not fit, its halves do not know of each other.
  void divide(const Numbers& part) {
    if (part.size() == 1 || may_fit(part)) return draw_part(part);
    const Separator::Halves halves = separator_.halve(part);
    divide(halves.first);
    divide(halves.second);
  }

  // Parts with more vertices than the square of the places never fit: their separators are too long.
  bool may_fit(const Numbers& part) {
    return separator_.count_vertices(part) <= places_ * places_ &&
           separator_.find_room(part, places_) <= places_;
  }

  void draw_part(const Numbers& part) {
    const std::size_t depth = stack_.size();
    if (part.size() == 1 || separator_.count_vertices(part) <= places_ - depth) {
      for (const std::uint32_t triangle : part) draw(triangle);
    } else {
      const Separator::Halves halves = separator_.halve(part);
      for (const std::uint32_t vertex : halves.shared) push(vertex);
      separator_.set_stacked(halves.shared, true);
      draw_part(halves.first);
      draw_part(halves.second);
      separator_.set_stacked(halves.shared, false);
    }
    pop_to(depth);
  }

  void draw(std::uint32_t number) {
    const render::MeshTriangle& triangle = triangles_[number];
    for (const std::uint32_t vertex : triangle)
      if (position_[vertex] == kNoNumber) push(vertex);
    const auto position = [&](std::size_t corner) {
      return static_cast<std::uint8_t>(position_[triangle[corner]]);
    };
    stream_.commands.push_back({StackCommand::Kind::kDraw, {position(0), position(1), position(2)}, number});
  }

  void push(std::uint32_t vertex) {
    position_[vertex] = static_cast<std::uint32_t>(stack_.size());
    stack_.push_back(vertex);
    stream_.commands.push_back({StackCommand::Kind::kPush, {}, vertex});
    ++stream_.pushes;
  }

  void pop_to(std::size_t depth) {
    if (depth == stack_.size()) return;
    const auto count = static_cast<std::uint32_t>(stack_.size() - depth);
    stream_.commands.push_back({StackCommand::Kind::kPop, {}, count});
    for (; stack_.size() > depth; stack_.pop_back()) position_[stack_.back()] = kNoNumber;
  }

  const std::span<const render::MeshTriangle> triangles_;
  Separator separator_;
  const std::size_t places_;
  Numbers position_;  // by vertex: in the stack, or kNoNumber
  Numbers stack_;
  CommandStream stream_;
};

}  // namespace

CommandStream find_separated_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                    std::size_t places) {
  CHECK(places >= kMinStack && places <= kMaxStack, "{} places", places);
  return SeparatedFinder(triangles, vertex_count, places).find();
}

CommandStream find_command_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                  std::size_t places) {
  CommandStream greedy = find_greedy_stream(triangles, vertex_count, places);
  CommandStream separated = find_separated_stream(triangles, vertex_count, places);
  return greedy.pushes <= separated.pushes ? std::move(greedy) : std::move(separated);
}

}  // namespace temblor::lab

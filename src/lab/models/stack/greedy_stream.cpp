#include <algorithm>

#include "base/check.h"
#include "lab/models/stack/command_stream.h"

namespace temblor::lab {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;
// Trial runs for each full stack.
constexpr std::size_t kMaxTrials = 16;
// The next vertex is chosen from so many triangles of each vertex. The middle of a fan has more.
constexpr std::size_t kMaxLooks = 32;

// The triangles of each vertex, once each.
class VertexTriangles {
 public:
  VertexTriangles(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count)
      : first_(vertex_count + 1) {
    for (const render::MeshTriangle& triangle : triangles)
      for_each_vertex(triangle, [&](std::uint32_t vertex) { ++first_[vertex + 1]; });
    for (std::size_t i = 0; i < vertex_count; ++i) first_[i + 1] += first_[i];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    numbers_.resize(first_.back());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for_each_vertex(triangles[i], [&](std::uint32_t vertex) { numbers_[next[vertex]++] = i; });
  }

  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    return std::span(numbers_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

  template <typename Use>
  static void for_each_vertex(const render::MeshTriangle& triangle, Use use) {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::find(triangle.begin(), triangle.begin() + i, triangle[i]) == triangle.begin() + i)
        use(triangle[i]);
  }

 private:
  std::vector<std::uint32_t> first_, numbers_;
};

class GreedyFinder {
 public:
  GreedyFinder(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count, std::size_t places)
      : triangles_(triangles),
        of_vertex_(triangles, vertex_count),
        places_(places),
        is_drawn_(triangles.size()),
        missing_(triangles.size()),
        undrawn_(vertex_count),
        position_(vertex_count, kNone),
        first_undrawn_of_(vertex_count) {
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      VertexTriangles::for_each_vertex(triangles[i], [&](std::uint32_t vertex) {
        ++missing_[i];
        ++undrawn_[vertex];
      });
  }

  CommandStream find() {
    while (drawn_.size() < triangles_.size()) {
      if (advance()) continue;
      if (stack_.size() == places_)
        pop_to(choose_depth());
      else
        begin_again();
    }
    return std::move(stream_);
  }

 private:
  // Pushes the vertex that completes most triangles. False: the stack is full, or has no neighbors.
  bool advance() {
    std::size_t depth = stack_.size();
    while (depth > 0 && undrawn_[stack_[depth - 1]] == 0) --depth;
    pop_to(depth);
    if (stack_.size() == places_) return false;
    const std::uint32_t vertex = choose_vertex();
    if (vertex == kNone) return false;
    push(vertex);
    return true;
  }

  // Among vertices that complete equally many triangles, one that has few others left, near the top.
  std::uint32_t choose_vertex() {
    std::uint32_t best = kNone;
    std::size_t best_completed = 0, best_left = 0;
    for (std::size_t i = stack_.size(); i-- > 0;) {
      std::size_t looks = 0;
      for (const std::uint32_t triangle : find_undrawn(stack_[i])) {
        if (is_drawn_[triangle]) continue;
        if (looks++ == kMaxLooks) break;
        for (const std::uint32_t vertex : triangles_[triangle]) {
          if (position_[vertex] != kNone || vertex == best) continue;
          const std::size_t completed = missing_[triangle] == 1 ? count_completed(vertex) : 0;
          const std::size_t left = undrawn_[vertex] - completed;
          if (best != kNone &&
              (completed < best_completed || (completed == best_completed && left >= best_left)))
            continue;
          best = vertex;
          best_completed = completed;
          best_left = left;
        }
      }
    }
    return best;
  }

  // The triangles of the vertex, without those at the beginning that are drawn.
  std::span<const std::uint32_t> find_undrawn(std::uint32_t vertex) {
    const auto triangles = of_vertex_[vertex];
    std::uint32_t& io_first = first_undrawn_of_[vertex];
    if (!is_trial_)
      while (io_first < triangles.size() && is_drawn_[triangles[io_first]]) ++io_first;
    return triangles.subspan(io_first);
  }

  std::size_t count_completed(std::uint32_t vertex) const {
    std::size_t count = 0;
    for (const std::uint32_t triangle : of_vertex_[vertex])
      count += !is_drawn_[triangle] && missing_[triangle] == 1;
    return count;
  }

  // Begins at a triangle that is not drawn yet, with its vertex that has the fewest triangles left.
  void begin_again() {
    pop_to(0);
    while (is_drawn_[first_undrawn_]) ++first_undrawn_;
    const render::MeshTriangle& triangle = triangles_[first_undrawn_];
    push(*std::ranges::min_element(triangle, {}, [&](std::uint32_t vertex) { return undrawn_[vertex]; }));
  }

  // The depth from which a trial run, until the stack is full again, draws most triangles per push. The state
  // is as before afterwards.
  std::size_t choose_depth() {
    const std::vector<std::uint32_t> full = stack_;
    const std::size_t drawn = drawn_.size(), commands = stream_.commands.size(), pushes = stream_.pushes;
    const std::size_t step = (places_ + kMaxTrials - 1) / kMaxTrials;
    std::size_t best_depth = 0, best_drawn = 0, best_pushes = 1;
    is_trial_ = true;
    for (std::size_t depth = 0; depth < places_; depth += step) {
      pop_to(depth);
      while (stream_.pushes - pushes < places_ && advance()) {
      }
      const std::size_t trial_drawn = drawn_.size() - drawn, trial_pushes = stream_.pushes - pushes;
      if (trial_drawn * best_pushes > best_drawn * trial_pushes) {
        best_depth = depth;
        best_drawn = trial_drawn;
        best_pushes = trial_pushes;
      }
      undo(drawn, full);
      stream_.commands.resize(commands);
      stream_.pushes = pushes;
    }
    is_trial_ = false;
    return best_depth;
  }

  void undo(std::size_t drawn, std::span<const std::uint32_t> stack) {
    for (; drawn_.size() > drawn; drawn_.pop_back()) {
      is_drawn_[drawn_.back()] = false;
      VertexTriangles::for_each_vertex(triangles_[drawn_.back()],
                                       [&](std::uint32_t vertex) { ++undrawn_[vertex]; });
    }
    const auto same = std::ranges::mismatch(stack_, stack).in1 - stack_.begin();
    pop_to(static_cast<std::size_t>(same));
    for (const std::uint32_t vertex : stack.subspan(stack_.size())) place(vertex);
  }

  void place(std::uint32_t vertex) {
    position_[vertex] = static_cast<std::uint32_t>(stack_.size());
    stack_.push_back(vertex);
    for (const std::uint32_t triangle : of_vertex_[vertex]) --missing_[triangle];
  }

  void push(std::uint32_t vertex) {
    stream_.commands.push_back({StackCommand::Kind::kPush, {}, vertex});
    ++stream_.pushes;
    place(vertex);
    for (const std::uint32_t triangle : of_vertex_[vertex])
      if (missing_[triangle] == 0 && !is_drawn_[triangle]) draw(triangle);
  }

  void draw(std::uint32_t triangle) {
    const auto position = [&](std::size_t corner) {
      return static_cast<std::uint8_t>(position_[triangles_[triangle][corner]]);
    };
    stream_.commands.push_back(
        {StackCommand::Kind::kDraw, {position(0), position(1), position(2)}, triangle});
    is_drawn_[triangle] = true;
    drawn_.push_back(triangle);
    VertexTriangles::for_each_vertex(triangles_[triangle], [&](std::uint32_t vertex) { --undrawn_[vertex]; });
  }

  void pop_to(std::size_t depth) {
    if (depth == stack_.size()) return;
    stream_.commands.push_back(
        {StackCommand::Kind::kPop, {}, static_cast<std::uint32_t>(stack_.size() - depth)});
    for (; stack_.size() > depth; stack_.pop_back()) {
      position_[stack_.back()] = kNone;
      for (const std::uint32_t triangle : of_vertex_[stack_.back()]) ++missing_[triangle];
    }
  }

  const std::span<const render::MeshTriangle> triangles_;
  const VertexTriangles of_vertex_;
  const std::size_t places_;
  std::vector<bool> is_drawn_;
  std::vector<std::uint32_t> drawn_;             // triangles, in order
  std::vector<std::uint8_t> missing_;            // by triangle: its vertices that are not in the stack
  std::vector<std::uint32_t> undrawn_;           // by vertex: its triangles that are not drawn yet
  std::vector<std::uint32_t> position_;          // by vertex: in the stack, or kNone
  std::vector<std::uint32_t> first_undrawn_of_;  // by vertex: how many of its triangles are skipped
  std::vector<std::uint32_t> stack_;
  bool is_trial_ = false;
  std::size_t first_undrawn_ = 0;  // no triangle before it is left
  CommandStream stream_;
};

}  // namespace

CommandStream find_greedy_stream(std::span<const render::MeshTriangle> triangles, std::size_t vertex_count,
                                 std::size_t places) {
  CHECK(places >= kMinStack && places <= kMaxStack, "{} places", places);
  return GreedyFinder(triangles, vertex_count, places).find();
}

}  // namespace temblor::lab

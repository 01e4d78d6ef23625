// Six slabs around each space, less all spaces, then cut where a side borders on more than one.
#include "artgen/level_script/carve.h"

#include <algorithm>
#include <optional>

namespace temblor::artgen {
namespace {

std::vector<Box> boxes_of(std::span<const Space> spaces) {
  std::vector<Box> boxes;
  for (const Space& space : spaces) boxes.push_back(space.box);
  return boxes;
}

// What of a slab's side is seen from within the space: as a box of no depth in the axis of the side.
std::optional<Box> contact(const Box& piece, Side side, const Box& space) {
  if (piece.at(side) != space.at(opposite(side))) return {};
  Box shared = common(piece, space);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != axis_of(side) && shared.low[axis] >= shared.high[axis]) return {};
  return shared;
}

bool covers(const Box& shared, const Box& piece, Side side) {
  for (int axis = 0; axis < 3; ++axis)
    if (axis != axis_of(side) && (shared.low[axis] > piece.low[axis] || shared.high[axis] < piece.high[axis]))
      return false;
  return true;
}

// Cuts the piece in two along an edge of the shared part.
std::pair<Box, Box> cut_along(const Box& piece, Side side, const Box& shared) {
  std::pair<Box, Box> two(piece, piece);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == axis_of(side)) continue;
    for (const int place : {shared.low[axis], shared.high[axis]}) {
      if (place <= piece.low[axis] || place >= piece.high[axis]) continue;
      two.first.high[axis] = place;
      two.second.low[axis] = place;
      return two;
    }
  }
  return two;
}

// The last space that the side borders on, and whether it does so all over or alone.
struct Border {
  const Space* space = nullptr;
  std::optional<Box> cut;  // where not
};

Border border_of(std::span<const Space> spaces, const Box& piece, Side side) {
  Border border;
  for (std::size_t i = spaces.size(); i-- > 0;) {
    const Space& space = spaces[i];
    const std::optional<Box> shared = contact(piece, side, space.box);
    if (!shared) continue;
    if (border.space == nullptr) {
      border.space = &space;
      if (covers(*shared, piece, side)) return border;
      border.cut = shared;
      continue;
    }
    const Look& look = space.walls[index_of(opposite(side))];
    if (!(look == border.space->walls[index_of(opposite(side))])) return border;
  }
  border.cut.reset();  // one look all over, or nothing beside it that anyone sees
  return border;
}

bool is_sky(const Look& look) {
  return look.texture.starts_with("sky");
}

// The looks of a piece, or where to cut it so that each of its sides has one.
std::optional<std::pair<Box, Box>> look_around(std::span<const Space> spaces, const Box& piece,
                                               Looks& io_looks) {
  for (const Side side : kSides) {
    const Border border = border_of(spaces, piece, side);
    if (border.space == nullptr) continue;
    if (border.cut) return cut_along(piece, side, *border.cut);
    io_looks[index_of(side)] = border.space->walls[index_of(opposite(side))];
  }
  return {};
}

// A slab of the space's side; wide enough to hold the corners.
Box slab(const Box& space, Side side) {
  Box box = space;
  const int axis = axis_of(side);
  (is_upper(side) ? box.high : box.low)[axis] += is_upper(side) ? kShellThickness : -kShellThickness;
  (is_upper(side) ? box.low : box.high)[axis] = space.at(side);
  for (int across = 0; across < axis; ++across) {
    box.low[across] -= kShellThickness;
    box.high[across] += kShellThickness;
  }
  return box;
}

// What borders on sky alone is sky as a whole; what borders on something else, too, can't be.
void make_sky_or_none(std::span<const Space> spaces, const Box& piece, const Look& look, Looks& io_looks) {
  const Look* sky = nullptr;
  bool all = true;
  for (const Side side : kSides) {
    const Border border = border_of(spaces, piece, side);
    if (border.space == nullptr) continue;
    const Look& seen = border.space->walls[index_of(opposite(side))];
    all &= is_sky(seen);
    if (is_sky(seen)) sky = &seen;
  }
  if (sky != nullptr && all) {
    io_looks.fill(*sky);
    return;
  }
  for (Look& other : io_looks)
    if (is_sky(other) && !is_sky(look)) other = look;
}

void add_pieces(std::span<const Space> spaces, const Space& space, const Look& look, const Box& piece,
                std::vector<Solid>& io_solids) {
  Solid solid{corners_of(piece), {}, space.line};
  solid.looks.fill(look);
  // The sky is sky all around: where it borders on something else, that has a slab of its own there.
  if (!is_sky(look))
    if (const auto two = look_around(spaces, piece, solid.looks)) {
      add_pieces(spaces, space, look, two->first, io_solids);
      add_pieces(spaces, space, look, two->second, io_solids);
      return;
    }
  make_sky_or_none(spaces, piece, look, solid.looks);
  io_solids.push_back(std::move(solid));
}

}  // namespace

std::vector<Solid> carve_shell(std::span<const Space> spaces) {
  const std::vector<Box> holes = boxes_of(spaces);
  std::vector<Solid> solids;
  for (const Space& space : spaces)
    for (const Side side : kSides) {
      const Box box = slab(space.box, side);
      std::vector<Box> near;
      for (const Box& hole : holes)
        if (common(hole, box).has_volume()) near.push_back(hole);
      for (const Box& piece : without(box, near))
        add_pieces(spaces, space, space.walls[index_of(side)], piece, solids);
    }
  return solids;
}

bool is_open(std::span<const Space> spaces, const Box& box) {
  return without(box, boxes_of(spaces)).empty();
}

}  // namespace temblor::artgen

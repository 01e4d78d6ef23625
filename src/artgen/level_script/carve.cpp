// Method: make six slabs around each space, subtract all spaces from them, and split the pieces until each
// side borders on spaces with the same texture only.
//
//   +--------------------+        The slab above the left space is split where
//   |  slab   |   slab   |        the side that it shows to the spaces changes
//   +----+----+-----+----+        its texture.
//   |  space  |  space   |
#include "artgen/level_script/carve.h"

#include <algorithm>
#include <optional>

namespace temblor::artgen {
namespace {

std::vector<Box> list_boxes(std::span<const Space> spaces) {
  std::vector<Box> boxes;
  for (const Space& space : spaces) boxes.push_back(space.box);
  return boxes;
}

// The part of a piece's side that borders on the space, as a box without depth on the side's axis. Nothing if
// they do not touch.
std::optional<Box> find_contact(const Box& piece, Side side, const Box& space) {
  if (piece.at(side) != space.at(opposite(side))) return {};
  Box shared = intersect(piece, space);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != side_axis(side) && shared.low[axis] >= shared.high[axis]) return {};
  return shared;
}

// Whether the contact covers the whole side of the piece.
bool contains_side(const Box& shared, const Box& piece, Side side) {
  for (int axis = 0; axis < 3; ++axis)
    if (axis != side_axis(side) &&
        (shared.low[axis] > piece.low[axis] || shared.high[axis] < piece.high[axis]))
      return false;
  return true;
}

// Splits the piece at an edge of the contact. Returns the piece twice if no edge crosses it.
std::pair<Box, Box> cut_along(const Box& piece, Side side, const Box& shared) {
  std::pair<Box, Box> two(piece, piece);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == side_axis(side)) continue;
    for (const int position : {shared.low[axis], shared.high[axis]}) {
      if (position <= piece.low[axis] || position >= piece.high[axis]) continue;
      two.first.high[axis] = position;
      two.second.low[axis] = position;
      return two;
    }
  }
  return two;
}

// The last space that a piece's side borders on, and where to cut the piece if the side borders on other
// looks, too.
struct Border {
  const Space* space = nullptr;
  std::optional<Box> cut;
};

// Later spaces come first, because they decide where spaces overlap.
Border find_border(std::span<const Space> spaces, const Box& piece, Side side) {
  Border border;
  for (std::size_t i = spaces.size(); i-- > 0;) {
    const Space& space = spaces[i];
    const std::optional<Box> shared = find_contact(piece, side, space.box);
    if (!shared) continue;
    if (border.space == nullptr) {
      border.space = &space;
      if (contains_side(*shared, piece, side)) return border;
      border.cut = shared;
      continue;
    }
    const Look& look = space.walls[side_index(opposite(side))];
    if (!(look == border.space->walls[side_index(opposite(side))])) return border;
  }
  // The whole visible part of the side has one look; no cut is needed.
  border.cut.reset();
  return border;
}

// Quake treats textures whose name begins with "sky" as sky.
bool is_sky(const Look& look) {
  return look.texture.starts_with("sky");
}

// Sets the look of each side, or returns the two halves of the piece if a side needs more than one.
std::optional<std::pair<Box, Box>> find_looks(std::span<const Space> spaces, const Box& piece,
                                              Looks& io_looks) {
  for (const Side side : kSides) {
    const Border border = find_border(spaces, piece, side);
    if (border.space == nullptr) continue;
    if (border.cut) return cut_along(piece, side, *border.cut);
    io_looks[side_index(side)] = border.space->walls[side_index(opposite(side))];
  }
  return {};
}

// The slab on one side of a space. Slabs on later axes extend over the edges of earlier ones, so that corners
// are filled.
Box make_slab(const Box& space, Side side) {
  Box box = space;
  const int axis = side_axis(side);
  (is_upper(side) ? box.high : box.low)[axis] += is_upper(side) ? kShellThickness : -kShellThickness;
  (is_upper(side) ? box.low : box.high)[axis] = space.at(side);
  for (int across = 0; across < axis; ++across) {
    box.low[across] -= kShellThickness;
    box.high[across] += kShellThickness;
  }
  return box;
}

// A brush is sky on all sides or on none: it becomes sky only if all spaces that it borders on show sky
// there.
void fix_sky_looks(std::span<const Space> spaces, const Box& piece, const Look& look, Looks& io_looks) {
  const Look* sky = nullptr;
  bool all = true;
  for (const Side side : kSides) {
    const Border border = find_border(spaces, piece, side);
    if (border.space == nullptr) continue;
    const Look& seen = border.space->walls[side_index(opposite(side))];
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

// Splits the piece recursively until each of its sides has one look.
void add_pieces(std::span<const Space> spaces, const Space& space, const Look& look, const Box& piece,
                std::vector<Solid>& io_solids) {
  Solid solid{list_corners(piece), {}, space.line};
  solid.looks.fill(look);
  // A sky slab is not split: where it borders on other spaces, those have slabs of their own.
  if (!is_sky(look))
    if (const auto two = find_looks(spaces, piece, solid.looks)) {
      add_pieces(spaces, space, look, two->first, io_solids);
      add_pieces(spaces, space, look, two->second, io_solids);
      return;
    }
  fix_sky_looks(spaces, piece, look, solid.looks);
  io_solids.push_back(std::move(solid));
}

}  // namespace

std::vector<Solid> carve_shell(std::span<const Space> spaces) {
  const std::vector<Box> holes = list_boxes(spaces);
  std::vector<Solid> solids;
  for (const Space& space : spaces)
    for (const Side side : kSides) {
      const Box box = make_slab(space.box, side);
      // Most spaces do not touch the slab.
      std::vector<Box> near;
      for (const Box& hole : holes)
        if (intersect(hole, box).has_volume()) near.push_back(hole);
      for (const Box& piece : subtract(box, near))
        add_pieces(spaces, space, space.walls[side_index(side)], piece, solids);
    }
  return solids;
}

bool is_open(std::span<const Space> spaces, const Box& box) {
  return subtract(box, list_boxes(spaces)).empty();
}

}  // namespace temblor::artgen

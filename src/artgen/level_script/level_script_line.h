// Reads one line of a level script: positions and boxes in the coordinates of its scope, sides, and textures.
// All other values are read like those of any script (scripts/script.h).
//
// A position is X,Y or X,Y,Z. Each coordinate is a whole number, `mid`, or `end` (the center or far side of
// the room), or one of these plus or minus a number: mid,end-32,96. A box is a position, then `to` and the
// opposite corner, or `size` and WxDxH.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "artgen/level_script/level_script.h"
#include "artgen/scripts/script.h"

namespace temblor::artgen {

// Like Arguments, keeps only the first problem and returns defaults afterwards; finish() returns the problem.
class LevelScriptLine {
 public:
  // Both must outlive this.
  LevelScriptLine(const ScriptLine& line, const Scope& scope)
      : line_(line), scope_(scope), arguments_(line) {}
  LevelScriptLine(const ScriptLine& line, const Scope&& scope) = delete;

  // Positional values: each call reads the next one. Results are in the scope's coordinates.
  Point position(int default_z = 0);
  // A box without a volume is a problem.
  Box box();
  // Whether the next value is a position, which may begin a box.
  bool is_box_next() const;
  Box box_or(const Box& fallback);
  // A position on a wall of the room, ALONG,Z: the coordinate along the wall and the height. wall_box also
  // reads `size WxH` and returns a box that protrudes `depth` units from the wall.
  Point wall_position(Side side);
  Box wall_box(Side side, int depth);
  // Whether the next value has two coordinates.
  bool is_wall_position_next() const;
  std::string next_text();
  std::optional<std::string> next_text_if_present();
  // "north", "up", and so on.
  Side side();

  // Settings by name.
  bool has(std::string_view name) const { return arguments_.has(name); }
  // $ is replaced by the scope's copy name.
  std::string text(std::string_view name, std::string_view fallback);
  int integer(std::string_view name, int fallback, int lowest, int highest);
  double number(std::string_view name, double fallback, double lowest, double highest);
  bool flag(std::string_view name) { return arguments_.flag(name); }
  Point position(std::string_view name, Point fallback);
  Side side(std::string_view name, Side fallback);
  // A compass point, or degrees with 0 as east and 90 as north, rotated with the scope.
  std::optional<double> facing(std::string_view name);
  // Reads floor=, ceiling=, walls=, and the settings of single walls, such as north=.
  Surfaces surfaces(Surfaces fallback);
  // The look of a solid: an optional texture name as the next value, top=, side=, bottom=, scale=, shift=S,T,
  // and align=self or room. Missing textures are `fallback`.
  Looks looks(const Box& box_world, std::string_view fallback);

  void set_error(std::string_view what) { arguments_.set_error(what); }
  base::Status finish() const { return arguments_.finish(); }

  const ScriptLine& line() const { return line_; }
  const Scope& scope() const { return scope_; }
  // From the scope's coordinates to the level's.
  Box to_world(const Box& box) const { return scope_.placement.apply(box); }
  // Replaces each $ by the scope's copy name.
  std::string substitute_copy(std::string_view text) const;

 private:
  Point parse_position(const std::string& text, int default_z);
  int parse_coordinate(std::string_view text, int axis);

  const ScriptLine& line_;
  const Scope& scope_;
  Arguments arguments_;
  // The index of the next positional value.
  std::size_t next_index_ = 0;
};

// The side for "north" and so on; nothing for other words.
std::optional<Side> find_side(std::string_view name);

}  // namespace temblor::artgen

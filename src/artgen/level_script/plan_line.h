// One line of a plan, read: its places in the coordinates of where it stands, the rest as any script's.
//
// A place is X,Y or X,Y,Z; each of them a whole number, or `mid` or `end` of the room with or without one:
// mid,end-32,96. A box is a place, then `to` and its other corner, or `size` and WxDxH.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "artgen/level_script/plan.h"
#include "artgen/scripts/script.h"

namespace temblor::artgen {

class PlanLine {
 public:
  // Both must outlive it.
  PlanLine(const ScriptLine& line, const Scope& scope) : line_(line), scope_(scope), arguments_(line) {}
  PlanLine(const ScriptLine& line, const Scope&& scope) = delete;

  // By place, each call the next. In the scope's coordinates.
  Point place(int z_otherwise = 0);
  Box box();                 // with a volume, or it is wrong
  bool box_is_next() const;  // or a place
  Box box_or(const Box& otherwise);
  // On a wall of the room: how far along it and how high, ALONG,Z; with a size, WxH, a box that deep before
  // it.
  Point place_on_wall(Side side);
  Box box_on_wall(Side side, int depth);
  bool on_wall_is_next() const;  // a place of two coordinates
  std::string word();
  std::optional<std::string> word_if_there();
  // "north", "up" ... as a side of what the line is about.
  Side side();

  // By name.
  bool has(std::string_view name) const { return arguments_.has(name); }
  std::string text(std::string_view name, std::string_view otherwise);  // $ replaced
  int whole(std::string_view name, int otherwise, int lowest, int highest);
  double number(std::string_view name, double otherwise, double lowest, double highest);
  bool flag(std::string_view name) { return arguments_.flag(name); }
  Point place(std::string_view name, Point otherwise);
  Side side(std::string_view name, Side otherwise);
  // A compass point or degrees, 0 east and 90 north; turned as the scope is.
  std::optional<double> facing(std::string_view name);
  // floor=, walls=, ceiling=, north= and so on.
  Surfaces surfaces(Surfaces otherwise);
  // What a solid looks like: a texture's name if one is next, top=, side=, bottom=, scale=, shift=S,T,
  // align=room; or textures of the name's kind.
  Looks looks(const Box& box_world, std::string_view otherwise);

  void complain(std::string_view what) { arguments_.complain(what); }
  base::Status finish() const { return arguments_.finish(); }

  const ScriptLine& line() const { return line_; }
  const Scope& scope() const { return scope_; }
  Box to_world(const Box& box) const { return scope_.placement.apply(box); }
  std::string with_copy(std::string_view text) const;

 private:
  Point parse_place(const std::string& text, int z_otherwise);
  int parse_coordinate(std::string_view text, int axis);

  const ScriptLine& line_;
  const Scope& scope_;
  Arguments arguments_;
  std::size_t taken_ = 0;  // values
};

// "north" and the like; nothing for other words.
std::optional<Side> side_named(std::string_view name);

}  // namespace temblor::artgen

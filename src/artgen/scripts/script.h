// Scripts: the text that the shipped game's art, sound and levels are made from (game/art, game/plans).
//
//   # what follows a sharp is for people
//   texture brick_old 64x64            a line at the left edge begins a thing
//     bricks width=32 height=16        what is indented belongs to the line above
//     shade "from above" by=0.2        values by place, then settings by name; blanks need quotes
//
// Each line is a word, values by place and settings by name; what they mean is up to who reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::artgen {

struct ScriptLine {
  std::int32_t number = 0;  // from 1
  std::string part = {};    // that the line comes from (parts.h); empty: the thing's own
  std::string word;
  std::vector<std::string> values;
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<ScriptLine> below;  // the lines indented under it
};

// Blanks indent, tabs do not; lines under one line all start in one column. Errors name the line.
base::Result<std::vector<ScriptLine>> read_script(std::string_view text);

// An error about a line: "line 12: texture: ...", or "part NAME, line 12: ...".
base::Error script_error(const ScriptLine& line, std::string_view what);

// What a line says, asked for by type and checked: the first thing that is wrong is kept, the questions after
// it get their default, and finish() tells; it also minds values and settings that nobody asked for, misspelt
// ones mostly.
//
//   Arguments arguments(line);
//   const double width = arguments.number("width", 32, 1, 256);
//   TRY_STATUS(arguments.finish());
class Arguments {
 public:
  explicit Arguments(const ScriptLine& line) : line_(line) {}  // which must outlive it

  // By place, each call the next one. Those without a default must be there.
  std::string text();
  std::optional<std::string> text_if_there();
  double number(double lowest, double highest);
  math::Vec3 vector();                                               // "1,2,3"
  std::pair<std::int32_t, std::int32_t> size(std::int32_t highest);  // "64x32", each from 1

  // By name. `name` must outlive this: a literal.
  bool has(std::string_view name) const;
  std::string text(std::string_view name, std::string_view otherwise);
  double number(std::string_view name, double otherwise, double lowest, double highest);
  std::int32_t integer(std::string_view name, std::int32_t otherwise, std::int32_t lowest,
                       std::int32_t highest);
  bool flag(std::string_view name);  // name=yes or name=no; no where it is missing
  math::Vec3 vector(std::string_view name, const math::Vec3& otherwise);
  // "0.2..0.6", or one number for both.
  std::pair<double, double> range(std::string_view name, std::pair<double, double> otherwise);

  // Keeps it, unless something was wrong before.
  void complain(std::string_view what);
  base::Status finish() const;

 private:
  const std::string* setting(std::string_view name);
  const std::string* next_value(std::string_view kind);
  double checked(std::string_view what, double value, double lowest, double highest);

  const ScriptLine& line_;
  std::size_t next_value_ = 0;
  std::vector<std::string_view> asked_;
  std::optional<std::string> wrong_;
};

// All of the text as a finite number.
std::optional<double> number_in(std::string_view text);

}  // namespace temblor::artgen

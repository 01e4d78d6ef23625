// The text format of all scripts (game/art, game/maps): indented lines of words.
//
//   # a comment
//   texture brick_old 64x64            a line at the left edge begins an asset
//     bricks width=32 height=16        indented lines belong to the line above
//     shade "from above" by=0.2        positional values, then settings; quote values that contain blanks
//
// A line consists of a keyword, values, and NAME=VALUE settings. This part only parses lines; their readers
// decide what the words mean. It depends on `base` and `math` only.
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

// A line with everything indented under it.
struct ScriptLine {
  // The line's number in its file, from 1.
  std::int32_t number = 0;
  // The part that the line was inserted from (parts.h). Empty: the line belongs to the asset itself.
  std::string part = {};
  std::string keyword;
  // In the order of the text. Settings may repeat a name; readers see the first.
  std::vector<std::string> values;
  std::vector<std::pair<std::string, std::string>> settings;
  // The lines that are indented under this one, in their order.
  std::vector<ScriptLine> below;
};

// Parses a script and returns the lines at the left edge. Lines end with LF or CR LF; blank lines and
// comments are dropped. Lines under the same line must start in the same column. Fails for tabs in a line,
// for unmatched quotes, and for an indentation that matches no line above; the error names the line.
base::Result<std::vector<ScriptLine>> read_script(std::string_view text);

// Builds an error about a line: "line 12: texture: WHAT", or "part NAME, line 12: texture: WHAT".
base::Error script_error(const ScriptLine& line, std::string_view what);

// Reads the values and settings of one line by type and checks them. Only the first problem is kept.
// Afterwards, reads return defaults, so that a reader needs no error handling of its own; finish() returns
// the problem. finish() also fails for values and settings that nobody asked for, which usually are
// misspelled.
//
//   Arguments arguments(line);
//   const double width = arguments.number("width", 32, 1, 256);
//   TRY_STATUS(arguments.finish());
class Arguments {
 public:
  // `line` must outlive this.
  explicit Arguments(const ScriptLine& line) : line_(line) {}

  // Positional values: each call reads the next one. A missing value is a problem, except for
  // text_if_present.
  std::string text();
  std::optional<std::string> text_if_present();
  double number(double lowest, double highest);
  // "1,2,3"
  math::Vec3 vector();
  // "64x32", each from 1 to `highest`.
  std::pair<std::int32_t, std::int32_t> size(std::int32_t highest);

  // Settings by name. `name` must outlive this, which a literal does. If the setting is missing, the fallback
  // is returned.
  bool has(std::string_view name) const;
  std::string text(std::string_view name, std::string_view fallback);
  double number(std::string_view name, double fallback, double lowest, double highest);
  std::int32_t integer(std::string_view name, std::int32_t fallback, std::int32_t lowest,
                       std::int32_t highest);
  // NAME=yes or NAME=no; no if the setting is missing.
  bool flag(std::string_view name);
  math::Vec3 vector(std::string_view name, const math::Vec3& fallback);
  // "0.2..0.6", or one number for both ends. The ends may be in any order.
  std::pair<double, double> range(std::string_view name, std::pair<double, double> fallback);

  // Records a problem with this line, unless there is one already.
  void set_error(std::string_view what);
  // Call it after all reads. Returns the first problem.
  base::Status finish() const;

 private:
  // Null if the setting is missing. Records that the reader knows this setting.
  const std::string* find_setting(std::string_view name);
  // Null after recording a problem if no value is left. `kind` names what was expected.
  const std::string* next_value(std::string_view kind);
  // Returns the value clamped to the limits and records a problem if it was outside. `what`: the setting's
  // name; empty for a positional value.
  double check_limits(std::string_view what, double value, double lowest, double highest);

  const ScriptLine& line_;
  std::size_t next_value_ = 0;
  std::vector<std::string_view> known_settings_;
  std::optional<std::string> error_;
};

// Parses a finite number that takes up the whole text; nothing otherwise.
std::optional<double> parse_number(std::string_view text);

}  // namespace temblor::artgen

// A row of a page: what it shows, and what it does when the player chooses, changes or clears it. It tells
// what is to happen by a value and calls nobody.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/menu/canvas.h"
#include "platform/input_event.h"

namespace temblor::client {

struct Page;
struct PageContext;
using PageMaker = std::function<Page(const PageContext&)>;

enum class MenuSound { kNone, kMove, kEnter, kAdjust };
enum class Leaving { kStay, kBack, kClose };

// What is to happen, in this order.
struct Outcome {
  MenuSound sound = MenuSound::kNone;
  std::vector<std::string> commands = {};
  Leaving leaving = Leaving::kStay;
  PageMaker page = {};   // opens above what is left
  bool refresh = false;  // the rows of this page depend on what was changed
};

// Where a row stands, and how it is looked at.
struct RowPlace {
  Box box;
  int value_x = 0;  // where the right column begins
  int letters = 1;  // 2: of 16 x 16
  bool selected = false;
  double time_s = 0;
};

// What stands beside a list about the row that is selected.
struct RowDetails {
  const formats::Picture* picture = nullptr;
  std::vector<std::string> paragraphs = {};
};

class Row {
 public:
  virtual ~Row() = default;

  virtual bool can_be_selected() const { return true; }
  // What it is found by when a player types, and when its page is made anew.
  virtual std::string_view label() const = 0;
  virtual std::string_view search_text() const { return label(); }
  virtual std::string help() const { return {}; }
  virtual RowDetails details() const { return {}; }
  virtual void draw(const Canvas& canvas, const RowPlace& place) const = 0;

  virtual Outcome activate() { return {}; }
  virtual Outcome adjust(int /*steps*/) { return {}; }
  // Nothing: there is nothing about it to be cleared.
  virtual std::optional<Outcome> clear() { return std::nullopt; }
  // Text that is typed while it is selected; false: it is not for it.
  virtual bool type(std::string_view /*text*/) { return false; }
  // The letter that stands for it, on pages that are not searched; 0: none does.
  virtual char letter() const { return 0; }

  // Where a pointer that is pressed there moves the value; `fraction`: of the value's box, 0 to 1.
  virtual std::optional<Box> slide_box(const RowPlace& /*place*/) const { return std::nullopt; }
  virtual void slide(double /*fraction*/) {}

  // While it waits for keys, every event is its own first; false: it is not for it.
  virtual bool is_waiting() const { return false; }
  virtual bool wants_text() const { return true; }
  virtual bool take(const platform::InputEvent& /*event*/, Outcome& /*out_outcome*/) { return false; }
  virtual void stop_waiting() {}
};

using Rows = std::vector<std::unique_ptr<Row>>;

}  // namespace temblor::client

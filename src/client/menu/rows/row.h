// A row of a page: what it shows, and what happens when the player activates, changes or clears it. A row
// calls nobody; it returns an Outcome, which the menu applies.
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

// Sounds of the menus: the selection moves, something is chosen, a value changes.
enum class MenuSound { kNone, kMove, kEnter, kAdjust };
// Whether the page stays open, returns to the page below, or closes the menu.
enum class Leaving { kStay, kBack, kClose };

// The menu's next actions, in this order.
struct Outcome {
  MenuSound sound = MenuSound::kNone;
  std::vector<std::string> commands = {};  // console lines
  Leaving leaving = Leaving::kStay;
  PageMaker page = {};   // opens above the pages that are left
  bool refresh = false;  // rebuild the page: other rows depend on the change
};

// Where and how a row is drawn.
struct RowPlace {
  Box box;
  // Where the right column begins, in canvas pixels.
  int value_x = 0;
  // How far the value is below the label; 0: they share a line.
  int value_down = 0;
  // 2: large letters, 16 x 16.
  int letters = 1;
  bool selected = false;
  double time_s = 0;  // for blinking
};

// Shown beside a list about the selected row.
struct RowDetails {
  std::vector<const formats::Picture*> pictures = {};  // null ones are left out
  std::vector<std::string> paragraphs = {};
};

// One row. Pages own their rows. Applying an outcome may rebuild or close the page and destroy the row that
// returned it.
class Row {
 public:
  virtual ~Row() = default;

  virtual bool can_be_selected() const { return true; }
  // Whether the row has a value beside its label, or below it where there is no room.
  virtual bool has_value() const { return false; }
  // The row's text. Also identifies the row when its page is rebuilt.
  virtual std::string_view label() const = 0;
  // The text that the player's search is matched with.
  virtual std::string_view search_text() const { return label(); }
  // One or two sentences below the rows while the row is selected, and details beside them.
  virtual std::string help() const { return {}; }
  virtual RowDetails details() const { return {}; }
  virtual void draw(const Canvas& canvas, const RowPlace& place) const = 0;

  // The player presses Enter or clicks; changes the value by so many steps (left: -1); or clears it.
  virtual Outcome activate() { return {}; }
  virtual Outcome adjust(int /*steps*/) { return {}; }
  // Returns nothing if the row has nothing to clear.
  virtual std::optional<Outcome> clear() { return std::nullopt; }
  // Receives typed text while the row is selected; returns whether the row used it.
  virtual bool type(std::string_view /*text*/) { return false; }
  // The key that activates the row on pages without a search; 0 for none.
  virtual char letter() const { return 0; }

  // The area where a pressed pointer moves the value; nothing if the row has no slider.
  virtual std::optional<Box> slide_box(const RowPlace& /*place*/) const { return std::nullopt; }
  // `fraction`: 0 at the left end of the slide box, 1 at the right end.
  virtual void slide(double /*fraction*/) {}

  // While a row waits for keys or text, it sees every event first; handle() returns whether the row used it.
  // wants_text() is false while typed text is of no use to it. stop_waiting() ends the wait when the player
  // goes elsewhere.
  virtual bool is_waiting() const { return false; }
  virtual bool wants_text() const { return true; }
  virtual bool handle(const platform::InputEvent& /*event*/, Outcome& /*out_outcome*/) { return false; }
  virtual void stop_waiting() {}
};

using Rows = std::vector<std::unique_ptr<Row>>;

}  // namespace temblor::client

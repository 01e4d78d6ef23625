// Feeds arbitrary bytes to the console in three ways: as the commands of a file, as text that a server
// prints, and as keys and typed text. Every run must end, and the drawn and entered text must be well
// formed.
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/check.h"
#include "client/console/console_ui.h"
#include "client/console/utf8.h"
#include "command/console.h"
#include "fuzz/targets.h"

using namespace temblor;

namespace {

class Played {
 public:
  explicit Played(std::string text) : text_(std::move(text)) {
    variables_.add_bool("flag", false, "A flag.");
    variables_.add_int("number", 3, -5, 20, "A number.");
    variables_.add_text("text", "", "A text.");
    console_.set_loader([this](std::string_view) { return base::Result<std::string>(text_); });
  }

  void run() {
    console_.append(text_);
    for (int frame = 0; frame < 4; ++frame) console_.run();
    for (const command::Variable* variable : variables_.all())
      CHECK(command::has_value(*variable, variable->text), "{}", variable->name);
  }

  void print() {
    ui_.print(text_, time_s_);
    ui_.print_utf8(text_, time_s_);
    for (const char c : ui_.text()) CHECK(c == '\n' || (c >= ' ' && c <= '~'));
  }

  // A byte is a key or starts some text.
  void press() {
    ui_.open();
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const auto byte = static_cast<std::uint8_t>(text_[i]);
      const platform::Key key{static_cast<std::uint16_t>(byte % platform::kKeys)};
      ui_.handle({time_s_, platform::KeyChange{key, i % 5 != 0, false}});
      if (byte >= ' ') ui_.handle({time_s_, platform::TextTyped{text_.substr(i, 1 + byte % 8)}});
      if (i % 16 == 0) draw(1 + byte * 3, 1 + byte);
      if (byte == 0) ui_.begin_chat(true);
      if (byte == 1) ui_.toggle();
    }
    for (const std::string& line : ui_.take_commands())
      CHECK(client::sanitize_typed_text(line) == line && line.size() < 5000);
    client::ConsoleUi other{{}};
    other.load_history(ui_.history_text());
    CHECK(other.history_text() == ui_.history_text());
  }

 private:
  void draw(int width, int height) {
    time_s_ += 0.1;
    list_.clear();
    ui_.draw({.pictures = pictures_, .time_s = time_s_, .version = "1", .settings = {}}, width, height,
             list_);
    for (const render::DrawCommand& command : list_.commands)
      CHECK(command.scale >= 1 && command.area.width >= 0 && command.area.height >= 0);
  }

  std::string text_;
  command::Variables variables_;
  command::Console console_{variables_, [this](std::string_view line) { ui_.print_utf8(line, time_s_); }};
  client::ConsoleUi ui_{{.complete = [this](std::string_view line) { return console_.complete_line(line); },
                         .read_clipboard = [this] { return text_; },
                         .write_clipboard = nullptr}};
  assets::Pictures pictures_;
  render::DrawList list_;
  double time_s_ = 0;
};

}  // namespace

int temblor::fuzz::fuzz_console(const std::uint8_t* data, std::size_t size) {
  const auto text = base::as_text(std::as_bytes(std::span(data, size)));
  Played played{std::string(text)};
  played.run();
  played.print();
  played.press();
  return 0;
}

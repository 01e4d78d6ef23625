// Settings: each row is a console variable, but for the display's size and mode, which are tried together.
#include <fmt/format.h>

#include <algorithm>

#include "client/menu/page.h"
#include "client/menu/pages/option_tables.h"
#include "client/menu/rows/binding_row.h"
#include "client/menu/rows/choice_rows.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {
namespace {

using Video = MenuChoices::Video;

// Of those that are registered.
std::vector<std::string> resets(const command::Variables& variables, std::span<const OptionLook> looks) {
  std::vector<std::string> lines;
  for (const OptionLook& look : looks)
    if (variables.find(look.variable) != nullptr) lines.push_back(fmt::format("reset {}", look.variable));
  return lines;
}

void add_options(const PageContext& context, std::span<const OptionLook> looks, Page& io_page) {
  for (const OptionLook& look : looks)
    if (std::unique_ptr<Row> row = make_option_row(context.variables, look))
      io_page.rows.push_back(std::move(row));
  std::vector<std::string> lines = resets(context.variables, looks);
  if (lines.empty()) return;
  io_page.rows.push_back(std::make_unique<ActionRow>(
      "Back to defaults",
      [lines] {
        return Outcome{
            .page = ask("Set everything on this page back to what it was at first?", {.commands = lines})};
      },
      "Sets what is on this page back."));
}

Page make_table_page(const PageContext& context, std::string title, std::span<const OptionLook> looks) {
  Page page;
  page.title = std::move(title);
  page.nothing = "There is nothing to set.";
  add_options(context, looks, page);
  return page;
}

constexpr const char *kWidth = "vid_width", *kHeight = "vid_height", *kMode = "vid_mode",
                     *kDisplay = "vid_display";

Video video_now(const command::Variables& variables) {
  const auto number_of = [&](const char* name) {
    const command::Variable* const variable = variables.find(name);
    return variable == nullptr ? 0 : static_cast<int>(variable->number);
  };
  const command::Variable* const mode = variables.find(kMode);
  return {.mode = mode == nullptr ? std::string() : mode->text,
          .display = number_of(kDisplay),
          .size = {number_of(kWidth), number_of(kHeight)}};
}

// All of it at once, so that whoever looks at the variables changes the window once.
Outcome apply_video(const PageContext& context) {
  const Video chosen = *context.choices.video;
  // Where one is not registered there was no row for it.
  const auto set = [&](const char* name, const std::string& value) {
    (void)context.variables.set(name, value);
  };
  set(kMode, chosen.mode);
  set(kDisplay, fmt::format("{}", chosen.display));
  set(kWidth, fmt::format("{}", chosen.size.width));
  set(kHeight, fmt::format("{}", chosen.size.height));
  context.choices.video.reset();
  return {.refresh = true};
}

std::unique_ptr<Row> make_mode_row(const command::Variable& mode, Video& io_chosen) {
  LocalChoiceRow::Parts parts;
  parts.names = mode.choices;
  parts.chosen = [&io_chosen, names = mode.choices] {
    return static_cast<int>(std::find(names.begin(), names.end(), io_chosen.mode) - names.begin());
  };
  parts.choose = [&io_chosen, names = mode.choices](int number) {
    io_chosen.mode = names[static_cast<std::size_t>(number)];
  };
  parts.help = fmt::format("{} \"Apply\" below changes to it. ({})", mode.help, mode.name);
  return std::make_unique<LocalChoiceRow>("Shown in", std::move(parts));
}

std::unique_ptr<Row> make_display_row(Video& io_chosen, int displays) {
  LocalChoiceRow::Parts parts;
  for (int i = 0; i < displays; ++i) parts.names.push_back(fmt::format("{}", i + 1));
  parts.chosen = [&io_chosen] { return io_chosen.display; };
  parts.choose = [&io_chosen](int number) { io_chosen.display = number; };
  parts.help = "Which display it is shown on.";
  parts.refresh = true;  // each has sizes of its own
  return std::make_unique<LocalChoiceRow>("Display", std::move(parts));
}

std::unique_ptr<Row> make_size_row(const PageContext& context) {
  Video& chosen = *context.choices.video;
  std::vector<platform::PixelSize> sizes = asked(context.content.display_sizes, int{chosen.display});
  if (std::find(sizes.begin(), sizes.end(), chosen.size) == sizes.end())
    sizes.insert(sizes.begin(), chosen.size);
  LocalChoiceRow::Parts parts;
  for (const platform::PixelSize& size : sizes)
    parts.names.push_back(fmt::format("{} x {}", size.width, size.height));
  parts.chosen = [&chosen, sizes] {
    return static_cast<int>(std::find(sizes.begin(), sizes.end(), chosen.size) - sizes.begin());
  };
  parts.choose = [&chosen, sizes](int number) { chosen.size = sizes[static_cast<std::size_t>(number)]; };
  parts.help = "Of the window, or of the display in full screen; \"Apply\" below changes to it.";
  return std::make_unique<LocalChoiceRow>("Size", std::move(parts));
}

void add_display_rows(const PageContext& context, Page& io_page) {
  if (context.variables.find(kWidth) == nullptr) return;
  MenuChoices& choices = context.choices;
  // A window that is resized otherwise is followed, as long as nothing else was chosen.
  if (!choices.video || choices.video == choices.video_before)
    choices.video = choices.video_before = video_now(context.variables);
  Video& chosen = *choices.video;
  io_page.rows.push_back(make_size_row(context));
  if (const command::Variable* const mode = context.variables.find(kMode))
    io_page.rows.push_back(make_mode_row(*mode, chosen));
  const int displays = asked(context.content.displays);
  if (displays > 1) io_page.rows.push_back(make_display_row(chosen, displays));
  io_page.rows.push_back(std::make_unique<ActionRow>(
      "Apply", [context] { return apply_video(context); }, "Changes to the size and window chosen above."));
}

}  // namespace

Page make_options_page(const PageContext& context) {
  Page page;
  page.title = "Options";
  page.title_picture = "gfx/p_option.lmp";
  page.style = PageStyle::kLarge;
  const auto add_opener = [&](const char* label, MenuPage opened) {
    page.rows.push_back(make_opener(context, label, opened));
  };
  add_opener("Video", MenuPage::kVideo);
  add_opener("Screen", MenuPage::kScreen);
  add_opener("Sound", MenuPage::kSound);
  add_opener("Controls", MenuPage::kControls);
  add_opener("Keys", MenuPage::kKeys);
  add_opener("Accessibility", MenuPage::kAccessibility);
  page.rows.push_back(std::make_unique<ActionRow>(
      "Console", [] { return Outcome{.commands = {"toggleconsole"}, .leaving = Leaving::kClose}; }));
  return page;
}

Page make_video_page(const PageContext& context) {
  Page page;
  page.title = "Video";
  page.title_picture = "gfx/vidmodes.lmp";
  page.nothing = "There is nothing to set.";
  add_display_rows(context, page);
  add_options(context, picture_options(), page);
  return page;
}

Page make_screen_page(const PageContext& context) {
  return make_table_page(context, "Screen", screen_options());
}

Page make_sound_page(const PageContext& context) {
  return make_table_page(context, "Sound", sound_options());
}

Page make_controls_page(const PageContext& context) {
  Page page = make_table_page(context, "Controls", control_options());
  page.rows.insert(page.rows.begin(),
                   make_opener(context, "Keys and buttons", MenuPage::kKeys, "Which of them does what."));
  return page;
}

Page make_accessibility_page(const PageContext& context) {
  return make_table_page(context, "Accessibility", accessibility_options());
}

Page make_keys_page(const PageContext& context) {
  Page page;
  page.title = "Keys";
  page.title_picture = "gfx/ttl_cstm.lmp";
  page.searched = true;
  for (const BoundAction& action : bound_actions())
    if (action.commands.empty())
      page.rows.push_back(std::make_unique<HeadingRow>(std::string(action.label)));
    else
      page.rows.push_back(std::make_unique<BindingRow>(context.content, action.label, action.commands));
  page.rows.push_back(std::make_unique<ActionRow>(
      "Back to defaults",
      [] {
        return Outcome{.page = ask("Bind all keys as they were at first?", {.commands = {"bind_defaults"}})};
      },
      "Binds all keys as they were at first."));
  return page;
}

}  // namespace temblor::client

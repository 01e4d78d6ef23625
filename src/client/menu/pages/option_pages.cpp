// The pages of settings. Each row shows a console variable and sets it at once, except the resolution,
// display mode and monitor, which take effect together on "Apply".
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

// "reset NAME" for each variable of the page that is registered.
std::vector<std::string> make_reset_commands(const command::Variables& variables,
                                             std::span<const OptionLook> looks) {
  std::vector<std::string> lines;
  for (const OptionLook& look : looks)
    if (variables.find(look.variable) != nullptr) lines.push_back(fmt::format("reset {}", look.variable));
  return lines;
}

void add_options(const PageContext& context, std::span<const OptionLook> looks, Page& io_page) {
  for (const OptionLook& look : looks)
    if (std::unique_ptr<Row> row = make_option_row(context.variables, look))
      io_page.rows.push_back(std::move(row));
  std::vector<std::string> lines = make_reset_commands(context.variables, looks);
  if (lines.empty()) return;
  io_page.rows.push_back(std::make_unique<ActionRow>(
      "Reset to defaults",
      [lines] {
        return Outcome{
            .page = make_question("Reset all settings on this page to their defaults?", {.commands = lines})};
      },
      "Resets all settings on this page."));
}

Page make_table_page(const PageContext& context, std::string title, std::span<const OptionLook> looks) {
  Page page;
  page.title = std::move(title);
  page.empty_text = "No settings here.";
  add_options(context, looks, page);
  return page;
}

constexpr const char *kWindowWidth = "vid_width", *kWindowHeight = "vid_height", *kMode = "vid_mode",
                     *kDisplay = "vid_display";

Video read_video(const command::Variables& variables) {
  const auto read_number = [&](const char* name) {
    const command::Variable* const variable = variables.find(name);
    return variable == nullptr ? 0 : static_cast<int>(variable->number);
  };
  const command::Variable* const mode = variables.find(kMode);
  return {.mode = mode == nullptr ? std::string() : mode->text,
          .display = read_number(kDisplay),
          .size = {read_number(kWindowWidth), read_number(kWindowHeight)}};
}

// Sets all variables in one go, so that the host sees one change and changes the window once.
Outcome apply_video(const PageContext& context) {
  const Video chosen = *context.choices.video;
  // A variable that is not registered had no row; setting it fails, which is fine.
  const auto set = [&](const char* name, const std::string& value) {
    (void)context.variables.set(name, value);
  };
  set(kMode, chosen.mode);
  set(kDisplay, fmt::format("{}", chosen.display));
  set(kWindowWidth, fmt::format("{}", chosen.size.width));
  set(kWindowHeight, fmt::format("{}", chosen.size.height));
  context.choices.video.reset();
  return {.refresh = true};
}

std::unique_ptr<Row> make_window_mode_row(const command::Variable& mode, Video& io_chosen) {
  LocalChoiceRow::Parts parts;
  parts.names = mode.choices;
  parts.chosen = [&io_chosen, names = mode.choices] {
    return static_cast<int>(std::find(names.begin(), names.end(), io_chosen.mode) - names.begin());
  };
  parts.choose = [&io_chosen, names = mode.choices](int number) {
    io_chosen.mode = names[static_cast<std::size_t>(number)];
  };
  parts.help = fmt::format("{} Takes effect on Apply. ({})", mode.help, mode.name);
  return std::make_unique<LocalChoiceRow>("Display mode", std::move(parts));
}

std::unique_ptr<Row> make_display_row(Video& io_chosen, int displays) {
  LocalChoiceRow::Parts parts;
  for (int i = 0; i < displays; ++i) parts.names.push_back(fmt::format("{}", i + 1));
  parts.chosen = [&io_chosen] { return io_chosen.display; };
  parts.choose = [&io_chosen](int number) { io_chosen.display = number; };
  parts.help = "The monitor to play on. Takes effect on Apply.";
  parts.refresh = true;  // the list of resolutions depends on it
  return std::make_unique<LocalChoiceRow>("Monitor", std::move(parts));
}

// The current size stays among the choices even if the monitor does not offer it: a window can have any size.
std::unique_ptr<Row> make_size_row(const PageContext& context) {
  Video& chosen = *context.choices.video;
  std::vector<platform::PixelSize> sizes =
      call_or_default(context.content.display_sizes, int{chosen.display});
  if (std::find(sizes.begin(), sizes.end(), chosen.size) == sizes.end())
    sizes.insert(sizes.begin(), chosen.size);
  LocalChoiceRow::Parts parts;
  for (const platform::PixelSize& size : sizes)
    parts.names.push_back(fmt::format("{} x {}", size.width, size.height));
  parts.chosen = [&chosen, sizes] {
    return static_cast<int>(std::find(sizes.begin(), sizes.end(), chosen.size) - sizes.begin());
  };
  parts.choose = [&chosen, sizes](int number) { chosen.size = sizes[static_cast<std::size_t>(number)]; };
  parts.help = "Resolution of the window or full screen. Takes effect on Apply.";
  return std::make_unique<LocalChoiceRow>("Resolution", std::move(parts));
}

void add_display_rows(const PageContext& context, Page& io_page) {
  if (context.variables.find(kWindowWidth) == nullptr) return;
  MenuChoices& choices = context.choices;
  // The rows follow a window that the player resizes, until the player chooses something here.
  if (!choices.video || choices.video == choices.video_before)
    choices.video = choices.video_before = read_video(context.variables);
  Video& chosen = *choices.video;
  io_page.rows.push_back(make_size_row(context));
  if (const command::Variable* const mode = context.variables.find(kMode))
    io_page.rows.push_back(make_window_mode_row(*mode, chosen));
  const int displays = call_or_default(context.content.displays);
  if (displays > 1) io_page.rows.push_back(make_display_row(chosen, displays));
  io_page.rows.push_back(std::make_unique<ActionRow>(
      "Apply", [context] { return apply_video(context); }, "Applies the display settings above."));
}

}  // namespace

Page make_options_page(const PageContext& context) {
  Page page;
  page.title = "Options";
  page.title_picture = "gfx/p_option.lmp";
  page.style = PageStyle::kLarge;
  const auto add_link = [&](const char* label, MenuPage opened) {
    page.rows.push_back(make_page_link(context, label, opened));
  };
  add_link("Video", MenuPage::kVideo);
  add_link("Screen", MenuPage::kScreen);
  add_link("Sound", MenuPage::kSound);
  add_link("Controls", MenuPage::kControls);
  add_link("Keys", MenuPage::kKeys);
  add_link("Accessibility", MenuPage::kAccessibility);
  if (!call_or_default(context.content.techniques).empty()) add_link("Laboratory", MenuPage::kLaboratory);
  if (!call_or_default(context.content.game_data).empty()) add_link("Game data", MenuPage::kGameData);
  page.rows.push_back(std::make_unique<ActionRow>(
      "Console", [] { return Outcome{.commands = {"toggleconsole"}, .leaving = Leaving::kClose}; }));
  return page;
}

Page make_video_page(const PageContext& context) {
  Page page;
  page.title = "Video";
  page.title_picture = "gfx/vidmodes.lmp";
  page.empty_text = "No settings here.";
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
  page.rows.insert(page.rows.begin(), make_page_link(context, "Key bindings", MenuPage::kKeys,
                                                     "Choose what each key and button does."));
  return page;
}

Page make_accessibility_page(const PageContext& context) {
  return make_table_page(context, "Accessibility", accessibility_options());
}

Page make_laboratory_page(const PageContext& context) {
  Page page;
  page.title = "Laboratory";
  page.text = "Draw the level by other methods than the engine's own. Some of them make mistakes.";
  for (const MenuTechnique& technique : call_or_default(context.content.techniques)) {
    if (technique.in_use) page.first_choice = page.rows.size();
    page.rows.push_back(std::make_unique<ActionRow>(
        technique.title,
        [name = technique.name] {
          return Outcome{.commands = {command::join_words({"r_technique", name})},
                         .leaving = Leaving::kClose};
        },
        fmt::format("{} (r_technique {})", technique.summary, technique.name)));
  }
  return page;
}

Page make_keys_page(const PageContext& context) {
  Page page;
  page.title = "Key bindings";
  page.title_picture = "gfx/ttl_cstm.lmp";
  page.has_search = true;
  const bool has_tremor = call_or_default(context.content.has_tremor);
  for (const BoundAction& action : bound_actions())
    if (action.label == kTremorLabel && !has_tremor)
      continue;
    else if (action.commands.empty())
      page.rows.push_back(std::make_unique<HeadingRow>(std::string(action.label)));
    else
      page.rows.push_back(std::make_unique<BindingRow>(context.content, action.label, action.commands));
  page.rows.push_back(std::make_unique<ActionRow>(
      "Reset to defaults",
      [] {
        return Outcome{
            .page = make_question("Restore the default key bindings?", {.commands = {"bind_defaults"}})};
      },
      "Restores the default key bindings."));
  return page;
}

}  // namespace temblor::client

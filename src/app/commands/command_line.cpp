#include "app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace temblor::app {
namespace {

// CLI11 reports errors by exceptions; the rest of the program uses base::Result.
template <typename Text>
std::function<void(const Text&)> throw_errors(const std::string& name,
                                              std::function<std::string(const Text&)> read) {
  return [name, read = std::move(read)](const Text& text) {
    if (std::string error = read(text); !error.empty()) throw CLI::ValidationError(name, std::move(error));
  };
}

// The same range, without "nan", which is neither below nor above its bounds.
Condition refuse_nan(const CLI::Range& range) {
  return std::make_shared<CLI::Validator>(
      [range](std::string& text) {
        std::string fault = range(text);
        if (fault.empty() && std::isnan(std::strtod(text.c_str(), nullptr)))
          fault = fmt::format("Value {} is not a number", text);
        return fault;
      },
      range.get_description());
}

}  // namespace

Condition in_range(int min, int max) {
  return std::make_shared<CLI::Range>(min, max);
}

Condition in_range(double min, double max) {
  return refuse_nan(CLI::Range(min, max));
}

Condition one_of(std::vector<int> values) {
  return std::make_shared<CLI::IsMember>(std::move(values));
}

Condition not_negative() {
  return refuse_nan(CLI::NonNegativeNumber);
}

Option* Option::type_name(const std::string& name) {
  option_.type_name(name);
  return this;
}

Option* Option::default_str(const std::string& text) {
  option_.default_str(text);
  return this;
}

Option* Option::capture_default_str() {
  option_.capture_default_str();
  return this;
}

Option* Option::required() {
  option_.required();
  return this;
}

Option* Option::check(const Condition& condition) {
  option_.check(*condition);
  return this;
}

Option* Option::check(std::string (*condition)(const std::string&)) {
  option_.check(condition);
  return this;
}

Option* Option::allow_extra_args(bool allow) {
  option_.allow_extra_args(allow);
  return this;
}

Option* Option::take_all() {
  option_.take_all();
  return this;
}

Option* Option::needs(const Option* other) {
  option_.needs(&other->option_);
  return this;
}

Option* Option::excludes(const Option* other) {
  option_.excludes(&other->option_);
  return this;
}

Option* Option::excludes(const std::string& other) {
  option_.excludes(other);
  return this;
}

Command::Command(const std::string& description, const std::string& name)
    : program_(std::make_unique<CLI::App>(description, name)), app_(*program_) {}

// A subcommand, which CLI11's object of the program owns.
Command::Command(CLI::App& app) : app_(app) {}

Command::~Command() = default;

// CLI11 owns its objects and returns pointers that stay valid, so Option and Command only refer to them.
Command* Command::add_subcommand(const std::string& name, const std::string& description) {
  return &commands_.emplace_back(*app_.add_subcommand(name, description));
}

// Instantiated here for every supported type, so that callers need not include CLI11.
template <typename T>
Option* Command::add_option(const std::string& name, T& io_value, const std::string& help) {
  return &options_.emplace_back(*app_.add_option(name, io_value, help));
}
template Option* Command::add_option(const std::string&, std::string&, const std::string&);
template Option* Command::add_option(const std::string&, int&, const std::string&);
template Option* Command::add_option(const std::string&, float&, const std::string&);
template Option* Command::add_option(const std::string&, double&, const std::string&);
template Option* Command::add_option(const std::string&, std::uint16_t&, const std::string&);
template Option* Command::add_option(const std::string&, std::uint32_t&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<int>&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<double>&, const std::string&);
template Option* Command::add_option(const std::string&, std::filesystem::path&, const std::string&);
template Option* Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option* Command::add_option(const std::string&, std::vector<std::filesystem::path>&,
                                     const std::string&);

Option* Command::add_flag(const std::string& name, bool& io_value, const std::string& help) {
  return &options_.emplace_back(*app_.add_flag(name, io_value, help));
}

Option* Command::add_text_option(const std::string& name, std::function<std::string(const std::string&)> read,
                                 const std::string& help) {
  return &options_.emplace_back(
      *app_.add_option_function<std::string>(name, throw_errors(name, std::move(read)), help));
}

Option* Command::add_text_list_option(const std::string& name,
                                      std::function<std::string(const std::vector<std::string>&)> read,
                                      const std::string& help) {
  return &options_.emplace_back(
      *app_.add_option_function<std::vector<std::string>>(name, throw_errors(name, std::move(read)), help));
}

void Command::footer(const std::string& text) {
  app_.footer(text);
}

void Command::set_version_flag(const std::string& name, const std::string& version) {
  app_.set_version_flag(name, version);
}

// fallthrough() lets a subcommand pass options that it does not know to the program: `temblor play --basedir
// quake`.
void Command::require_subcommand() {
  app_.require_subcommand(1);
  app_.fallthrough();
}

// --help and --version are exceptions with an exit code of success in CLI11.
Command::Parsed Command::parse(std::vector<std::string> words) {
  // CLI11 takes the words from the back.
  std::reverse(words.begin(), words.end());
  try {
    app_.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      app_.exit(error);
      return {.has_printed = true, .error = {}};
    }
    return {.is_command_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr,
            .error = error.what()};
  }
  return {.ok = true, .error = {}};
}

const std::string& Command::name() const {
  return app_.get_name();
}

bool Command::has_option(const std::string& name) const {
  return app_.get_option_no_throw(name) != nullptr;
}

bool Command::parsed() const {
  return app_.parsed();
}

std::vector<std::string> Command::remaining() const {
  return app_.remaining();
}

std::vector<std::string> Command::remaining_of_all_commands() const {
  return app_.remaining(true);
}

// `allow_extra_args(false)` matters here: without it, `--game hipnotic play` would take "play" for a second
// value.
void add_common_options(Command& program, CommonOptions& io_options) {
  program
      .add_option("--basedir", io_options.folders.base_folder,
                  "Directory that contains id1 and mods (default: the current directory if it contains id1, "
                  "otherwise "
                  "the included game)")
      ->type_name("DIR");
  program
      .add_option("--game", io_options.folders.games,
                  "Game directory to add to id1; repeatable, the last one has priority")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->take_all();
  program
      .add_option("--set", io_options.assignments,
                  "Set a console variable; repeatable (`temblor settings` lists them)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  program
      .add_option(
          "--show", io_options.show,
          "Show how the picture is made: faces, edges, spans, surfaces, mips, pvs, overdraw, or depth")
      ->type_name("KIND");
}

void add_frame_options(Command& command, FrameOptions& io_options) {
  add_parsed_option(command, "--size", io_options.size, parse_size, "Size in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", io_options.size.width, io_options.size.height));
  add_frame_options_without_size(command, io_options);
}

void add_frame_options_without_size(Command& command, FrameOptions& io_options) {
  add_parsed_option(command, "--color", io_options.format, parse_color,
                    "256 colors as in the original, or true color with colored light")
      ->type_name("indexed|rgb")
      ->default_str(pixel_format_name(io_options.format));
  command
      .add_option("--fov", io_options.fov_deg,
                  "Horizontal field of view of a 4:3 picture; wider pictures show more")
      ->type_name("DEGREES")
      ->check(in_range(10.0, 170.0))
      ->capture_default_str();
  command.add_option("--threads", io_options.threads, "Rendering threads; 0: one per core")
      ->type_name("N")
      ->check(in_range(0, 256));
}

void add_renderer_option(Command& command, FrameOptions& io_options) {
  add_parsed_option(command, "--renderer", io_options.renderer, parse_renderer,
                    "Draw on the CPU, or through OpenGL (docs/renderers.md)")
      ->type_name("cpu|gl")
      ->default_str("cpu");
}

}  // namespace temblor::app

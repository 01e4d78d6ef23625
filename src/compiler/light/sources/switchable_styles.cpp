#include "compiler/light/sources/switchable_styles.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

// Hands out styles by name.
class StyleNames {
 public:
  explicit StyleNames(std::span<const formats::Entity> entities) {
    constexpr float kEnd = 64;
    for (const formats::Entity& entity : entities) {
      if (entity.classname() != "worldspawn") continue;
      first_ = static_cast<int>(std::clamp(read_number_or(entity, "compilerstyle_start", 32), 1.0f, kEnd));
      end_ = static_cast<int>(std::clamp(read_number_or(entity, "compilerstyle_max", kEnd), 1.0f, kEnd));
      return;
    }
  }

  // The style of a name, which may be new; nothing if none is left.
  std::optional<int> find_style(const std::string& name) {
    auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) {
      if (first_ + static_cast<int>(names_.size()) >= end_) return std::nullopt;
      found = names_.insert(names_.end(), name);
    }
    return first_ + static_cast<int>(found - names_.begin());
  }
  // The style of a name that has one.
  std::optional<int> find_known(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? std::nullopt
                                 : std::optional(first_ + static_cast<int>(found - names_.begin()));
  }
  int capacity() const { return std::max(0, end_ - first_); }

 private:
  int first_ = 32, end_ = 64;
  std::vector<std::string> names_;
};

// Sets a key. Returns whether it had another value.
bool set_style(std::string_view key, int number, formats::Entity& io_entity) {
  const std::string style = fmt::format("{}", number);
  const auto pair = std::find_if(io_entity.pairs.begin(), io_entity.pairs.end(),
                                 [&](const auto& candidate) { return candidate.first == key; });
  if (pair == io_entity.pairs.end()) {
    io_entity.pairs.emplace_back(key, style);
    return true;
  }
  if (pair->second == style) return false;
  pair->second = style;
  return true;
}

// The name that decides about the style of a shadow. A targetname of shadows is not one of lights; only
// _switchableshadow_target refers to those. Empty without a name.
std::string find_shadow_name(const formats::Entity& entity) {
  if (const auto target = entity.find("_switchableshadow_target"); target && !target->empty())
    return std::string(*target);
  const std::string_view name = entity.find("targetname").value_or("");
  return name.empty() ? std::string() : fmt::format("\"shadow of {}", name);
}
// The same; brush entities without a name have one, and so a style, of their own.
std::string find_shadow_name(const formats::Entity& entity, std::size_t number) {
  const std::string name = find_shadow_name(entity);
  return name.empty() ? fmt::format("\"shadow {}", number) : name;
}

bool asks_for_switchable_shadow(const formats::Entity& entity) {
  return read_number_or(entity, "switchableshadow", 0) > 0 ||
         !entity.find("_switchableshadow_target").value_or("").empty();
}

}  // namespace

bool has_switchable_shadow(const formats::Entity& entity) {
  return entity.find("model").value_or("").starts_with('*') && asks_for_switchable_shadow(entity);
}

bool assign_switchable_styles(std::vector<formats::Entity>& io_entities, Warnings& io_warnings) {
  StyleNames names(io_entities);
  bool changed = false;
  for (formats::Entity& entity : io_entities) {
    const std::string name(entity.find("targetname").value_or(""));
    if (!is_light(entity) || name.empty()) continue;
    if (const auto style = names.find_style(name))
      changed = set_style("style", *style, entity) || changed;
    else
      io_warnings.push_back(
          {"too many switchable lights", fmt::format("{}: only {} different targetnames can be switched",
                                                     describe_light(entity), names.capacity())});
  }
  for (std::size_t i = 0; i < io_entities.size(); ++i) {
    formats::Entity& entity = io_entities[i];
    if (!has_switchable_shadow(entity)) continue;
    if (const auto style = names.find_style(find_shadow_name(entity, i)))
      changed = set_style("switchshadstyle", *style, entity) || changed;
    else
      io_warnings.push_back(
          {"too many switchable shadows",
           fmt::format("{} with the model \"{}\": lights and shadows have {} styles, so it casts no shadow",
                       base::printable(entity.classname()), base::printable(*entity.find("model")),
                       names.capacity())});
  }
  return changed;
}

std::string find_brush_shadow_name(const formats::Entity& entity) {
  const bool is_world = entity.classname() == "func_group" || entity.classname().starts_with("func_detail");
  return is_world && asks_for_switchable_shadow(entity) ? find_shadow_name(entity) : std::string();
}

// Names the lights and shadows in the same order as assign_switchable_styles() does.
BrushStyles find_brush_styles(std::span<const formats::Entity> entities, const FaceKeys& keys) {
  StyleNames names(entities);
  for (const formats::Entity& entity : entities)
    if (const std::string name(entity.find("targetname").value_or("")); is_light(entity) && !name.empty())
      names.find_style(name);
  for (std::size_t i = 0; i < entities.size(); ++i)
    if (has_switchable_shadow(entities[i])) names.find_style(find_shadow_name(entities[i], i));
  const auto find_known = [&names](const StyleName& padded) {
    const std::string name(padded.begin(), std::ranges::find(padded, 0));
    return static_cast<std::uint8_t>(name.empty() ? 0 : names.find_known(name).value_or(0));
  };
  BrushStyles styles;
  for (const SurfaceKeys& own : keys.keys) {
    styles.shadows.push_back(find_known(own.shadow_name));
    styles.surface_lights.push_back(find_known(own.surface_light_name));
  }
  return styles;
}

}  // namespace temblor::compiler

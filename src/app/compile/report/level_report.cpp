#include "app/compile/report/level_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "app/compile/leak_picture.h"
#include "app/compile/report/level_figures.h"
#include "app/compile/report/level_plan.h"
#include "app/compile/report/report_style.h"
#include "app/compile/report/texture_table.h"
#include "app/html/html.h"
#include "base/text.h"
#include "compiler/stock_limits.h"
#include "world/level.h"

namespace temblor::app {
namespace {

constexpr std::size_t kMaxBusyPlaces = 5;

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string format_size(std::size_t bytes) {
  constexpr double kKb = 1024;
  const auto size = static_cast<double>(bytes);
  return size < kKb * kKb ? fmt::format("{:.0f} KB", size / kKb) : fmt::format("{:.1f} MB", size / kKb / kKb);
}

std::string make_card(const std::string& value, const std::string& name, const char* kind = "") {
  return fmt::format("<div class=\"{}\"><b>{}</b><span>{}</span></div>\n", kind, value, name);
}

std::string write_head(const LevelReportInput& input, const world::Level& level) {
  const formats::Bsp& bsp = input.build.bsp;
  const std::string name = escape_html(input.level_file);
  std::string_view message;
  if (!level.entities.empty()) message = level.entities[0].find("message").value_or("");
  double time_s = 0;
  for (const compiler::StageTime& time : input.compiled.times) time_s += time.wall_s.value_or(0);
  std::string html =
      fmt::format("<h1>{}</h1>\n<p class=\"soft\">{}{}version {}</p>\n<div class=\"cards\">\n", name,
                  escape_html(message), message.empty() ? "" : ", ", formats::version_name(bsp.version));
  html += input.compiled.leak ? make_card("leaks", "has no visibility", "alarm")
                              : make_card("sealed", "no way to the outside", "good");
  html += make_card(std::to_string(bsp.faces.size()), "faces");
  html += make_card(std::to_string(level.visible_leaf_count), "leaves");
  if (input.build.mean_visible_share)
    html += make_card(fmt::format("{:.1f} %", *input.build.mean_visible_share * 100),
                      "of them visible from an average leaf");
  html += make_card(fmt::format("{:.2f} s", time_s), "to compile");
  return html + make_card(format_size(input.level_bytes), "level file") + "</div>\n";
}

std::string write_leak(const compiler::LeakPath& leak, base::Bytes picture) {
  const math::Vec3d &inside = leak.points_world.front(), &outside = leak.points_world.back();
  std::string html = "<section id=\"leak\">\n<h2 class=\"alarm\">The level leaks</h2>\n";
  html += fmt::format(
      "<p>Entity {} ({}) at {:g} {:g} {:g}, line {} of the map, can reach the outside at {:.0f} {:.0f} "
      "{:.0f}. "
      "Without a seal, the level gets no visibility. In the game, <code>pointfile</code> shows the "
      "way.</p>\n",
      leak.entity, escape_html(leak.classname), inside.x, inside.y, inside.z, leak.line, outside.x, outside.y,
      outside.z);
  html +=
      "<p class=\"soft\">The level from above, and below that from the south. Green: the entity. Red: the "
      "outside.</p>\n";
  return html + fmt::format("<img class=\"wide\" alt=\"the way out\" src=\"{}\"/>\n</section>\n",
                            make_png_uri(picture));
}

std::string write_warnings(const compiler::Warnings& warnings) {
  std::map<std::string, std::vector<const compiler::Warning*>> by_kind;
  for (const compiler::Warning& warning : warnings) by_kind[warning.kind].push_back(&warning);
  std::string html = "<section id=\"problems\">\n<h2>Problems</h2>\n";
  for (const auto& [kind, group] : by_kind) {
    html += fmt::format("<p><b>{}</b> ({})</p>\n<ul>\n", escape_html(kind), group.size());
    for (const compiler::Warning* warning : group)
      html += fmt::format("<li>{}</li>\n", escape_html(warning->what));
    html += "</ul>\n";
  }
  return html + "</section>\n";
}

std::string write_times(const std::vector<compiler::StageTime>& times) {
  double longest_s = 0;
  for (const compiler::StageTime& time : times) longest_s = std::max(longest_s, time.wall_s.value_or(0));
  std::string html =
      "<section id=\"times\">\n<h2>Times</h2>\n<table>\n<tr><th>stage</th><th "
      "class=\"n\">time</th><th></th></tr>\n";
  for (const compiler::StageTime& time : times)
    html += fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td>{}</td></tr>\n", time.name,
                        time.wall_s ? fmt::format("{:.2f} s", *time.wall_s) : "unchanged",
                        make_bar(longest_s > 0 ? time.wall_s.value_or(0) / longest_s : 0));
  return html + "</table>\n</section>\n";
}

std::string write_limits(const formats::Bsp& bsp) {
  std::string html =
      "<section id=\"limits\">\n<h2>Limits of the original engine</h2>\n<table>\n<tr><th></th><th "
      "class=\"n\">used</th><th class=\"n\">limit</th><th class=\"n\">share</th><th></th></tr>\n";
  for (const compiler::PartCount& part : compiler::count_parts(bsp)) {
    const double used = share(part.count, part.limit);
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n{}\">{:.1f} "
        "%</td><td>{}</td></tr>\n",
        part.what, part.count, part.limit, part.is_exceeded() ? " alarm" : "", used * 100,
        make_bar(used, part.is_exceeded()));
  }
  return html + "</table>\n</section>\n";
}

std::string write_busy_places(const std::vector<BusyPlace>& places, std::uint32_t leaves) {
  std::string html =
      "<table>\n<tr><th class=\"n\">place</th><th>position</th><th class=\"n\">leaves it sees</th><th "
      "class=\"n\">faces it sees</th><th></th></tr>\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    const math::Vec3& at = places[i].center_world;
    html += fmt::format(
        "<tr><td class=\"n\">{}</td><td><code>setpos {:.0f} {:.0f} {:.0f}</code></td><td "
        "class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td>{}</td></tr>\n",
        i + 1, at.x, at.y, at.z, places[i].leaves, places[i].faces,
        make_bar(share(places[i].leaves, leaves)));
  }
  return html + "</table>\n";
}

std::string make_heat_legend(std::uint32_t largest, std::uint32_t leaves) {
  constexpr int kStops = 9;
  std::string colors;
  for (int i = 0; i < kStops; ++i)
    colors += fmt::format(", #{:06x}", heat_color(double(i) / (kStops - 1)) & 0xffffffu);
  return fmt::format(
      "<div class=\"legend\"><span>sees no leaves</span><i "
      "style=\"background:linear-gradient(90deg{})\"></i><span>sees {} of "
      "{} leaves ({:.0f} %)</span></div>\n",
      colors, largest, leaves, share(largest, leaves) * 100);
}

base::Result<std::string> write_plan(const LevelReportInput& input, const world::Level& level) {
  const std::vector<std::uint32_t> visible = count_visible_leaves(level);
  const std::vector<BusyPlace> places = find_busy_places(level, visible, kMaxBusyPlaces);
  TRY(const std::string plan,
      draw_level_plan({level, input.build.portals, visible, places, input.compiled.leak}));
  std::string html =
      "<section id=\"plan\">\n<h2>The level from above</h2>\n<input type=\"checkbox\" id=\"heat\" "
      "checked=\"checked\"/><label for=\"heat\">visibility</label>\n<input type=\"checkbox\" id=\"walls\" "
      "checked=\"checked\"/><label for=\"walls\">walls</label>\n<input type=\"checkbox\" id=\"portals\" "
      "checked=\"checked\"/>";
  html += fmt::format("<label for=\"portals\">{}</label>\n{}",
                      base::counted(input.build.portals.portals.size(), "portal"), plan);
  if (visible.empty())
    html += "<p class=\"soft\">The level has no visibility: everything is visible from everywhere.</p>\n";
  else
    html += make_heat_legend(std::ranges::max(visible), level.visible_leaf_count) +
            "<p class=\"soft\">Bright places see much of the level, which is slow to draw. These see the "
            "most:</p>\n" +
            write_busy_places(places, level.visible_leaf_count);
  return html + "</section>\n";
}

std::string write_light(const world::Level& level) {
  std::string html = "<section id=\"light\">\n<h2>Light</h2>\n";
  const LightFigures light = measure_light(level);
  if (light.samples == 0) return html + "<p>The level has no light maps.</p>\n</section>\n";
  html += fmt::format(
      "<p>{} samples, {:.1f} on average. {:.1f} % are black. {:.1f} % are at 255, where light is cut "
      "off.</p>\n<svg "
      "class=\"bins\" viewBox=\"0 0 {} 100\" preserveAspectRatio=\"none\">\n",
      light.samples, light.mean, share(light.black, light.samples) * 100,
      share(light.full, light.samples) * 100, LightFigures::kBins * 10);
  const std::size_t largest = std::ranges::max(light.histogram);
  for (int bin = 0; bin < LightFigures::kBins; ++bin) {
    const std::size_t count = light.histogram[static_cast<std::size_t>(bin)];
    const double height = share(count, largest) * 100;
    const int first = bin * LightFigures::kLevelsPerBin;
    html += fmt::format(
        "<rect{} x=\"{}\" y=\"{:.2f}\" width=\"9\" height=\"{:.2f}\"><title>{} to {}: {} "
        "samples</title></rect>\n",
        bin + 1 == LightFigures::kBins ? " class=\"cut\"" : "", bin * 10, 100 - height, height, first,
        first + LightFigures::kLevelsPerBin - 1, count);
  }
  return html +
         "</svg>\n<div class=\"axis\"><span>0 (black)</span><span>64</span><span>128</span><span>192</span>"
         "<span>255</span></div>\n</section>\n";
}

std::string describe_side(const LightMapGroup& group) {
  if (group.max_side == 0) return "none (sky, liquids, never lit)";
  constexpr std::int32_t kUnbounded = 1 << 20;
  return group.max_side > kUnbounded ? fmt::format("more than {}", group.min_side - 1)
                                     : fmt::format("{} to {}", group.min_side, group.max_side);
}

std::string write_light_maps(const world::Level& level) {
  const std::vector<LightMapGroup> groups = group_light_maps(level);
  std::size_t samples = 0;
  for (const LightMapGroup& group : groups) samples += group.samples;
  std::string html =
      "<section id=\"lightmaps\">\n<h2>Surfaces by the size of their light "
      "maps</h2>\n<table>\n<tr><th>longer "
      "side in samples</th><th class=\"n\">faces</th><th class=\"n\">samples</th><th class=\"n\">share of "
      "samples</th><th></th></tr>\n";
  for (const LightMapGroup& group : groups)
    html += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.1f} "
        "%</td><td>{}</td></tr>\n",
        describe_side(group), group.faces, group.samples, share(group.samples, samples) * 100,
        make_bar(share(group.faces, level.faces.size())));
  return html + "</table>\n<p class=\"soft\">The bars show shares of the faces.</p>\n</section>\n";
}

}  // namespace

base::Result<std::string> make_level_report(const LevelReportInput& input) {
  const formats::Lit* const lit = input.build.lit ? &*input.build.lit : nullptr;
  TRY(const std::shared_ptr<const world::Level> level,
      world::make_level(input.build.bsp, input.level_file, lit));
  std::string html = begin_page(input.level_file, kReportStyle);
  html += write_head(input, *level);
  if (input.compiled.leak) {
    TRY(const base::ByteVector picture, draw_leak(input.build.bsp, input.compiled.leak->points_world));
    html += write_leak(*input.compiled.leak, picture);
  }
  if (!input.warnings.empty()) html += write_warnings(input.warnings);
  html += write_times(input.compiled.times);
  html += write_limits(input.build.bsp);
  TRY(const std::string plan, write_plan(input, *level));
  html += plan + write_light(*level) + write_light_maps(*level);
  TRY(const std::string textures,
      write_texture_table(*level, input.compiled.missing_textures, input.palette));
  return html + textures +
         "<footer>Made by Temblor, <code>temblor compile --report</code>.</footer>\n</body>\n</html>\n";
}

}  // namespace temblor::app

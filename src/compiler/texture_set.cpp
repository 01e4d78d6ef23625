// Collects names first: those requested, then the other frames of their animations. Then reads each texture.
#include "compiler/texture_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/text.h"
#include "compiler/textures/texture_sources.h"
#include "formats/images/build_mips.h"

namespace temblor::compiler {
namespace {

// Two sequences: an entity shows the first one, and the second one after it was used.
constexpr std::array<std::string_view, 2> kFrameMarks{"0123456789", "abcdefghij"};

// Whether the key is that of an animation frame: +, then a digit or a letter from a to j.
bool is_frame(std::string_view key) {
  return key.size() >= 2 && key[0] == '+' && std::ranges::any_of(kFrameMarks, [&](std::string_view marks) {
           return marks.find(key[1]) != std::string_view::npos;
         });
}

std::string make_frame_key(std::string_view key, char mark) {
  std::string frame(key);
  frame[1] = mark;
  return frame;
}

std::string quote_name(std::string_view name) {
  return fmt::format("\"{}\"", base::quotable(name));
}

formats::BspMiptex make_checkerboard(std::string_view name) {
  constexpr std::uint32_t kSide = 64, kSquare = 8;
  constexpr std::array<std::uint8_t, 2> kColors{0, 251};  // black and full-bright red, hard to miss
  formats::BspMiptex miptex{true, std::string(name.substr(0, kLevelNameChars)), kSide, kSide, {}};
  for (unsigned k = 0; k < miptex.mips.size(); ++k)
    for (std::uint32_t y = 0; y < kSide >> k; ++y)
      for (std::uint32_t x = 0; x < kSide >> k; ++x)
        miptex.mips[k].push_back(kColors[((x << k) / kSquare + (y << k) / kSquare) % kColors.size()]);
  return miptex;
}

// A name as in the map, and the key under which it is stored.
struct Wanted {
  std::string name, key;
};

// Collects the wanted names, then reads their textures.
class TextureSetMaker {
 public:
  TextureSetMaker(std::span<const TextureSource> sources, const formats::Palette& palette,
                  MipLevels mip_levels, Warnings& io_warnings)
      : sources_(sources, palette, io_warnings),
        palette_(palette),
        mip_levels_(mip_levels),
        warnings_(io_warnings) {}

  TextureSet make(std::span<const std::string_view> names) {
    for (const std::string_view name : names) want(name);
    const std::size_t asked_for = wanted_.size();
    for (std::size_t i = 0; i < asked_for; ++i)
      if (is_frame(wanted_[i].key)) want_frames(std::string(wanted_[i].key));
    for (const Wanted& wanted : wanted_) set_.miptexes.push_back(make_miptex(wanted));
    return std::move(set_);
  }

 private:
  void want(std::string_view name) {
    std::string key = texture_key(name);
    const auto [place, is_new] = set_.index.try_emplace(key, static_cast<std::uint32_t>(wanted_.size()));
    if (is_new) {
      wanted_.push_back({std::string(name), std::move(key)});
    } else if (const std::string& first = wanted_[place->second].name;
               !base::equal_ignoring_case(name, first)) {
      warn("texture names too long", "{} and {} become one texture: only the first {} characters count",
           quote_name(first), quote_name(name), kLevelNameChars);
    }
  }

  // Requests all frames of both sequences of an animation, up to the last frame that exists.
  void want_frames(const std::string& key) {
    for (const std::string_view marks : kFrameMarks) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < marks.size(); ++i)
        if (const std::string frame = make_frame_key(key, marks[i]); sources_.has(frame) || is_wanted(frame))
          count = i + 1;
      for (const char mark : marks.substr(0, count)) want_frame(make_frame_key(key, mark));
    }
  }

  void want_frame(const std::string& frame) {
    if (is_wanted(frame)) return;
    if (sources_.has(frame))
      want(frame);
    else
      warn("animation has gaps", "{} is missing, but later frames exist", quote_name(frame));
  }

  bool is_wanted(const std::string& key) const { return set_.index.contains(key); }

  // Never fails: a missing or unreadable texture becomes a checkerboard, so the level can still be played.
  formats::BspMiptex make_miptex(const Wanted& wanted) {
    auto miptex = sources_.take(wanted.key, warnings_);
    if (!miptex) {
      if (!sources_.has(wanted.key)) set_.missing.push_back(wanted.name);
      return make_checkerboard(wanted.name);
    }
    constexpr std::uint32_t kSideMultiple = 16;
    if (miptex->width % kSideMultiple != 0 || miptex->height % kSideMultiple != 0)
      warn("texture size", "{} has {} x {} texels: resize it to multiples of {}, which engines expect",
           quote_name(wanted.name), miptex->width, miptex->height, kSideMultiple);
    if (mip_levels_ == MipLevels::kBuilt || !has_all_mips(*miptex)) build_all_mips(*miptex);
    return std::move(*miptex);
  }

  static bool has_all_mips(const formats::BspMiptex& miptex) {
    for (std::size_t k = 0; k < miptex.mips.size(); ++k)
      if (miptex.mips[k].size() != std::size_t{miptex.width >> k} * (miptex.height >> k)) return false;
    return true;
  }

  void build_all_mips(formats::BspMiptex& io_miptex) {
    if (!mip_colors_) mip_colors_.emplace(palette_);
    io_miptex.mips = formats::build_mips(std::move(io_miptex.mips[0]), io_miptex.width, io_miptex.height,
                                         io_miptex.name.starts_with('{'), *mip_colors_);
  }

  template <typename... Args>
  void warn(const char* kind, fmt::format_string<Args...> format, Args&&... args) {
    std::string what = fmt::format(format, std::forward<Args>(args)...);
    if (warned_.insert(what).second) warnings_.push_back({kind, std::move(what)});
  }

  TextureSources sources_;
  const formats::Palette& palette_;
  std::optional<formats::MipColors> mip_colors_;
  MipLevels mip_levels_;
  Warnings& warnings_;
  std::vector<Wanted> wanted_;
  std::set<std::string> warned_;  // the same name is often requested again
  TextureSet set_;
};

}  // namespace

std::optional<std::uint32_t> TextureSet::find(std::string_view name) const {
  const auto found = index.find(texture_key(name));
  return found == index.end() ? std::nullopt : std::optional(found->second);
}

TextureSet make_texture_set(std::span<const std::string_view> names, std::span<const TextureSource> sources,
                            const formats::Palette& palette, MipLevels mip_levels, Warnings& io_warnings) {
  return TextureSetMaker(sources, palette, mip_levels, io_warnings).make(names);
}

}  // namespace temblor::compiler

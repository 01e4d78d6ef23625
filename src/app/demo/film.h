// Frames to files: a PNG each, or a film (.mp4 through the ffmpeg program, with sound; .y4m by ourselves).
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/commands/options.h"
#include "app/files/child_process.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "formats/images/palette.h"
#include "render/frame.h"

namespace temblor::app {

// What the name asks for; kUsage for one that asks for none of them.
enum class OutputKind { kPicture, kNumberedPictures, kMp4, kY4m, kSound };
base::Result<OutputKind> output_kind(const std::string& name);

struct FilmOptions {
  FrameSize size;
  int frames_per_second = 30;
  std::size_t first_number = 0;  // of numbered pictures
  // A WAV file with the film's sound, for kMp4; there until finish(). Empty: a silent film.
  std::string sound_path{};
};

// A file that takes frame after frame. Only what finish() was called for is sure to be whole.
class Film {
 public:
  // `name` as output_kind() takes it, but no sound.
  static base::Result<Film> open(const std::string& name, const FilmOptions& options,
                                 const formats::Palette& palette);

  base::Status add(const render::FrameBuffer& frame);
  base::Status finish();

 private:
  Film(std::string name, OutputKind kind, const FilmOptions& options, const formats::Palette& palette)
      : name_(std::move(name)), kind_(kind), options_(options), palette_(palette), jobs_(1) {}
  base::Status start_ffmpeg();
  base::Status start_y4m();
  // The frame as 0xffRRGGBB, whichever format it has.
  std::span<const std::uint32_t> colors_of(const render::FrameBuffer& frame);
  base::Status write_y4m_frame(std::span<const std::uint32_t> colors);
  base::Error cannot_write() const;

  std::string name_;
  OutputKind kind_;
  FilmOptions options_;
  formats::Palette palette_;
  base::Jobs jobs_;
  std::size_t frames_ = 0;
  std::optional<ChildProcess> ffmpeg_;
  std::ofstream y4m_;
  std::vector<std::uint32_t> expanded_;
  std::vector<std::uint8_t> planes_;  // luma, blue and red difference, each width x height
};

}  // namespace temblor::app

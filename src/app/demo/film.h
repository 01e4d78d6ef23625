// Writes frames to files. The extension of the name selects the format:
//
//   x.png        one picture
//   x-%05d.png   one numbered picture per frame
//   x.mp4        H.264 with sound, encoded by the ffmpeg program, which receives raw frames through a pipe
//   x.y4m        uncompressed YUV4MPEG2 in 4:4:4, written without other programs
//   x.wav        only the sound of a demo (demo_sound.h)
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
#include "render/frame_buffer.h"

namespace temblor::app {

enum class OutputKind { kPicture, kNumberedPictures, kMp4, kY4m, kSound };
// Returns the kind that the name selects; kUsage for any other extension.
base::Result<OutputKind> find_output_kind(const std::string& name);

struct FilmOptions {
  FrameSize size;
  int frames_per_second = 30;
  // The number of the first picture.
  std::size_t first_number = 0;
  // Path of a WAV file with the sound of an .mp4 film, which must exist until finish(). Empty: a silent film.
  std::string sound_path{};
};

// A film or a sequence of pictures being written. It is valid only after finish(). Errors name the file.
class Film {
 public:
  // `name` is any that find_output_kind() accepts, except one for sound.
  static base::Result<Film> open(const std::string& name, const FilmOptions& options,
                                 const formats::Palette& palette);

  // Appends a frame, which must have the size of the options.
  base::Status add(const render::FrameBuffer& frame);
  base::Status finish();

 private:
  Film(std::string name, OutputKind kind, const FilmOptions& options, const formats::Palette& palette)
      : name_(std::move(name)), kind_(kind), options_(options), palette_(palette), jobs_(1) {}
  base::Status start_ffmpeg();
  base::Status start_y4m();
  // Returns the frame's pixels as 0xffRRGGBB, expanding indexed ones to `expanded_`.
  std::span<const std::uint32_t> expand_colors(const render::FrameBuffer& frame);
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
  // The Y, U, and V planes of a .y4m frame, each width x height.
  std::vector<std::uint8_t> planes_;
};

}  // namespace temblor::app

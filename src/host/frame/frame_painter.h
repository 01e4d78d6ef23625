// Draws the parts of a frame's picture and shows it, on the CPU or on the graphics card, as `vid_renderer`
// says.
//
//            CPU                      OpenGL without a window   OpenGL in the window
//   view     Renderer -> pixels       card -> pixels            card
//   overlay  pixels                   pixels                    card
//   show     Screen, Window::present  Screen, Window::present   card -> window
#pragma once

#include <optional>
#include <span>

#include "render/draw_list.h"
#include "render/frame_buffer.h"
#include "render/frame_stats.h"
#include "render/settings.h"

namespace temblor::host {

struct Host;
struct ScreenSettings;

// Gives the renderer the stages of r_technique, or the engine's if the technique cannot draw the level. Then
// it sets r_technique, so it must not run in parallel with a server tick.
void update_technique(Host& io_host);
// Turns OpenGL on or off as `vid_renderer` says. If it fails, says why, and sets the variable back, so it
// must not run in parallel with a server tick. Techniques of the laboratory replace the CPU's stages, so they
// draw on the CPU: call update_technique() first.
void update_renderer(Host& io_host);

// The steps of a frame. If the card fails, the rest of its steps do nothing, and the next update_renderer()
// says why.
render::FrameStats paint_view(Host& io_host, const render::Settings& settings, render::FrameBuffer& io_frame);
// Begins a frame without a view, which is black.
void paint_nothing(Host& io_host, render::FrameBuffer& io_frame);
// Brings the pixels of the view to the frame. False: the card has failed, and there are none.
bool read_view(Host& io_host, render::FrameBuffer& io_frame);
void paint_overlay(Host& io_host, const render::DrawList& overlay, render::FrameBuffer& io_frame,
                   render::FrameStats& io_stats);
// How long this frame takes to draw, if the CPU took `cpu_s`: the card may draw longer. Nothing if it has a
// timer, but has not reported a frame of this size yet.
std::optional<double> find_drawing_time_s(const Host& host, double cpu_s);
// Fails if the window is lost.
base::Status show_frame(Host& io_host, const ScreenSettings& settings);

// The pixels that the last frame showed, 0xffRRGGBB, with the size of Screen::frame(). Valid until the next
// frame. Fails with kUsage if there was none.
base::Result<std::span<const std::uint32_t>> find_shown_pixels(Host& io_host);

}  // namespace temblor::host

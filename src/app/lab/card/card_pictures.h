// Pictures of the ways to draw a level with a graphics card.
#pragma once

#include <filesystem>
#include <vector>

#include "app/commands/options.h"
#include "app/lab/card/card_methods.h"
#include "app/lab/lab_scenes.h"

namespace temblor::app {

// NAME.png of a method's picture, without spaces.
std::string card_picture_name(const CardMethod& method);

// Writes a picture for each method that can draw it, and returns those methods. It shows the scene in which
// vertex light, which differs most, differs most from the CPU: the method's, the CPU's, and their difference.
// Fails without OpenGL, and if a file cannot be written.
base::Result<std::vector<render_gl::WorldMethod>> write_card_pictures(const std::filesystem::path& folder,
                                                                      const LabScenes& scenes, FrameSize size,
                                                                      const render::Settings& settings);

}  // namespace temblor::app

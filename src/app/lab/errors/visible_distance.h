// The distance at which subdivision of models becomes visible.
#pragma once

#include "app/lab/lab_scenes.h"

namespace temblor::app {

// Beyond this distance, in units, the mean texel error of one model that is drawn by subdivision is less than
// one and a half times that of scan lines with corners at whole pixels, which were the alternative (Abrash,
// "Surface Caching Revisited, Quake's Triangle Models, and More"). At 320x200, over several poses. A multiple
// of 50 units, at most 1,000.
double find_visible_distance(const LabScenes& models, const render::Settings& settings);

}  // namespace temblor::app

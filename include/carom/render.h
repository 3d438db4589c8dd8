// carom::render: from a scene, the tracks of its moving objects and a camera to pixels.
//
// render::SceneDescription, RenderSettings, FrameInput  the input of a frame, as plain data
// render::PreparedScene    data shared by all frames: meshes, textures, the acceleration structure
//                          of static shapes
// render::render_frame     renders one frame; returns a Film
// render::Film             width * height linear Rec.709 RGBA floats, row by row from the top left,
//                          and the channels that the settings request
// render::write_exr, read_exr, write_display_image  image files
//
// The rules in carom/sim.h also apply here. To render frames of a shot, with its cameras and
// shutter, use pipeline::make_frame_renderer (carom/film.h).
#pragma once

#include "core/error.h"
#include "core/progress.h"
#include "render/film/image_file.h"
#include "render/frame/frame.h"

// carom::render: from a scene, the tracks of what moves in it and a camera to pixels.
//
//   render::SceneDescription, RenderSettings, FrameInput   what is rendered, as plain data
//   render::PreparedScene   what all frames share: meshes, textures, the structure over still
//   shapes render::render_frame    one frame; returns a Film render::Film            width * height
//   linear Rec.709 RGBA floats, row by row from the top left,
//                           and the channels that the settings ask for
//   render::write_exr, read_exr, write_display_image   pictures in files
//
// The rules that carom/sim.h states hold here, too. To render frames of a shot, with the cameras
// and the shutter that it describes, use pipeline::make_frame_renderer (carom/film.h).
#pragma once

#include "core/error.h"
#include "core/progress.h"
#include "render/film/image_file.h"
#include "render/frame/frame.h"

// carom::film: from a shot in YAML to its film. It includes carom/sim.h and carom/render.h, whose
// rules also apply here.
//
// pipeline::load_shot            reads a shot with its includes, presets and overrides; returns the
//                                Shot and all problems, each with its place in a file
// pipeline::Shot                 world, scene, cameras and settings, as plain data
// pipeline::bake_shot            simulates the shot; bake_or_reuse uses a stored bake if one exists
// pipeline::frame_count          the number of frames; plan_frame: camera and times of each frame
// pipeline::make_frame_renderer  renders frames to memory
// pipeline::make_film            renders the frames that the store lacks, and writes the film
//
// Only bake_or_reuse, find_cached_bake, make_frame and make_film read and write a store: the folder
// that their options name, or that of the command, ~/.cache/carom. bake_without_store, and the last
// two with no_store, only read it.
#pragma once

#include "carom/render.h"
#include "carom/sim.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "pipeline/shot/shot.h"

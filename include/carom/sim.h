// carom::sim: from a world of bodies to the motion of each of them.
//
//   sim::WorldDescription   what is simulated, as plain data in SI units
//   sim::find_problems      what is wrong with it, each problem with its subject and field
//   sim::bake               simulates it; returns a Timeline
//   sim::Timeline           tracks, events, energy, warnings
//   sim::Track::sample      position (m), orientation and velocities at any scene time (s)
//   sim::read_bake, write_bake   the same in a file
//
// Rules of all functions of carom. They print nothing, never exit and keep no global state. What
// fails while running throws carom::Error, whose what() is a sentence for the user; work that is
// stopped throws carom::Stopped, which is an Error. What is wrong with input is returned as data.
// Long functions take a WorkContext, a progress callback and a stop token, or a JobObserver and a
// stop token. Descriptions and results are plain values: copy and change them as you like. Any
// number of threads may call any function at the same time and read the same object, unless its
// comment says otherwise; nothing may change an object meanwhile.
//
// Axes are right-handed with z up; the cloth of a table is the plane z = 0, its centre the origin
// and its long axis x. Before version 1.0 every release may change what these headers declare.
#pragma once

#include "core/error.h"
#include "core/progress.h"
#include "sim/bake.h"
#include "sim/timeline/bake_file.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

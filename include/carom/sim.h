// carom::sim: from a world of bodies to their motion.
//
// sim::WorldDescription       the simulated world, as plain data in SI units
// sim::find_problems          the problems of a world, each with its subject and field
// sim::bake                   simulates a world; returns a Timeline
// sim::find_aims              directions of strikes that pot, cut or hit a ball, or pass a point
// sim::Timeline               tracks, events, energy, warnings
// sim::Track::sample          position (m), orientation and velocities at any scene time (s)
// sim::read_bake, write_bake  read and write a Timeline with its origin in a file
//
// Rules for all functions of carom: They print nothing, never exit and keep no global state. A
// failure throws carom::Error, whose what() is a sentence for the user; work that is stopped throws
// carom::Stopped, which is an Error. Problems of the input are returned as data. Long functions
// take a WorkContext, a progress callback and a stop token, or a JobObserver and a stop token.
// Descriptions and results are plain values that may be copied and changed freely. Any number of
// threads may call any function and read the same object concurrently, unless its comment says
// otherwise; no thread may change an object meanwhile.
//
// Axes are right-handed with z up; the cloth of a table is the plane z = 0, its centre the origin
// and its long axis x. Before version 1.0 every release may change what these headers declare.
#pragma once

#include "core/error.h"
#include "core/progress.h"
#include "sim/aim/find_aims.h"
#include "sim/bake.h"
#include "sim/timeline/bake_file.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

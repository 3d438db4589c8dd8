// Tracks and events as CSV tables.
#pragma once

#include <string>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Columns object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz: seconds, metres, the unit quaternion
/// from body to world axes, m/s, rad/s in world axes. One row per key, object by object in the
/// order of the timeline. A key whose velocities jump (an impact, a strike) has two rows of the
/// same time: the state before the jump, then the state after it.
[[nodiscard]] std::string keys_to_csv(const sim::Timeline& timeline);

/// The same columns, each track sampled at start_time + n / rate up to and including end_time. At
/// the instant of a jump the velocities are those after it. Throws Error unless 0 < rate <=
/// 1e6 Hz and the table has at most ten million rows.
[[nodiscard]] std::string samples_to_csv(const sim::Timeline& timeline, double rate);

/// Columns time,kind,a,b,x,y,z,nx,ny,nz,normal_impulse,tangential_impulse,vector_x,vector_y,
/// vector_z, one row per event in order of time; values that do not apply to the kind of event are
/// empty (b) or 0. The last three are the vector of a force event: newtons, newton metres, newton
/// seconds or m/s, world axes.
[[nodiscard]] std::string events_to_csv(const sim::Timeline& timeline);

/// Columns from,to,a,b,normal_force,slip, one row per lasting contact in order of its beginning:
/// seconds, newtons, m/s.
[[nodiscard]] std::string contacts_to_csv(const sim::Timeline& timeline);

}  // namespace carom::pipeline

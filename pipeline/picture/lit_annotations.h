// Annotations as things of the scene: light falls on them, they cast shadows and are seen in
// mirrors.
#pragma once

#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Adds an object and its material for each lit annotation of which there is something to see. They
/// have the name of its place, such as "annotations[2]", and do not move. Lines and dots become
/// tubes and balls; a zone has its edge, and a ghost ball three circles. What lies on the cloth is
/// raised until it does so with its lower side. Texts stay on the picture. Objects that the shot
/// has already are not added again. Throws Error as shapes_of does.
void add_lit_annotations(Shot& shot, const sim::Timeline& timeline);

}  // namespace carom::pipeline

// Options of a structure's queries.
#pragma once

namespace carom::render {

struct StructureOptions {
    bool counts = false;           // tests are counted
    bool shadow_rays_stop = true;  // at the first hit; otherwise they find the nearest one
};

}  // namespace carom::render

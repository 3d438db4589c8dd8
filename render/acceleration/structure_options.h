// How a structure answers.
#pragma once

namespace carom::render {

struct StructureOptions {
    bool counts = false;           // tests are counted
    bool shadow_rays_stop = true;  // at the first hit; else they look for the nearest
};

}  // namespace carom::render

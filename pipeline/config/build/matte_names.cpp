// Warns of names that Cryptomatte cannot tell apart: its ids are hashes of names.
#include <algorithm>
#include <set>
#include <string>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

void warn_about_matte_names(Builder& builder) {
    const auto& aovs = builder.shot.render.aovs;
    const auto has = [&](const char* name) { return std::ranges::find(aovs, name) != aovs.end(); };
    if (builder.shot.scene.lights.empty()) {
        return;
    }
    if (has("cryptomatte_object")) {
        std::set<std::string> objects;
        for (const render::ObjectDescription& object : builder.shot.scene.objects) {
            objects.insert(object.name);
        }
        for (const render::LightDescription& light : builder.shot.scene.lights) {
            if (objects.contains(light.name)) {
                builder.reader.warning(builder.place_of({"lights", light.name}),
                                       "light " + quote(light.name) +
                                           " has the name of an object, so that both are one matte "
                                           "of cryptomatte_object; rename one of them");
            }
        }
    }
    if (has("cryptomatte_material") && builder.materials.contains("light")) {
        builder.reader.warning(
            builder.place_of({"materials", "light"}),
            "all lights have the material 'light' in cryptomatte_material, so that "
            "this material and they are one matte; rename it");
    }
}

}  // namespace carom::pipeline::config

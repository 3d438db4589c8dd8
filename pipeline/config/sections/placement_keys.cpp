#include "pipeline/config/sections/placement_keys.h"

namespace carom::pipeline::config {

ValueType<render::Mapping> mapping_word() {
    using render::Mapping;
    return choice<Mapping>({{"uv", Mapping::uv},
                            {"planar", Mapping::planar},
                            {"box", Mapping::box},
                            {"spherical", Mapping::spherical}});
}

Exclusion only_planar() {
    return {"mapping", [](const Node& mapping) { return mapping.text != "planar"; }, "",
            "has no meaning without 'mapping: planar'"};
}

void check_facing(Reader& reader, const Node& texture, render::Placement& placement) {
    if (placement.facing.length() < 1e-9) {
        const Entry* entry = texture.find("facing");
        const Reader::Scope scope(reader, entry->key, entry->key_place);
        reader.error(entry->value.place, "'facing' must not be the zero vector");
        return;
    }
    placement.facing.normalize();
}

}  // namespace carom::pipeline::config

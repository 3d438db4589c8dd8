// The room around the table.
#include <utility>

#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

const MapSpec<SetSection>& set_spec() {
    static const MapSpec<SetSection> spec = [] {
        MapSpec<SetSection> s(
            "set",
            "The room around the table. The light on its static surfaces that are far from the "
            "table is computed once for all frames.");
        s.set(
            "file", text("the name of a set or of a file"), [](SetSection&, const auto&) {},
            "the set: a name in `configs/sets`, or the name of a file, which ends in `.yaml`");
        s.key("near", &SetSection::near, length(between(0, 100)),
              "distance from the table's box up to which light is computed in every frame");
        s.key("cell", &SetSection::cell, length(between(0.005, 1)),
              "side of the parts of surfaces that have one light; it grows to 1/60 of the distance "
              "from the table");
        s.key("samples", &SetSection::samples, integer(1, 65536),
              "paths of each such part, from which its light is computed");
        s.set(
            "light", file(FileKind::light),
            [](SetSection& set, std::string path) { set.light = std::move(path); },
            "a file with the light, as the cache has it, which is used for the scene that it was "
            "computed for");
        return s;
    }();
    return spec;
}

}  // namespace

ValueType<SetSection> set_of_shot() {
    ValueType<SetSection> name = convert<SetSection>(
        text("the name of a set or of a file"), [](const std::string&) { return SetSection{}; });
    const auto read = name.read;
    name.read = [read](Reader& reader, const Node& node) -> std::optional<SetSection> {
        reader.error(node.place,
                     "a set is read with the file that names it, so --set cannot choose one");
        return std::nullopt;
    };
    return any_of<SetSection>({{is_scalar, name}, {is_map, record(set_spec())}});
}

}  // namespace carom::pipeline::config

// The visible cue stick.
#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

const MapSpec<StickSection>& cue_stick_spec() {
    static const MapSpec<StickSection> spec = [] {
        MapSpec<StickSection> s("cue stick", "The stick that is seen to strike.");
        s.key("length", &StickSection::length, length(between(0.5, 3)), "length of the stick");
        s.key("tip", &StickSection::tip, length(between(0.005, 0.018)),
              "diameter of the tip. The default depends on the table: 9.5 mm for snooker, 11.5 mm "
              "for carom, 12.9 mm for others");
        return s;
    }();
    return spec;
}

}  // namespace

ValueType<bool> shown_or_hidden() {
    return choice<bool>({{"shown", true}, {"hidden", false}});
}

ValueType<StickSection> cue_stick() {
    const auto word = convert<StickSection>(shown_or_hidden(), [](bool is_shown) {
        StickSection section;
        section.is_shown = is_shown;
        return section;
    });
    return any_of<StickSection>({{is_scalar, word}, {is_map, record(cue_stick_spec())}});
}

}  // namespace carom::pipeline::config

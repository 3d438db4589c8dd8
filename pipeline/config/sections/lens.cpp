#include "pipeline/config/sections/lens.h"

#include <string>

#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

namespace {

enum class LensKind { clean, prime, vintage, anamorphic, broadcast_zoom };

Lens lens_of(LensKind kind) {
    switch (kind) {
        case LensKind::clean:
            return {};
        case LensKind::prime:
            return {.shape = {1.1, 0.45, 1, -0.004},
                    .breathing = 0.2,
                    .look = {.falloff = 0.5, .lateral_colour = 2e-4}};
        case LensKind::vintage:
            return {.shape = {1.05, 0.85, 1, -0.02},
                    .breathing = 1,
                    .look = {.falloff = 1, .lateral_colour = 1.2e-3}};
        case LensKind::anamorphic:
            return {.shape = {1.1, 0.5, 0.55, -0.025},
                    .breathing = 0.6,
                    .look = {.falloff = 0.6, .lateral_colour = 1.2e-3}};
        case LensKind::broadcast_zoom:
            return {.shape = {1, 0, 1, 0.004},
                    .breathing = 0,
                    .look = {.falloff = 0.15, .lateral_colour = 3e-4}};
    }
    return {};
}

struct CatEye {
    double ratio = 1.1;
    double shift = 0;
};

const MapSpec<CatEye>& cat_eye_spec() {
    static const MapSpec<CatEye> spec = [] {
        MapSpec<CatEye> s("cat_eye",
                          "The second opening through which light passes: towards the corners it "
                          "covers a part of the lens, so that bokeh becomes lemon-shaped and the "
                          "picture darker.");
        s.key("ratio", &CatEye::ratio, number(between(1, 10)),
              "radius of that opening, in radii of the lens. The picture is free of it up to where "
              "the shift is `ratio` - 1");
        s.key("shift", &CatEye::shift, number(from_below(0, 10)),
              "how far the opening is shifted in a corner of the picture, in radii of the lens; "
              "less than `ratio`")
            .required();
        s.check([](Reader& reader, const Node& node, CatEye& eye) {
            const Entry* shift = node.find("shift");
            if (shift != nullptr && !(eye.shift < eye.ratio)) {
                reader.error(shift->value.place, "'shift' must be less than 'ratio'");
                eye.shift = 0;
            }
        });
        return s;
    }();
    return spec;
}

const MapSpec<Lens>& lens_spec() {
    static const MapSpec<Lens> spec = [] {
        MapSpec<Lens> s("lens", "How a camera's lens differs from a perfect one.");
        s.set(
            "cat_eye", record(cat_eye_spec()),
            [](Lens& lens, const CatEye& eye) {
                lens.shape.cat_eye_ratio = eye.ratio;
                lens.shape.cat_eye_shift = eye.shift;
            },
            "what is out of focus towards the corners, and how dark these are. Only with "
            "`aperture` or `f_number`");
        s.key(
            "squeeze", [](Lens& lens) -> double& { return lens.shape.squeeze; },
            number(above_up_to(0, 1)),
            "width of the pupil, in heights: below 1 bokeh is an upright oval, as of an anamorphic "
            "lens");
        s.key(
            "distortion", [](Lens& lens) -> double& { return lens.shape.distortion; },
            number(between(-0.3, 0.3)),
            "part by which a corner of the picture is farther from its centre: below 0 straight "
            "lines bulge outwards (barrel), above 0 inwards (pincushion)");
        s.key(
            "breathing", &Lens::breathing, number(between(0, 1)),
            "how much narrower the field of view becomes as the focus comes near: 1 is as much as "
            "with a simple lens, m = focal length / (distance - focal length)");
        s.key(
            "falloff", [](Lens& lens) -> double& { return lens.look.falloff; },
            number(between(0, 1)),
            "how much light is lost towards the corners: 1 is cos^4 of the angle. It belongs to "
            "the view: frames are stored without it");
        s.key(
            "lateral_colour", [](Lens& lens) -> double& { return lens.look.lateral_colour; },
            number(between(-0.02, 0.02)),
            "part by which the red picture is larger than the blue one, for coloured edges: 0.001 "
            "is much. It belongs to the view: frames are stored without it");
        return s;
    }();
    return spec;
}

}  // namespace

ValueType<Lens> lens() {
    const auto kind =
        convert<Lens>(choice<LensKind>({{"clean", LensKind::clean},
                                        {"prime", LensKind::prime},
                                        {"vintage", LensKind::vintage},
                                        {"anamorphic", LensKind::anamorphic},
                                        {"broadcast_zoom", LensKind::broadcast_zoom}}),
                      lens_of);
    ValueType<Lens> result = any_of<Lens>({{is_scalar, kind}, {is_map, record(lens_spec())}});
    result.show = [](const Lens&) { return std::string("clean"); };
    return result;
}

}  // namespace carom::pipeline::config

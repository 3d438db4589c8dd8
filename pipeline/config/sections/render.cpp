#include <numbers>

#include <fmt/core.h>

#include "pipeline/config/fraction.h"
#include "pipeline/config/picture_size.h"
#include "pipeline/config/sections/sections.h"
#include "render/scene/scene_problems.h"

namespace carom::pipeline::config {

namespace {

using render::DistributedSettings;
using render::RenderSettings;

/// A rotary shutter's angle as a fraction of a turn; it is exact if given in degrees.
ValueType<Rational> shutter_turn() {
    const TypeInfo type = quantity_info(Dimension::angle, between(0, 20 * std::numbers::pi));
    ValueType<Rational> result;
    result.info = type;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<Rational> {
        const std::optional<Quantity> value = read_quantity(reader, node, type);
        if (!value) {
            return std::nullopt;
        }
        Quantity turns = *value;
        turns.value /= 2 * std::numbers::pi;
        turns.exact = value->exact ? divide(*value->exact, {360, 1}) : std::nullopt;
        return to_rational(turns);
    };
    return result;
}

ValueType<Rational> shutter_time() {
    return exact(Dimension::time, between(0, 3600));
}

ShutterSection turn_of(const Rational& turn) {
    ShutterSection section;
    section.length = turn;
    return section;
}

ShutterSection time_of(const Rational& time) {
    ShutterSection section;
    section.length = time;
    section.is_turn = false;
    return section;
}

const MapSpec<ShutterSection>& shutter_spec() {
    static const MapSpec<ShutterSection> spec = [] {
        MapSpec<ShutterSection> s("shutter", "The exposure of each frame.");
        s.set(
            "angle", shutter_turn(),
            [](ShutterSection& section, const Rational& turn) {
                section.length = turn;
                section.is_turn = true;
            },
            "shutter angle of a rotary shutter: 360 deg is always open", "180 deg");
        s.set(
            "time", shutter_time(),
            [](ShutterSection& section, const Rational& time) {
                section.length = time;
                section.is_turn = false;
            },
            "exposure time, instead of the angle");
        s.key(
            "clock", &ShutterSection::clock,
            choice<ShutterClock>({{"video", ShutterClock::video}, {"scene", ShutterClock::scene}}),
            "clock of the exposure; `scene`: slow motion keeps the blur of real time");
        s.key("position", &ShutterSection::position,
              choice<ShutterPosition>({{"start", ShutterPosition::start},
                                       {"centre", ShutterPosition::centre},
                                       {"end", ShutterPosition::end}}),
              "position of the frame's own time within the exposure");
        s.key("switch_ratio", &ShutterSection::switch_ratio, number(between(0, 1)),
              "fraction of the exposure during which the shutter opens and closes");
        s.at_most_one_of({"angle", "time"});
        return s;
    }();
    return spec;
}

/// A shutter without a map: the unit of the value determines whether it is an angle or a time.
ValueType<ShutterSection> bare_shutter() {
    ValueType<ShutterSection> result;
    result.info.kind = TypeInfo::Kind::any_of;
    result.info.elements = {shutter_turn().info, shutter_time().info};
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<ShutterSection> {
        const std::variant<Quantity, QuantityProblem> parsed = parse_quantity(node.text);
        const Quantity* value = std::get_if<Quantity>(&parsed);
        if (value != nullptr && !value->has_unit && value->value != 0) {
            reader.error(node.place,
                         "'shutter' needs a unit, as in 180 deg or 1/48 s, not " + describe(node));
            return std::nullopt;
        }
        const bool is_time =
            value != nullptr && value->exponents == info(Dimension::time).exponents;
        const bool is_angle =
            value != nullptr && value->exponents == info(Dimension::angle).exponents;
        if (value != nullptr && value->has_unit && !is_angle && !is_time) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        const auto read = (is_angle ? shutter_turn() : shutter_time()).read;
        const std::optional<Rational> length = read(reader, node);
        if (!length) {
            return std::nullopt;
        }
        return is_angle ? turn_of(*length) : time_of(*length);
    };
    return result;
}

ValueType<int> side() {
    return integer(kShortestSide, render::kLongestSide);
}

ValueType<PictureSize> size() {
    return convert<PictureSize>(list_of(side(), 2, 2), [](const std::vector<int>& values) {
        return PictureSize{values[0], values[1]};
    });
}

const MapSpec<DistributedSettings>& distributed_spec() {
    static const MapSpec<DistributedSettings> spec = [] {
        MapSpec<DistributedSettings> s(
            "distributed",
            "Numbers of rays of the distributed integrator. A count of 1 switches its effect off.");
        const auto count = integer(1, 1024);
        const auto count_or_none = integer(0, 1024);
        s.key("pixel_samples", &DistributedSettings::pixel_samples, count,
              "samples over the pixel filter");
        s.key("blur_samples", &DistributedSettings::blur_samples, count,
              "samples over the exposure, for each pixel sample");
        s.key("lens_samples", &DistributedSettings::lens_samples, count,
              "samples over the lens, for each of these");
        s.key("shadow_samples", &DistributedSettings::shadow_samples, count,
              "shadow rays per light and shaded point");
        s.key("reflection_samples", &DistributedSettings::reflection_samples, count_or_none,
              "reflected rays per shaded point, if the surface spreads them; 0 for no reflection");
        s.key("refraction_samples", &DistributedSettings::refraction_samples, count_or_none,
              "refracted rays per shaded point, if the surface spreads them; 0 for no refraction");
        s.key("recursion_limit", &DistributedSettings::recursion_limit, integer(0, 32),
              "largest number of generations of rays after the camera ray");
        s.key("falloff", &DistributedSettings::falloff, boolean(),
              "whether shadow, reflection and refraction samples halve with each generation");
        s.key("ambient_coefficient", &DistributedSettings::ambient_coefficient,
              number(between(0, 1e6)), "radiance of the ambient light");
        return s;
    }();
    return spec;
}

void add_sampling(MapSpec<RenderSection>& s) {
    const auto add = [&s](const char* name, auto field, auto type, const char* description) {
        s.key(
            name, [field](RenderSection & r) -> auto& { return r.settings.*field; }, type,
            description);
    };
    add("integrator", &RenderSettings::integrator,
        choice<render::IntegratorKind>({{"path", render::IntegratorKind::path},
                                        {"distributed", render::IntegratorKind::distributed}}),
        "`path`: a path tracer; `distributed`: the classic distributed ray tracer");
    add("samples", &RenderSettings::samples, integer(1, 65536),
        "samples per pixel, for `path` only. Powers of two converge best");
    add("noise", &RenderSettings::noise, number(between(0, 1)),
        "adaptive sampling: pixels get more than `samples` (which is then even; 8, 32 and 128 "
        "converge best) where that helps most, until the frame's relative error (root mean "
        "square), after denoising if it is on, is this value; 0: each pixel gets `samples`");
    add("max_samples", &RenderSettings::max_samples, integer(1, 65536),
        "largest number of samples of one pixel if `noise` is set");
    add("max_bounces", &RenderSettings::max_bounces, integer(0, 64),
        "largest number of bounces of a path");
    add("clamp", &RenderSettings::clamp, number(between(0, 1e6)),
        "limit of a sample's indirect radiance, which suppresses fireflies; 0: no limit");
    add("filter", &RenderSettings::filter,
        choice<render::PixelFilter>({{"box", render::PixelFilter::box},
                                     {"gaussian", render::PixelFilter::gaussian},
                                     {"blackman_harris", render::PixelFilter::blackman_harris}}),
        "pixel filter");
    add("filter_width", &RenderSettings::filter_width, number(between(0.5, 8)),
        "full width of the filter in pixels; 1 for `box`. The standard deviation of the Gaussian "
        "is a sixth of it");
    add("acceleration", &RenderSettings::acceleration,
        text("the name of an acceleration structure"),
        "acceleration structure that finds the shape that a ray hits: the renderer's own, or one "
        "of the program carom-lab, which has others for comparison "
        "(docs/developers/laboratory.md). The pictures are the same except for the last bits");
    s.set(
        "seed", integer64(0, (std::int64_t{1} << 53U) - 1),
        [](RenderSection& r, std::int64_t seed) {
            r.settings.seed = static_cast<std::uint64_t>(seed);
        },
        "seed of the noise. Another seed gives the same picture with other noise", "0");
}

std::vector<std::pair<std::string, std::string>> aov_names() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const char* name :
         {"depth", "normal", "albedo", "roughness", "motion", "object_id", "material_id",
          "cryptomatte_object", "cryptomatte_material", "variance"}) {
        names.emplace_back(name, name);
    }
    return names;
}

}  // namespace

const MapSpec<RenderSection>& render_spec() {
    static const MapSpec<RenderSection> spec = [] {
        MapSpec<RenderSection> s("render", "How each frame is computed.");
        s.set(
            "size", size(),
            [](RenderSection& r, const PictureSize& size) {
                r.settings.width = size.width;
                r.settings.height = size.height;
            },
            "width and height in pixels", "[1280, 720]");
        s.key("short_side", &RenderSection::short_side, side(),
              "scales the picture until its shorter side has this many pixels. The aspect ratio of "
              "`size` is kept, and both sides are rounded to even numbers. The quality presets use "
              "this key. A `size` that replaces it, in a file that includes it or by `--set`, is "
              "used unchanged");
        s.key("fps", &RenderSection::fps, frame_rate(),
              "frames per second of video, exact: 24000/1001 is not rounded, and is also what "
              "23.976 and 23.98 mean; likewise 29.97, 59.94 and so on");
        s.key(
            "shutter", &RenderSection::shutter,
            any_of<ShutterSection>({{is_scalar, bare_shutter()}, {is_map, record(shutter_spec())}}),
            "an angle such as 180 deg, a time such as 1/48 s, or a map");
        add_sampling(s);
        s.map(
            "distributed",
            [](RenderSection& r) -> DistributedSettings& { return r.settings.distributed; },
            distributed_spec(), "numbers of rays of the distributed integrator");
        s.key(
            "aovs", [](RenderSection& r) -> std::vector<std::string>& { return r.settings.aovs; },
            list_of(choice<std::string>(aov_names()), 0, 10), "further channels of each frame");
        s.check([](Reader& reader, const Node& node, RenderSection& r) {
            const Entry* noise = node.find("noise");
            if (noise != nullptr && r.settings.noise > 0 && r.settings.samples % 2 != 0) {
                reader.error(
                    noise->value.place,
                    fmt::format("'noise' needs 'samples' to be an even number, which {} is not",
                                r.settings.samples));
            }
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config

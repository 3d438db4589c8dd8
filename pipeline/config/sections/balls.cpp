#include "pipeline/config/sections/sections.h"
#include "sim/limits.h"

namespace carom::pipeline::config {

namespace {

using render::BallTexture;

/// Adds the keys of the paint, for a texture, whose fields have defaults, or for changes of one.
template <class T>
void add_paint(MapSpec<T>& s) {
    s.key("colour", &T::colour, colour(between(0, 1)), "colour of the ball or of its stripe");
    s.key("white", &T::white, colour(between(0, 1)),
          "colour of the number's disc and of the parts beside a stripe");
    s.key("striped", &T::striped, boolean(), "whether the colour is a stripe on white");
    s.key("number", &T::number, integer(0, 99), "number printed on the ball; 0: none");
    s.key("disc_radius", &T::disc_radius, number(inside(0, 1)),
          "radius of the number's disc, in ball radii");
    s.key("band_width", &T::band_width, number(inside(0, 1)),
          "width of the stripe, in diameters of the ball");
    s.key("spots", &T::spots, integer(0, 6), "small red dots, as on training balls: 0 or 6");
}

const MapSpec<BallLook>& ball_look_spec() {
    static const MapSpec<BallLook> spec = [] {
        MapSpec<BallLook> s("ball look",
                            "The paint of one ball. The defaults are those of its set.");
        add_paint(s);
        return s;
    }();
    return spec;
}

ValueType<BallLook> ball_look() {
    const auto by_name = convert<BallLook>(name_of(ReferenceKind::material), [](std::string name) {
        BallLook look;
        look.material = std::move(name);
        return look;
    });
    return any_of<BallLook>({{is_scalar, by_name}, {is_map, record(ball_look_spec())}});
}

}  // namespace

const MapSpec<BallTexture>& ball_texture_spec() {
    static const MapSpec<BallTexture> spec = [] {
        MapSpec<BallTexture> s("ball paint", "A billiard ball's colours.");
        add_paint(s);
        return s;
    }();
    return spec;
}

const MapSpec<BallSetSection>& ball_set_spec() {
    static const MapSpec<BallSetSection> spec = [] {
        MapSpec<BallSetSection> s("ball_set",
                                  "Properties of all balls. A single ball may replace them.");
        s.key("kind", &BallSetSection::kind,
              choice<BallSet>({{"pool", BallSet::pool},
                               {"snooker", BallSet::snooker},
                               {"carom", BallSet::carom}}),
              "determines radius, mass and colours. The default is the kind of the table");
        s.key(
            "radius", &BallSetSection::radius, length(between(0.001, 0.5)),
            "radius of a ball. The defaults are pool 28.575 mm, snooker 26.25 mm, carom 30.75 mm");
        s.key("mass", &BallSetSection::mass, quantity(Dimension::mass, inside(0, 100)),
              "mass of a ball. The defaults are pool 170.097 g, snooker 140 g, carom 210 g");
        return s;
    }();
    return spec;
}

const MapSpec<TouchingPlace>& touching_spec() {
    static const MapSpec<TouchingPlace> spec = [] {
        MapSpec<TouchingPlace> s("touching",
                                 "Places a ball on the cloth against another one, the side of an "
                                 "object or a cushion, as players say frozen to it.");
        s.key("ball", &TouchingPlace::partner, name_of(ReferenceKind::ball),
              "the other ball, which lies on the cloth, too");
        s.key("object", &TouchingPlace::partner, name_of(ReferenceKind::touchable),
              "an object with physics that is no mesh");
        s.key("direction", &TouchingPlace::direction, angle(),
              "where this ball lies as seen from the centre of the other or of the object, "
              "counter-clockwise from +x")
            .needed_by({"ball", "object"});
        s.key("cushion", &TouchingPlace::cushion,
              choice<TableSide>({{"front", TableSide::front},
                                 {"right", TableSide::right},
                                 {"back", TableSide::back},
                                 {"left", TableSide::left}}),
              "the side of the table: `front` is -y, `right` +x (docs/tables.md)");
        s.key("along", &TouchingPlace::along, length(),
              "where the ball lies at the cushion: its x at `front` and `back`, its y at `left` "
              "and `right`")
            .needed_by("cushion");
        s.exactly_one_of({"ball", "object", "cushion"});
        return s;
    }();
    return spec;
}

const MapSpec<BallSection>& ball_spec() {
    static const MapSpec<BallSection> spec = [] {
        MapSpec<BallSection> s(
            "ball",
            "One ball. The name of a racked ball changes that ball; any other name adds a ball.");
        s.key("at", &BallSection::at, table_place(),
              "position of the centre, or a spot of the table. With two coordinates or a spot the "
              "ball lies on the cloth. This or `touching` is required unless the ball is racked");
        s.key("touching", &BallSection::touching, record(touching_spec()),
              "position against another ball, an object or a cushion");
        s.at_most_one_of({"at", "touching"});
        s.key("velocity", &BallSection::velocity,
              coordinates(Dimension::speed, between(-sim::kMaxSpeed, sim::kMaxSpeed)),
              "velocity at the start");
        s.key("spin", &BallSection::spin,
              vector3(Dimension::angular_speed, between(-sim::kMaxSpin, sim::kMaxSpin)),
              "angular velocity at the start, world axes");
        s.key("rotate", &BallSection::rotate, rotation(),
              "orientation. By default the seed chooses it");
        s.key("radius", &BallSection::radius, length(between(0.001, 0.5)),
              "radius. The default is that of the set");
        s.key("mass", &BallSection::mass, quantity(Dimension::mass, inside(0, 100)),
              "mass. The default is that of the set");
        s.key("look", &BallSection::look, ball_look(),
              "the name of a material, or a paint. By default a ball of the set has the set's "
              "colours");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config

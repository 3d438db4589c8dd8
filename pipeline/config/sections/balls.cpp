#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using render::BallTexture;

/// The paint's keys for a texture, whose fields have defaults, and for changes of one.
template <class T>
void add_paint(MapSpec<T>& s) {
    s.key("colour", &T::colour, colour(between(0, 1)), "of the ball or its stripe");
    s.key("white", &T::white, colour(between(0, 1)), "of the number's disc and beside a stripe");
    s.key("striped", &T::striped, boolean(), "a band of colour on white");
    s.key("number", &T::number, integer(0, 99), "printed on the ball; 0: none");
    s.key("disc_radius", &T::disc_radius, number(inside(0, 1)),
          "of the number's disc, in ball radii");
    s.key("spots", &T::spots, integer(0, 6), "small red dots, as on training balls: 0 or 6");
}

const MapSpec<BallLook>& ball_look_spec() {
    static const MapSpec<BallLook> spec = [] {
        MapSpec<BallLook> s("ball look",
                            "How one ball is painted; what is left out is as in its set.");
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
                                  "What all balls have in common unless one says otherwise.");
        s.key("kind", &BallSetSection::kind,
              choice<BallSet>({{"pool", BallSet::pool},
                               {"snooker", BallSet::snooker},
                               {"carom", BallSet::carom}}),
              "gives radius, mass and colours; without it the table's kind does");
        s.key("radius", &BallSetSection::radius, length(inside(0, 0.5)),
              "pool 28.575 mm, snooker 26.19375 mm, carom 30.75 mm");
        s.key("mass", &BallSetSection::mass, quantity(Dimension::mass, inside(0, 100)),
              "pool 170.097 g, snooker 140 g, carom 210 g");
        return s;
    }();
    return spec;
}

const MapSpec<BallSection>& ball_spec() {
    static const MapSpec<BallSection> spec = [] {
        MapSpec<BallSection> s("ball",
                               "One ball. The name of a racked ball changes that one; any other "
                               "name adds a ball.");
        s.key("at", &BallSection::at, coordinates(Dimension::length),
              "centre; with two coordinates it lies on the cloth. Needed unless it is racked");
        s.key("velocity", &BallSection::velocity, coordinates(Dimension::speed), "at the start");
        s.key("spin", &BallSection::spin, vector3(Dimension::angular_speed),
              "angular velocity at the start, world axes");
        s.key("rotate", &BallSection::rotate, rotation(),
              "how it is turned; without it the seed decides");
        s.key("radius", &BallSection::radius, length(inside(0, 0.5)), "the set's unless given");
        s.key("mass", &BallSection::mass, quantity(Dimension::mass, inside(0, 100)),
              "the set's unless given");
        s.key("look", &BallSection::look, ball_look(),
              "a material's name or its own paint; a ball of the set has the set's colours");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config

#include "tests/pipeline/config/damage/random_shot.h"

#include <algorithm>

namespace carom::testing {

namespace {

class ShotMaker {
  public:
    explicit ShotMaker(Dice& dice) : dice_(dice) {}

    Yaml make() {
        shot_.add("carom", "1");
        shot_.add("simulation", simulation());
        shot_.add("table", Yaml().add("kind", dice_.pick({"pool", "snooker", "carom", "carom",
                                                          "carom", "carom"})));
        if (dice_.chance(0.4)) {
            shot_.add("physics", physics());
        }
        shot_.add("balls", balls());
        shot_.add("objects", objects());
        shot_.add("events", events());
        shot_.add("materials", materials());
        shot_.add("lights", lights());
        shot_.add("cameras", cameras());
        shot_.add("render", render());
        if (dice_.chance(0.7)) {
            shot_.add("output", output());
        }
        if (dice_.chance(0.4)) {
            shot_.add("sound", sound());
        }
        std::rotate(
            shot_.entries.begin() + 1,
            shot_.entries.begin() + 1 + dice_.below(static_cast<int>(shot_.entries.size()) - 1),
            shot_.entries.end());
        return std::move(shot_);
    }

  private:
    /// A number with few digits.
    std::string number(double low, double high) {
        const double digits = high - low > 20 ? 1 : 100;
        return Dice::text(std::round(dice_.between(low, high) * digits) / digits);
    }
    std::string length(double low, double high) {
        switch (dice_.below(4)) {
            case 0:
                return Dice::text(std::round(1000 * dice_.between(low, high))) + " mm";
            case 1:
                return Dice::text(std::round(1000 * dice_.between(low, high)) / 10) + " cm";
            case 2:
                return number(low, high) + " m";
            default:
                return number(low, high);
        }
    }
    std::string time(double low, double high) {
        return dice_.chance(0.2) ? Dice::text(std::round(1000 * dice_.between(low, high))) + " ms"
                                 : number(low, high) + (dice_.chance(0.7) ? " s" : "");
    }
    std::string angle(double low, double high) {
        return dice_.chance(0.9) ? number(low, high) + " deg"
                                 : Dice::text(std::round(dice_.between(low, high)) / 57) + " rad";
    }
    std::string speed() {
        return number(0.5, 6) + dice_.pick({"", " m/s", " m/s", " km/h", " mph"});
    }
    std::string spin() { return number(-80, 80) + dice_.pick({" rad/s", " rpm", " deg/s"}); }
    Yaml point(double x, double y, double low, double high) {
        return Yaml::list({length(-x, x), length(-y, y), length(low, high)});
    }
    Yaml vector(double low, double high) {
        return Yaml::list({number(low, high), number(low, high), number(low, high)});
    }
    Yaml colour() { return dice_.chance(0.3) ? Yaml("'#1a6b3c'") : vector(0, 1); }
    std::string one_of(const std::vector<std::string>& names) {
        return names[static_cast<std::size_t>(dice_.below(static_cast<int>(names.size())))];
    }

    Yaml simulation() {
        return Yaml().add("duration", "4 s").add("seed", std::to_string(dice_.below(100)));
    }

    Yaml physics() {
        Yaml map;
        map.add("gravity", dice_.pick({"9.81", "9.81 m/s^2", "[0, 0, -9.8]"}));
        if (map.entries[0].second.text[0] == '[') {
            map.entries[0].second = Yaml::list({"0", "0", "-9.8 m/s^2"});
        }
        map.add("ball_ball", Yaml().add("restitution", number(0.8, 1)).add("friction", "0.06"));
        map.add("hop", dice_.pick({"true", "false"}));
        return map;
    }

    Yaml sound() {
        Yaml map;
        map.add("room", dice_.pick({"none", "club", "hall", "outdoors"}));
        map.add("pitch", dice_.pick({"follow", "keep", "0.5"}));
        map.add("mix", Yaml().add("rolling", number(-20, 20) + " dB"));
        if (dice_.chance(0.5)) {
            map.add("loudness", number(-30, -10) + " LUFS");
        } else {
            map.add("gain", Yaml().add("full_scale", number(1, 20) + " Pa"));
        }
        if (dice_.chance(0.5)) {
            map.add("listener",
                    Yaml().add("at", point(1, 1, 0.5, 1)).add("facing", vector(0.1, 1)));
        }
        if (dice_.chance(0.5)) {
            map.add("materials", Yaml().add("ball", Yaml().add("modulus", number(4, 10) + " GPa")));
        }
        return map;
    }

    Yaml balls() {
        Yaml map;
        const int count = 2 + dice_.below(4);
        for (int i = 0; i < count; ++i) {
            const std::string name = dice_.pick({"cue", "red", "ball_"}) + std::to_string(i);
            Yaml ball;
            ball.add("at", Yaml::list({Dice::text(0.2 * i - 0.5), length(-0.3, 0.3)}));
            if (dice_.chance(0.3)) {
                ball.add("velocity", Yaml::list({speed(), speed()}));
                ball.add("spin", Yaml::list({"0", spin(), spin()}));
            }
            if (dice_.chance(0.4)) {
                ball.add("look", dice_.chance(0.5)
                                     ? Yaml::free_text("paint")
                                     : Yaml().add("colour", colour()).add("number", "7"));
            }
            map.add(name, std::move(ball));
            balls_.push_back(name);
        }
        return map;
    }

    Yaml objects() {
        Yaml map;
        const int count = 1 + dice_.below(3);
        for (int i = 0; i < count; ++i) {
            Yaml object;
            object.add("box",
                       Yaml::list({length(0.02, 0.1), length(0.02, 0.1), length(0.02, 0.1)}));
            object.add("at", Yaml::list({Dice::text(0.3 * i - 0.5), "0.42", length(0.4, 0.6)}));
            object.add("material", Yaml::free_text("paint"));
            if (dice_.chance(0.5)) {
                object.add("rotate", Yaml::list({angle(-90, 90), "0", angle(-90, 90)}));
            } else if (dice_.chance(0.5)) {
                object.add("rotate",
                           Yaml().add("axis", vector(0.1, 1)).add("angle", angle(-90, 90)));
            }
            if (dice_.chance(0.3)) {
                object.add("physics", Yaml().add("mass", number(50, 500) + " g"));
            }
            map.add("thing_" + std::to_string(i), std::move(object));
        }
        return map;
    }

    void add_moment(Yaml& event) {
        if (dice_.chance(0.5)) {
            event.add("at", time(0.1, 2));
        } else if (dice_.chance(0.5)) {
            event.add("when", Yaml().add("contact", Yaml::list({Yaml::free_text(one_of(balls_)),
                                                                Yaml::free_text("cushion")})));
        } else {
            event.add("when", Yaml().add("resting", Yaml::free_text(one_of(balls_))));
            event.add("after", time(0.1, 1));
        }
    }

    Yaml strike() {
        Yaml event;
        event.add("ball", Yaml::free_text(balls_[0]));
        add_moment(event);
        if (dice_.chance(0.5)) {
            event.add("direction", angle(0, 360));
        } else {
            event.add("toward", Yaml::free_text(balls_[1]));
        }
        event.add(dice_.pick({"speed", "ball_speed"}), speed());
        if (dice_.chance(0.5)) {
            event.add("elevation", angle(1, 60));
            event.add("tip", Yaml::list({number(-0.5, 0.5), number(-0.5, 0.5)}));
        }
        return event;
    }

    Yaml events() {
        Yaml all = Yaml::list({Yaml().add("strike", strike())});
        const int count = dice_.below(3);
        for (int i = 0; i < count; ++i) {
            Yaml event;
            event.add("object", Yaml::free_text(one_of(balls_)));
            add_moment(event);
            if (dice_.chance(0.5)) {
                event.add("linear", Yaml::list({speed(), speed(), "0"}));
                event.add("angular", Yaml::list({spin(), spin(), "0"}));
                all.items.push_back(Yaml().add("velocity", std::move(event)));
            } else {
                event.add("newton_seconds", vector(-0.2, 0.2));
                all.items.push_back(Yaml().add("impulse", std::move(event)));
            }
        }
        return all;
    }

    Yaml materials() {
        Yaml standard;
        standard.add("base", colour());
        if (dice_.chance(0.5)) {
            standard.add("roughness", number(0, 1));
        } else {
            Yaml checker = Yaml().add("size", length(0.01, 0.1)).add("mapping", "box");
            standard.add("roughness", Yaml()
                                          .add("checker", std::move(checker))
                                          .add("range", Yaml::list({number(0, 1), number(0, 1)})));
        }
        if (dice_.chance(0.3)) {
            Yaml wood = Yaml().add("wood", Yaml().add("rotate", angle(0, 90)));
            standard.add(
                "emission",
                Yaml().add(
                    "mix",
                    Yaml().add("a", std::move(wood)).add("b", colour()).add("by", number(0, 1))));
            standard.add("emission_strength", number(1, 9));
        }
        if (dice_.chance(0.5)) {
            standard.add("coat", Yaml().add("weight", number(0, 1)).add("ior", number(1.1, 2)));
        }
        return Yaml().add("paint", Yaml().add("standard", std::move(standard)));
    }

    Yaml lights() {
        Yaml map;
        map.add("lamp", Yaml()
                            .add("rectangle", Yaml::list({length(0.3, 1), length(0.3, 1)}))
                            .add("at", point(1, 1, 1, 2))
                            .add("radiance", vector(1, 20)));
        if (dice_.chance(0.5)) {
            map.add("spot", Yaml()
                                .add("spot", vector(1, 9))
                                .add("at", point(1, 1, 1, 2))
                                .add("facing", Yaml::list({"0", "0.1", "-1"}))
                                .add("angle", Yaml::list({angle(10, 20), angle(25, 60)})));
        }
        if (dice_.chance(0.5)) {
            map.add("room", Yaml().add("environment", number(0.1, 1)));
        }
        return map;
    }

    Yaml path() {
        switch (dice_.below(4)) {
            case 0:
                return Yaml()
                    .add("orbit", Yaml::list({"0", "0", "0.1"}))
                    .add("radius", length(1, 2))
                    .add("angles", Yaml::list({angle(0, 90), angle(100, 200)}))
                    .add("offset", Yaml::list({"0", "0", length(0.5, 1)}));
            case 1:
                return Yaml()
                    .add("bezier", Yaml::list({point(2, 2, 0.5, 2), point(2, 2, 0.5, 2)}))
                    .add("pace", dice_.pick({"time", "even"}));
            case 2:
                return Yaml()
                    .add("follow", Yaml::free_text(one_of(balls_)))
                    .add("offset", Yaml::list({length(-1, -0.5), "0.3", length(0.5, 1)}))
                    .add("smoothing", time(0.1, 0.5));
            default:
                return point(2, 2, 0.5, 2);
        }
    }

    Yaml camera(const std::string& from, const std::string& to) {
        Yaml map;
        if (dice_.chance(0.6)) {
            map.add("name", Yaml::free_text("view " + from + " and on"));
        }
        map.add("video", Yaml::list({from, to}));
        map.add("scene", Yaml::list({time(0.1, 1.5), time(1.6, 3)}));
        map.add("position", path());
        map.add("target", dice_.chance(0.3) ? Yaml().add("follow", Yaml::free_text(one_of(balls_)))
                                            : Yaml::list({"0", "0.01", "0.02"}));
        if (dice_.chance(0.7)) {
            map.add("fov", dice_.chance(0.7) ? Yaml(angle(20, 60))
                                             : Yaml::list({angle(20, 30), angle(35, 60)}));
        } else {
            map.add("focal_length", number(20, 80) + " mm");
        }
        if (dice_.chance(0.5)) {
            map.add("focus",
                    dice_.chance(0.5) ? Yaml(length(0.5, 2)) : Yaml::free_text(one_of(balls_)));
            map.add("aperture", number(1, 9) + " mm");
        }
        return map;
    }

    Yaml cameras() {
        Yaml all = Yaml::list({camera("0 s", "1 s")});
        if (dice_.chance(0.5)) {
            all.items.push_back(camera("1 s", "2"));
        }
        return all;
    }

    Yaml render() {
        Yaml map;
        map.add("size", Yaml::list({"640", "360"}));
        map.add("fps", dice_.pick({"24", "25 fps", "24000/1001", "30 Hz"}));
        map.add("shutter", dice_.pick({"180 deg", "1/48 s", "10 ms"}));
        map.add("samples", std::to_string(1 + dice_.below(64)));
        if (dice_.chance(0.5)) {
            map.add("integrator", dice_.pick({"path", "distributed"}));
            map.add("aovs", Yaml::list({"depth", "normal"}));
        }
        return map;
    }

    Yaml output() {
        Yaml map;
        map.add("title", Yaml::free_text("shot number " + std::to_string(dice_.below(50))));
        map.add("crf", std::to_string(10 + dice_.below(20)));
        if (dice_.chance(0.5)) {
            map.add("overlay", Yaml::list({"frame", "scene_time"}));
        }
        return map;
    }

    Dice& dice_;
    Yaml shot_;
    std::vector<std::string> balls_;
};

}  // namespace

Yaml random_shot(Dice& dice) {
    return ShotMaker(dice).make();
}

}  // namespace carom::testing

#include "tests/random_films/random_film.h"

#include <vector>

#include "tests/random_films/dice.h"

namespace carom::testing {
namespace {

std::string listed(const std::vector<std::string>& items) {
    std::string text = "[";
    for (std::size_t i = 0; i < items.size(); ++i)
        text += (i > 0 ? ", " : "") + items[i];
    return text + "]";
}

class FilmWriter {
  public:
    explicit FilmWriter(std::uint64_t number) : dice_(number) {}

    std::string write() {
        text_ = "carom: 1\n";
        simulation();
        table();
        materials();
        balls();
        objects();
        events();
        lights();
        cameras();
        render();
        return text_;
    }

  private:
    void line(const std::string& what) { text_ += what + "\n"; }

    void simulation() {
        duration_ = dice_.between(0.2, 2);
        line("simulation: {duration: " + Dice::text(duration_) +
             ", seed: " + std::to_string(dice_.below(1000)) + "}");
        if (!dice_.chance(0.5))
            return;
        line("physics: {gravity: " + dice_.pick({"9.81", "1.6", "0", "[0.5, 0, -9]"}) +
             ", ball_cushion: {model: " + dice_.pick({"mirror", "han2005", "mathavan2010"}) +
             "}, ball_ball: {friction: " + dice_.pick({"0", "0.06", "alciatore"}) +
             "}, otherwise: {restitution: " + dice_.number(0, 1) + ", friction: " +
             dice_.number(0, 1) + "}, hop: " + dice_.pick({"true", "false"}) + "}");
    }

    void table() {
        const std::string kind = dice_.pick({"pool", "snooker", "carom", "cloth", "cloth"});
        line("table: {kind: " + kind + "}");
        has_rack_ = kind == "pool" && dice_.chance(0.2);
        if (has_rack_)
            line("rack: {set: " + dice_.pick({"nine_ball", "eight_ball"}) + "}");
    }

    std::string surface_texture() {
        switch (dice_.below(5)) {
            case 0:
                return "{cloth: {colour: " + dice_.colour() +
                       ", thread: " + dice_.magnitude(1e-4, 0.1) + "}}";
            case 1:
                return "{wood: {ring: " + dice_.magnitude(1e-4, 1) + ", grain: [0, " +
                       dice_.number(-1, 1) + ", 1]}}";
            case 2:
                return "{checker: {even: " + dice_.colour() +
                       ", size: " + dice_.magnitude(1e-3, 10) + "}}";
            case 3:
                return "{ball: {colour: " + dice_.colour() +
                       ", striped: " + dice_.pick({"true", "false"}) +
                       ", number: " + std::to_string(dice_.below(100)) + "}}";
            default:
                return dice_.colour();
        }
    }

    void material(const std::string& name) {
        if (dice_.chance(0.25)) {
            line("  " + name + ": {phong: {diffuse: " + surface_texture() +
                 ", specular: " + dice_.colour() + ", shininess: " + dice_.magnitude(1, 1e5) +
                 ", reflectance: " + dice_.colour() +
                 ", reflectance_spread: " + dice_.number(0, 0.5) + " rad" +
                 ", transmittance: " + dice_.colour() + ", index: " + dice_.number(0.5, 3) + "}}");
            return;
        }
        std::string keys = "base: " + surface_texture() +
                           ", metal: " + dice_.pick({"0", "0", "0.5", "1"}) +
                           ", roughness: " + dice_.pick({"0", "0.02", "0.3", "1"});
        if (dice_.chance(0.3))
            keys += ", transmission: " + dice_.pick({"0.5", "1"}) + ", ior: " + dice_.number(1, 3) +
                    ", transmission_colour: " + dice_.colour() +
                    ", transmission_depth: " + dice_.pick({"0", "0.05"});
        if (dice_.chance(0.3))
            keys += ", sheen: " + dice_.number(0, 1) + ", specular: " + dice_.number(0, 1) +
                    ", bump: " + dice_.number(0, 1);
        if (dice_.chance(0.4))
            keys += ", coat: {weight: " + dice_.number(0, 1) + ", ior: " + dice_.number(1, 3) +
                    ", roughness: " + dice_.pick({"0", "0.1", "1"}) + "}";
        if (dice_.chance(0.1))
            keys += ", emission: " + dice_.vector(0, 20);
        line("  " + name + ": {standard: {" + keys + "}}");
    }

    void materials() {
        line("materials:");
        for (const char* name : {"m0", "m1", "m2", "m3"})
            material(name);
    }

    std::string a_material() { return "m" + std::to_string(dice_.below(4)); }

    /// Places the balls on a lattice, so that they do not overlap.
    void balls() {
        line("balls:");
        const int count = 1 + dice_.below(8);
        for (int i = 0; i < count; ++i) {
            const std::string name = "b" + std::to_string(i);
            // If the shot has a rack, they are on the other half of the table.
            const double x = has_rack_ ? -0.1 * (i + 1) : 0.18 * (i - 3.5);
            std::string keys = "at: [" + Dice::text(x) + ", " + dice_.number(-0.25, 0.1);
            keys += dice_.chance(0.15) ? ", " + dice_.number(0.1, 0.5) + "]" : "]";
            if (dice_.chance(0.4))
                keys += ", velocity: [" + dice_.number(-8, 8) + ", " + dice_.number(-8, 8) +
                        "], spin: " + dice_.vector(-100, 100, "rad/s");
            if (dice_.chance(0.4))
                keys += ", look: " + a_material();
            line("  " + name + ": {" + keys + "}");
            balls_.push_back(name);
            moving_.push_back(name);
        }
    }

    std::string shape(bool is_solid) {
        const std::string size = dice_.magnitude(0.01, 0.15);
        switch (dice_.below(is_solid ? 5 : 10)) {
            case 0:
                return "box: [" + size + ", " + dice_.magnitude(0.01, 0.15) + ", " +
                       dice_.magnitude(0.01, 0.15) + "]";
            case 1:
                return "capsule: {radius: " + size + ", length: " + dice_.magnitude(0.01, 0.2) +
                       "}";
            case 2:
                return "cylinder: {radius: " + size + ", height: " + dice_.magnitude(0.01, 0.2) +
                       "}";
            case 3:
                return "hull: [[0, 0, 0], [" + size + ", 0, 0], [0, " + size + ", 0], [0, 0.01, " +
                       size + "], [0.02, 0.02, " + dice_.magnitude(0.03, 0.1) + "]]";
            case 4:
                return "sphere: " + size;
            case 5:
                return "cone: {radius: " + size + ", top_radius: " + dice_.pick({"0", "0.01"}) +
                       ", height: 0.1}";
            case 6:
                return "disk: " + size;
            case 7:
                return "rectangle: [" + size + ", " + dice_.magnitude(0.01, 1) + "]";
            case 8:
                return "triangle: [[0, 0, 0], [" + size + ", 0, 0], [0, 0.1, 0.05]]";
            default:
                return "parallelogram: [[0, 0, 0], [" + size + ", 0, 0], [0, 0.1, 0.05]]";
        }
    }

    std::string motion() {
        return "motion: {easing: " + dice_.pick({"smooth", "linear"}) +
               ", keys: [{at: " + dice_.number(0, 0.3) + "}, {at: " + dice_.number(0.4, 1) +
               ", position: " + dice_.point(0.5, 0.5, 0.1, 0.6) +
               ", turn: {axis: [0, 0.1, 1], angle: " + dice_.number(-9, 9) + " rad}}]}";
    }

    void objects() {
        const int count = dice_.below(6);
        if (count > 0)
            line("objects:");
        for (int i = 0; i < count; ++i) {
            const std::string name = "o" + std::to_string(i);
            const int role = dice_.below(5);  // decoration, fixed, dynamic, keyed, keyed and solid
            const bool is_solid = role == 2 || role == 4;
            // Objects are in a row beside that of the balls, at random heights.
            std::string keys = shape(is_solid) + ", at: [" + Dice::text(0.35 * (i - 2.5)) +
                               ", 0.38, " + dice_.number(0.25, 0.6) +
                               "], material: " + a_material();
            if (dice_.chance(0.5))
                keys += ", rotate: " + dice_.vector(-3, 3, "rad");
            if (role == 1)
                keys += ", physics: fixed";
            if (role == 2)
                keys += ", physics: {density: " + dice_.magnitude(50, 9000) +
                        " kg/m^3, velocity: " + dice_.vector(-2, 2) +
                        ", spin: " + dice_.vector(-20, 20, "rad/s") + "}";
            if (role >= 3)
                keys += ", " + motion();
            if (role == 4)
                keys += ", physics: true";
            line("  " + name + ": {" + keys + "}");
            if (role == 2)
                bodies_.push_back(name);
            if (role >= 2)
                moving_.push_back(name);
        }
    }

    std::string one_of(const std::vector<std::string>& names) {
        return names[static_cast<std::size_t>(dice_.below(static_cast<int>(names.size())))];
    }

    std::string moment() {
        switch (dice_.below(5)) {
            case 0:
                return "when: {contact: [" + one_of(balls_) +
                       ", cloth]}, after: " + dice_.number(0, 0.2);
            case 1:
                return "when: {resting: " + dice_.pick({"all", "b0"}) + "}";
            case 2:
                return "when: {crossing: {object: " + one_of(balls_) +
                       ", from: [0, -1], to: [0.1, 1]}}";
            default:
                return "at: " + dice_.number(0, duration_);
        }
    }

    void events() {
        const int count = dice_.below(4);
        if (count > 0)
            line("events:");
        for (int i = 0; i < count; ++i) {
            const std::string object =
                bodies_.empty() || dice_.chance(0.5) ? one_of(balls_) : one_of(bodies_);
            switch (dice_.below(5)) {
                case 0:
                    line("  - strike: {ball: " + one_of(balls_) + ", " + moment() +
                         ", direction: " + dice_.number(0, 6.2) +
                         " rad, speed: " + dice_.magnitude(0.1, 12) +
                         ", elevation: " + dice_.number(0, 1.2) + " rad, tip: [" +
                         dice_.number(-0.5, 0.5) + ", " + dice_.number(-0.5, 0.5) + "]}");
                    break;
                case 1:
                    line("  - impulse: {object: " + object + ", " + moment() +
                         ", newton_seconds: " + dice_.vector(-1, 1) +
                         ", at_point: [0, 0, 0.01], axes: " + dice_.pick({"world", "body"}) + "}");
                    break;
                case 2:
                    line("  - force: {object: " + object + ", " + moment() + ", for: " +
                         dice_.number(0.01, 1) + ", newtons: " + dice_.vector(-3, 3) + "}");
                    break;
                case 3:
                    line("  - torque: {object: " + object + ", " + moment() +
                         ", for: " + dice_.number(0.01, 1) +
                         ", newton_metres: " + dice_.vector(-0.02, 0.02) + "}");
                    break;
                default:
                    line("  - velocity: {object: " + object + ", " + moment() +
                         ", linear: " + dice_.vector(-3, 3) +
                         ", angular: " + dice_.vector(-50, 50, "rad/s") + "}");
            }
        }
    }

    void lights() {
        line("lights:");
        const int count = 1 + dice_.below(3);
        for (int i = 0; i < count; ++i) {
            const std::string at = "at: " + dice_.point(1.5, 1.5, 0.8, 2);
            const std::vector<std::string> kinds{
                "point: " + dice_.vector(0, 5) + ", " + at,
                "spot: " + dice_.vector(0, 20) + ", " + at +
                    ", facing: [0.1, 0.2, -1], angle: [0.3 rad, 0.6 rad]",
                "directional: " + dice_.vector(0, 3) + ", facing: [" + dice_.number(-1, 1) +
                    ", 0.3, -1]",
                "rectangle: [" + dice_.magnitude(0.01, 2) + ", " + dice_.magnitude(0.01, 2) +
                    "], " + at + ", radiance: " + dice_.vector(0, 30),
                "sphere: " + dice_.magnitude(0.005, 0.4) + ", " + at +
                    ", radiance: " + dice_.vector(0, 30)};
            line("  l" + std::to_string(i) + ": {" + one_of(kinds) + "}");
        }
        if (dice_.chance(0.4))
            line("  room: {environment: " +
                 (dice_.chance(0.5) ? dice_.colour()
                                    : "{sun: [1, " + dice_.number(-1, 1) +
                                          ", 0.6], turbidity: " + dice_.number(2, 10) + "}") +
                 "}");
    }

    std::string camera_path() {
        switch (dice_.below(5)) {
            case 0:
                return "{orbit: [0, 0, 0.1], radius: [" + dice_.number(0.5, 2) + ", " +
                       dice_.number(0.5, 2) + "], angles: [" + dice_.number(-6, 6) + " rad, " +
                       dice_.number(-6, 6) + " rad], offset: [0, 0, 0.7]}";
            case 1:
                return "{bezier: [" + dice_.point(2, 2, 0.3, 2) + ", " + dice_.point(2, 2, 0.3, 2) +
                       ", " + dice_.point(2, 2, 0.3, 2) +
                       "], pace: " + dice_.pick({"time", "even"}) + "}";
            case 2:
                return "{follow: " + one_of(moving_) +
                       ", offset: [-0.6, 0.3, 0.5], smoothing: " + dice_.number(0, 0.5) + "}";
            default:
                return dice_.point(2, 2, 0.3, 2);
        }
    }

    void camera(double from, double to) {
        line("  - video: [" + Dice::text(from) + ", " + Dice::text(to) + "]");
        line("    scene: [" + dice_.number(0, duration_) + ", " + dice_.number(0, duration_) + "]");
        line("    position: " + camera_path());
        line("    target: " + (dice_.chance(0.3) ? "{follow: " + one_of(moving_) + "}"
                                                 : std::string("[0, 0.01, 0.02]")));
        line("    fov: " + dice_.number(0.2, 1.6) + " rad");
        line("    focus: " + dice_.pick({"auto", "0.8", "b0"}));
        line("    aperture: " + dice_.pick({"0", "0.002 m", "0.05 m"}));
        line("    blades: " + dice_.pick({"0", "5"}));
    }

    void cameras() {
        line("cameras:");
        const bool are_two = dice_.chance(0.3);
        camera(0, are_two ? 0.4 : 0.8);
        if (are_two)
            camera(0.4, 0.8);
    }

    void render() {
        std::vector<std::string> aovs;
        for (const char* name : {"depth", "normal", "albedo", "roughness", "motion", "object_id",
                                 "cryptomatte_object", "variance"}) {
            if (dice_.chance(0.15))
                aovs.emplace_back(name);
        }
        line("render:");
        line("  size: [64, 36]");
        line("  fps: " + dice_.pick({"10", "24", "24000/1001", "100"}));
        line("  shutter: " + dice_.pick({"0 deg", "180 deg", "360 deg", "0.1 s",
                                         "{angle: 90 deg, position: end}"}));
        line("  samples: " + dice_.pick({"1", "4", "8"}));
        line("  max_bounces: " + dice_.pick({"0", "1", "4", "12"}));
        line("  filter: " + dice_.pick({"box", "gaussian", "blackman_harris"}));
        line("  filter_width: " + dice_.number(0.5, 3));
        line("  integrator: " + dice_.pick({"path", "path", "path", "distributed"}));
        line(
            "  distributed: {pixel_samples: 1, blur_samples: 2, lens_samples: 2, shadow_samples: "
            "2, reflection_samples: 2, "
            "refraction_samples: 1, recursion_limit: " +
            dice_.pick({"0", "2", "3"}) + "}");
        line("  acceleration: " +
             dice_.pick({"hybrid", "hybrid", "hybrid", "embree", "grid", "octree", "kdtree", "bsp",
                         "rtree", "kay_kajiya", "bvh", "wide_bvh"}));
        line("  aovs: " + listed(aovs));
    }

    Dice dice_;
    std::string text_;
    double duration_ = 1;
    bool has_rack_ = false;
    std::vector<std::string> balls_, bodies_, moving_;
};

}  // namespace

std::string random_film(std::uint64_t number) {
    return FilmWriter(number).write();
}

}  // namespace carom::testing

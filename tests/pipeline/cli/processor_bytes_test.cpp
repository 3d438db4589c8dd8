// A film has the same bytes on processors for which the C library chooses other routines: it is
// made twice, the second time without fused multiply-add in the C library's functions.
#include <sstream>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::run_carom;
using carom::testing::RunOptions;
using carom::testing::RunResult;
using carom::testing::write_text;

namespace fs = std::filesystem;

// Angles and focal lengths are such that with glibc 2.36 the last bit of their sines, cosines or
// arc tangents depends on its routine: one in some thousand values does.
constexpr const char* kShot = R"(carom: 1
simulation: {duration: 0.8 s}
table: {kind: pool}
balls:
  cue: {at: [-0.3, 0.02]}
  one: {at: [0.1, 0.01]}
  two: {at: [0.16, 0.05]}
materials:
  tinted:
    standard: {base: 1, transmission: 1, roughness: 0.2, transmission_colour: [0.7, 0.9, 0.8],
               transmission_depth: 5 cm}
  plastic:
    phong: {diffuse: [0.3, 0.1, 0.1], specular: 0.4, shininess: 27.3, reflectance: 0.2,
            reflectance_spread: 5 deg}
  paper: {standard: {base: {image: {file: room.ppm, size: [20 cm, 10 cm], rotate: 48 deg}}}}
objects:
  lens: {sphere: 40 mm, at: [0.1, -0.15, 0.04], material: tinted}
  knob: {sphere: 45 mm, at: [-0.1, 0.2, 0.045], material: plastic}
  die: {box: [5 cm, 5 cm, 5 cm], at: [0.3, -0.1, 0.08], rotate: [52.4 deg, 96 deg, 0],
        material: paper, physics: {density: 700 kg/m^3}}
events:
  - strike: {ball: cue, at: 0.05 s, toward: one, speed: 3, tip: [0.2, 0.1], elevation: 4 deg}
lights:
  room: {environment: ENVIRONMENT, rotation: 33 deg}
  lamp: {rectangle: [0.7, 0.3], at: [0, 0, 1], facing: [0, 0.1, -1], roll: 48 deg,
         radiance: [6, 6, 6]}
  bulb: {sphere: 4 cm, at: [0.5, -0.4, 0.7], radiance: [60, 50, 40]}
  evening: {spot: [3, 2, 2], at: [-0.5, -1, 1.2], facing: [0.5, 1, -1], angle: [16 deg, 24 deg]}
cameras:
  - name: seat
    video: [0 s, 0.6 s]
    scene: [0 s, 0.6 s]
    position: {bezier: [[-0.6, -0.7, 0.4], [-0.1, -0.8, 0.5], {of: one, at: 0.3 s,
               offset: [0.3, -0.5, 0.3]}], pace: even, easing: smooth}
    target: {follow: cue, smoothing: 0.2 s}
    focal_length: {from: 54.2 mm, to: 99.7 mm}
    aperture: 8 mm
    roll: {from: 3 deg, to: -4 deg}
  - name: ring
    video: [0.6 s, 1.2 s]
    scene: [0.1 s, 0.7 s]
    position: {orbit: cue, radius: [0.9 m, 0.7 m], angles: [48 deg, 136.3 deg],
               turn: [52.4 deg, 3 deg, 0], offset: [0, 0, 0.4]}
    target: {along: one, from: 0 s, to: 0.7 s}
    fov: 38 deg
render: {size: [64, 36], fps: 10, samples: 2, max_bounces: 4, filter: gaussian}
output: {view: agx, exposure: 0.3, glow: {strength: 0.04}}
)";

/// A picture of many colours, as text.
std::string room_picture() {
    std::ostringstream text;
    text << "P3\n32 16\n255\n";
    for (int i = 0; i < 3 * 32 * 16; ++i) {
        text << (37 * i + i * i % 91) % 256 << '\n';
    }
    return text.str();
}

std::string shot_with(const std::string& environment) {
    std::string text = kShot;
    const std::string word = "ENVIRONMENT";
    text.replace(text.find(word), word.size(), environment);
    return text;
}

class ProcessorBytes : public EndToEnd {
  protected:
    ProcessorBytes() { write_text(path("room.ppm"), room_picture()); }

    /// Writes the bake, the pictures and the film of the shot into the folder `name`, with its own
    /// cache.
    void make_film(const std::string& name, std::map<std::string, std::string> environment,
                   const std::vector<std::string>& settings) const {
        fs::create_directory(path(name));
        environment["CAROM_CACHE"] = path(name + "/cache");
        const RunOptions options{path(""), environment};
        for (const char* file : {"/shot.bake", "/shot.####.exr", "/shot.mp4"}) {
            const bool is_bake = std::string(file).ends_with("bake");
            std::vector<std::string> command{is_bake ? "bake" : "render", "shot.yaml", "-o",
                                             name + file};
            for (const std::string& setting : settings) {
                command.insert(command.end(), {"--set", setting});
            }
            const RunResult result = run_carom(command, options);
            ASSERT_EQ(result.exit_code, 0) << result.err;
        }
    }

    /// The files below a folder, by their names in it: a frame of the cache is named by its key.
    [[nodiscard]] std::map<std::string, std::string> files_in(const std::string& name) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".exr" || extension == ".bake" || extension == ".mp4") {
                files[fs::relative(entry.path(), path(name)).string()] =
                    carom::testing::read_text(entry.path().string());
            }
        }
        return files;
    }

    void expect_same_bytes(const std::string& shot, const std::vector<std::string>& settings = {}) {
        write_text(path("shot.yaml"), shot);
        make_film("usual", {}, settings);
        make_film("other",
                  {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX,-FMA4"},
                   {"CAROM_SIMD", "scalar"}},
                  settings);
        const auto usual = files_in("usual");
        const auto other = files_in("other");
        EXPECT_EQ(usual.size(), 12U + 12U + 3U);  // frames twice, two bakes and the film
        for (const auto& [name, bytes] : usual) {
            const auto found = other.find(name);
            EXPECT_TRUE(found != other.end()) << name << " is missing: its key differs";
            EXPECT_TRUE(found == other.end() || found->second == bytes) << name << " differs";
        }
    }
};

TEST_F(ProcessorBytes, PathTracedFilm_DoesNotDependOnTheCLibrary) {
    expect_same_bytes(shot_with("room.ppm"));
}

TEST_F(ProcessorBytes, SkyAndFilmicView_DoNotDependOnTheCLibrary) {
    expect_same_bytes(shot_with("{sun: [-0.75, -0.8, 0.5], turbidity: 2.6}, strength: 0.01"),
                      {"output.view=filmic"});
}

TEST_F(ProcessorBytes, DistributedRayTracing_DoesNotDependOnTheCLibrary) {
    expect_same_bytes(shot_with("0.1"), {"render.integrator=distributed", "render.size=[32, 18]"});
}

}  // namespace
}  // namespace carom::cli

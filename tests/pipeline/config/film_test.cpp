// Tests of the sections cameras, render and output.
#include <numbers>

#include <gmock/gmock.h>

#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

const std::string kBalls = "balls: {cue: {at: [0, 0]}, one: {at: [1, 0]}}\n";

CameraRig read_camera(const std::string& keys) {
    const Shot shot = load_sections(kBalls + "cameras: [{video: [0 s, 1 s], " + keys + "}]\n");
    return shot.cameras.empty() ? CameraRig{} : shot.cameras[0];
}

const std::string kStill = "scene: [0 s, 1 s], position: [0, -2, 1], target: [0, 0, 0]";

TEST(Cameras, Times_AreExact) {
    const Shot shot = load_sections(kBalls +
                                    "cameras:\n"
                                    "  - {name: a, video: [0, 1001/24000 s], scene: [3.3 s, 0.3 "
                                    "s], position: [0, -2, 1], target: "
                                    "[0, 0, 0]}\n"
                                    "  - {video: [1001/24000 s, 250 ms], scene: 1/3 s, position: "
                                    "[0, -2, 1], target: [0, 0, 0]}\n");
    ASSERT_EQ(shot.cameras.size(), 2U);
    EXPECT_EQ(shot.cameras[0].name, "a");
    EXPECT_EQ(shot.cameras[0].video_end, Rational(1001, 24000));
    EXPECT_EQ(shot.cameras[0].time_map.scene_start, Rational(33, 10));
    EXPECT_EQ(shot.cameras[0].time_map.scene_end, Rational(3, 10));
    EXPECT_EQ(shot.cameras[1].name, "camera_2");
    EXPECT_EQ(shot.cameras[1].video_end, Rational(1, 4));
    EXPECT_EQ(shot.cameras[1].time_map.scene_start, Rational(1, 3));
    EXPECT_EQ(shot.cameras[1].time_map.scene_end, Rational(1, 3));
}

TEST(Cameras, TimesWithManyDigits_AreRounded) {
    const CameraRig rig = read_camera(
        "scene: [0.333333333333333333 s, 1e-30 s], position: [0, -2, 1], "
        "target: [0, 0, 0]");
    EXPECT_NEAR(rig.time_map.scene_start.to_double(), 1.0 / 3, 1e-9);
    EXPECT_EQ(rig.time_map.scene_end, Rational(0));
}

TEST(Cameras, Paths_HaveThreeForms) {
    const CameraRig rig = read_camera(
        "scene: 0 s, position: {bezier: [[-2, -1, 1], {of: cue, at: 0.3 s, offset: [0, 0, 1]}], "
        "pace: even}, target: {follow: one, offset: [0, 0, 10 mm], smoothing: 0.1 s}");
    const auto& position = std::get<BezierPath>(rig.position);
    EXPECT_TRUE(position.even_pace);
    ASSERT_EQ(position.points.size(), 2U);
    EXPECT_EQ(position.points[0].offset, Vec3(-2, -1, 1));
    EXPECT_EQ(position.points[0].of, "");
    EXPECT_EQ(position.points[1].of, "cue");
    EXPECT_EQ(position.points[1].at, 0.3);
    const auto& target = std::get<FollowPath>(rig.target);
    EXPECT_EQ(target.object, "one");
    EXPECT_EQ(target.offset, Vec3(0, 0, 0.01));
    EXPECT_EQ(target.smoothing, 0.1);
    const auto point = std::get<BezierPath>(read_camera(kStill).position);
    ASSERT_EQ(point.points.size(), 1U);
    EXPECT_EQ(point.points[0].offset, Vec3(0, -2, 1));
}

TEST(Annotations, Keys_FillTheirFields) {
    const std::vector<Annotation> all = load_sections(R"(
balls: {cue: {at: [0, 0]}, one: {at: [0.5, 0]}}
annotations:
  - {path: {of: cue, part: ahead, length: 2 s, marks: 100 ms, number: 7}, dash: dotted, width: 0.01}
  - {aim: {of: cue, toward: [0.3, 0.2]}, colour: "#ff0000", opacity: 0.5}
  - angle: {points: [[1, 2], cue, one], value: false}
  - {zone: {radius: 10 cm, at: one}, from: 1 s, to: 2 s, fade: 0.1 s}
  - {text: "{cue.speed}", position: bottom_right, box: false, font: mono, size: 0.1}
  - {plan: {paths: false}, position: [0.25, 0.75]}
)")
                                            .annotations;
    ASSERT_EQ(all.size(), 6U);
    const auto& path = std::get<PathAnnotation>(all[0].kind);
    EXPECT_EQ(path.of, "cue");
    EXPECT_EQ(path.part, PathPart::ahead);
    EXPECT_EQ(path.length, 2);
    EXPECT_EQ(path.marks, 0.1);
    EXPECT_EQ(path.number, 7);
    EXPECT_EQ(all[0].dash, Dash::dotted);
    EXPECT_EQ(all[0].width, 0.01);
    EXPECT_EQ(std::get<AimAnnotation>(all[1].kind).toward->at, Vec3(0.3, 0.2, 0));
    EXPECT_EQ(all[1].colour, Vec3(1, 0, 0));
    EXPECT_EQ(all[1].opacity, 0.5);
    const auto& angle = std::get<AngleAnnotation>(all[2].kind);
    EXPECT_EQ(angle.points.at(0).at, Vec3(1, 2, 0));
    EXPECT_EQ(angle.points.at(2).object, "one");
    EXPECT_FALSE(angle.value);
    EXPECT_EQ(std::get<ZoneAnnotation>(all[3].kind).at.object, "one");
    EXPECT_EQ(all[3].from->seconds, 1);
    EXPECT_EQ(all[3].to->seconds, 2);
    EXPECT_EQ(all[3].fade, 0.1);
    EXPECT_EQ(all[4].box->opacity, 0);
    EXPECT_EQ(all[4].font, "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf");
    EXPECT_EQ(all[4].place->at, Vec2(1, 1));
    EXPECT_TRUE(all[4].place->is_edge);
    EXPECT_EQ(all[5].place->at, Vec2(0.25, 0.75));
    EXPECT_FALSE(all[5].place->is_edge);
}

TEST(Output, Overlay_IsAListOrAMap) {
    const OverlaySettings list =
        load_sections("output: {overlay: [frame, playback_speed]}\n").output.overlay;
    EXPECT_THAT(list.show, testing::ElementsAre(OverlayItem::frame, OverlayItem::playback_speed));
    EXPECT_EQ(list.corner, Corner::bottom_left);
    const OverlaySettings map =
        load_sections("output: {overlay: {show: [scene_time], corner: top_right, size: 0.1}}\n")
            .output.overlay;
    EXPECT_THAT(map.show, testing::ElementsAre(OverlayItem::scene_time));
    EXPECT_EQ(map.corner, Corner::top_right);
    EXPECT_EQ(map.size, 0.1);
    EXPECT_THAT(load_sections("").output.overlay.show, testing::IsEmpty());
}

TEST(Cameras, Along_IsAnIntervalOfAnObjectsPath) {
    const auto path = std::get<AlongPath>(
        read_camera("scene: 0 s, target: [0, 0, 0], position: {along: cue, from: 2 s, to: 0.5 s, "
                    "offset: [0, -1, 0.3], pace: even, easing: smooth}")
            .position);
    EXPECT_EQ(path.object, "cue");
    EXPECT_EQ(path.from, 2);
    EXPECT_EQ(path.to, 0.5);
    EXPECT_EQ(path.offset, Vec3(0, -1, 0.3));
    EXPECT_TRUE(path.even_pace);
    EXPECT_EQ(path.easing, Easing::smooth);
}

TEST(Cameras, Spline_HasPointsLikeBezier) {
    const auto path = std::get<SplinePath>(
        read_camera("scene: 0 s, target: [0, 0, 0], position: {spline: [[0, 1, 2], {of: one, at: 1 "
                    "s}], easing: [0.1, 0.2, 0.3, 0.4]}")
            .position);
    ASSERT_EQ(path.points.size(), 2U);
    EXPECT_EQ(path.points[1].of, "one");
    EXPECT_EQ(path.easing, (Easing(0.1, 0.2, 0.3, 0.4)));
}

TEST(Cameras, Orbit_IsAroundAPointOrAnObject) {
    const CameraRig rig = read_camera(
        "scene: 0 s, position: {orbit: cue, radius: 1 m, offset: [0, 0, 30 cm], smoothing: 0.2 s, "
        "look_ahead: 0.1 s, angles: [90 deg, -90 deg], turn: [0, 10 deg, 0]}, "
        "target: {orbit: {of: one, at: 1 s}, radius: [2, 1], offset: [0, 1, 0], pace: even}");
    const auto& moving = std::get<OrbitPath>(rig.position);
    const auto& follow = std::get<FollowPath>(moving.around);
    EXPECT_EQ(follow.object, "cue");
    EXPECT_EQ(follow.offset, Vec3(0, 0, 0.3));
    EXPECT_EQ(follow.smoothing, 0.2);
    EXPECT_EQ(follow.look_ahead, 0.1);
    EXPECT_EQ(moving.radii, Vec2(1, 1));
    EXPECT_DOUBLE_EQ(moving.end_angle, -std::numbers::pi / 2);
    EXPECT_LT(moving.turn.rotateVector({1, 0, 0}).z, -0.1);
    const auto& fixed = std::get<OrbitPath>(rig.target);
    EXPECT_EQ(std::get<ControlPoint>(fixed.around).of, "one");
    EXPECT_EQ(std::get<ControlPoint>(fixed.around).offset, Vec3(0, 1, 0));
    EXPECT_EQ(fixed.radii, Vec2(2, 1));
    EXPECT_TRUE(fixed.even_pace);
}

TEST(Cameras, SpeedsAndFade_AreExact) {
    const Shot shot = load_sections(
        kBalls +
        "cameras:\n"
        "  - {video: [0, 2 s], " +
        kStill +
        "}\n"
        "  - {video: [1.5 s, 4 s], fade: 500 ms, position: [0, -2, 1], target: [0, 0, 0],\n"
        "     scene: {from: 1/3 s, speeds: [[2 s, 1], [3 s, 1/8]], easing: smooth}}\n");
    ASSERT_EQ(shot.cameras.size(), 2U);
    const CameraRig& rig = shot.cameras[1];
    EXPECT_EQ(rig.fade, Rational(1, 2));
    EXPECT_EQ(rig.time_map.scene_start, Rational(1, 3));
    ASSERT_EQ(rig.time_map.speeds.size(), 2U);
    EXPECT_EQ(rig.time_map.speeds[1].video_time, Rational(3));
    EXPECT_EQ(rig.time_map.speeds[1].speed, Rational(1, 8));
    EXPECT_TRUE(rig.time_map.is_smooth);
}

TEST(Cameras, FocalLengthAndSensor_ReplaceTheFieldOfView) {
    const CameraRig rig = read_camera(
        kStill + ", focal_length: {from: 35 mm, to: 85 mm, easing: smooth}, sensor: 15.6 mm");
    ASSERT_TRUE(rig.focal_length);
    EXPECT_EQ(rig.focal_length->end, 0.085);
    EXPECT_EQ(rig.sensor_height, 0.0156);
}

TEST(Cameras, UpVector_IsOneOrTwo) {
    EXPECT_EQ(read_camera(kStill + ", up: [1, 0, 1]").up.end, Vec3(1, 0, 1));
    const CameraRig pair = read_camera(kStill + ", up: [[0, 0, 1], [0, 1, 1]], blades: [5, 8]");
    EXPECT_EQ(pair.up.start, Vec3(0, 0, 1));
    EXPECT_EQ(pair.up.end, Vec3(0, 1, 1));
    EXPECT_EQ(pair.blades.end, 8);
    EXPECT_EQ(read_camera(kStill + ", up: {from: [0, 0, 1], to: [1, 1, 1]}").up.end, Vec3(1, 1, 1));
}

TEST(Cameras, ChangingValues_HaveThreeForms) {
    EXPECT_EQ(read_camera(kStill + ", fov: 1 rad").fov.end, 1);
    const CameraRig pair = read_camera(kStill + ", fov: [1 rad, 0.5 rad]");
    EXPECT_EQ(pair.fov.start, 1);
    EXPECT_EQ(pair.fov.end, 0.5);
    EXPECT_EQ(pair.fov.easing, Easing::linear);
    const CameraRig map = read_camera(kStill + ", roll: {from: 0, to: 1 rad, easing: smooth}");
    EXPECT_EQ(map.roll.end, 1);
    EXPECT_EQ(map.roll.easing, Easing::smooth);
}

TEST(Cameras, Focus_IsADistanceTheTargetOrAnObject) {
    EXPECT_EQ(read_camera(kStill + ", focus: 1.5 m").focus.start.distance, 1.5);
    const CameraRig rig = read_camera(kStill + ", focus: [auto, one]");
    EXPECT_FALSE(rig.focus.start.distance);
    EXPECT_EQ(rig.focus.start.object, "");
    EXPECT_EQ(rig.focus.end.object, "one");
}

TEST(Cameras, Aperture_IsARadiusOrAnFNumber) {
    const CameraRig radius = read_camera(kStill + ", aperture: 8 mm, blades: 5");
    EXPECT_EQ(radius.aperture.start.value, 0.008);
    EXPECT_FALSE(radius.aperture.start.is_f_number);
    EXPECT_EQ(radius.blades.start, 5);
    const CameraRig f_number = read_camera(kStill + ", f_number: [2.8, 4]");
    EXPECT_EQ(f_number.aperture.end.value, 4);
    EXPECT_TRUE(f_number.aperture.end.is_f_number);
}

FilmTiming read_timing(const std::string& render) {
    return load_sections("render: " + render + "\n").timing;
}

TEST(Render, Fps_IsExact) {
    EXPECT_EQ(read_timing("{fps: 24000/1001}").fps, Rational(24000, 1001));
    EXPECT_EQ(read_timing("{fps: 2997/125}").fps, Rational(2997, 125));
    EXPECT_EQ(read_timing("{fps: 25 fps}").fps, Rational(25));
    EXPECT_EQ(read_timing("{}").fps, Rational(24));
}

TEST(Render, DecimalFps_IsTheFractionThatItAbbreviates) {
    const auto shot = [](const std::string& rate) {
        return "carom: 1\n" + kCamera + "render: {fps: " + rate + "}\n";
    };
    const auto fps = [&](const std::string& rate) {
        const LoadResult result = load_shot_text(shot(rate), "t.yaml");
        return result.shot ? result.shot->timing.fps : Rational(0);
    };
    const std::vector<std::pair<std::string, std::int64_t>> rates{
        {"23.976", 24}, {"23.98", 24},  {"23.976024", 24}, {"29.97", 30},  {"29.97 Hz", 30},
        {"59.94", 60},  {"47.952", 48}, {"119.88", 120},   {"14.985", 15}, {"23.97", 24}};
    for (const auto& [text, whole] : rates) {
        EXPECT_EQ(fps(text), Rational(whole * 1000, 1001)) << text;
    }
    for (const auto& [text, fraction] :
         std::vector<std::pair<std::string, Rational>>{{"23.9", {239, 10}},
                                                       {"24.98", {1249, 50}},
                                                       {"12.5", {25, 2}},
                                                       {"24.00", {24, 1}},
                                                       {"29.5", {59, 2}},
                                                       {"29.96", {749, 25}}}) {
        EXPECT_EQ(fps(text), fraction) << text;
    }
    EXPECT_EQ(
        first_problem(shot("23.976")),
        "23.976 frames per second are read as 24000/1001, the exact rate of such films; write "
        "24000/1001 to say so");
    EXPECT_EQ(first_problem(shot("24000/1001")), "");
}

TEST(Render, Shutter_IsAnAngleATimeOrAMap) {
    EXPECT_EQ(read_timing("{fps: 24000/1001, shutter: 180 deg}").shutter.exposure,
              Rational(1001, 48000));
    EXPECT_EQ(read_timing("{shutter: 172.8 deg}").shutter.exposure, Rational(1, 50));
    EXPECT_EQ(read_timing("{shutter: 0.5 turn}").shutter.exposure, Rational(1, 48));
    EXPECT_EQ(read_timing("{shutter: 1/100 s}").shutter.exposure, Rational(1, 100));
    EXPECT_EQ(read_timing("{shutter: 0}").shutter.exposure, Rational(0));
    EXPECT_NEAR(read_timing("{shutter: 3.141592653589793 rad}").shutter.exposure.to_double(),
                1.0 / 48, 1e-9);
    const Shutter shutter =
        read_timing("{shutter: {time: 5 ms, clock: scene, position: start, switch_ratio: 0}}")
            .shutter;
    EXPECT_EQ(shutter.exposure, Rational(1, 200));
    EXPECT_EQ(shutter.clock, ShutterClock::scene);
    EXPECT_EQ(shutter.position, ShutterPosition::start);
    EXPECT_EQ(shutter.switch_ratio, 0);
    EXPECT_EQ(read_timing("{shutter: {clock: scene}}").shutter.exposure, Rational(1, 48));
}

TEST(Render, Settings_FillEveryField) {
    const render::RenderSettings r =
        load_sections(
            "render: {size: [640, 360], samples: 16, max_bounces: 2, clamp: 8, filter: gaussian,\n"
            "         filter_width: 2, acceleration: embree, aovs: [depth, variance],\n"
            "         integrator: path, seed: 12}\n")
            .render;
    EXPECT_EQ(r.width, 640);
    EXPECT_EQ(r.height, 360);
    EXPECT_EQ(r.samples, 16);
    EXPECT_EQ(r.max_bounces, 2);
    EXPECT_EQ(r.clamp, 8);
    EXPECT_EQ(r.filter, render::PixelFilter::gaussian);
    EXPECT_EQ(r.filter_width, 2);
    EXPECT_EQ(r.acceleration, "embree");
    EXPECT_EQ(r.seed, 12U);
    EXPECT_THAT(r.aovs, testing::ElementsAre("depth", "variance"));
    EXPECT_EQ(load_sections("").render, render::RenderSettings{});
}

TEST(Render, Distributed_FillsEveryField) {
    const render::RenderSettings r = load_sections(
                                         "render:\n"
                                         "  integrator: distributed\n"
                                         "  distributed: {pixel_samples: 2, blur_samples: 3, "
                                         "lens_samples: 5, shadow_samples: 6,\n"
                                         "    reflection_samples: 7, refraction_samples: 8, "
                                         "recursion_limit: 1, falloff: false,\n"
                                         "    ambient_coefficient: 0.15}\n")
                                         .render;
    EXPECT_EQ(r.integrator, render::IntegratorKind::distributed);
    EXPECT_EQ(r.distributed, (render::DistributedSettings{2, 3, 5, 6, 7, 8, 1, false, 0.15}));
}

TEST(Render, Draft_SwitchesTheDistributedEffectsOff) {
    const render::DistributedSettings d =
        load("carom: 1\n" + kCamera + "render: {distributed: {shadow_samples: 16}}\n", {}, "draft")
            .render.distributed;
    EXPECT_EQ(d, (render::DistributedSettings{4, 1, 1, 1, 1, 1, 2, true, 0.12}));
}

TEST(Output, Settings_FillEveryField) {
    const OutputSettings o = load_sections(
                                 "output: {codec: ffv1, crf: 20.5, preset: slow, threads: 3, view: "
                                 "srgb, exposure: -1.5}\n")
                                 .output;
    EXPECT_EQ(o.codec, Codec::ffv1);
    EXPECT_EQ(o.crf, 20.5);
    EXPECT_EQ(o.preset, "slow");
    EXPECT_EQ(o.threads, 3);
    EXPECT_EQ(o.view, ViewTransform::srgb);
    EXPECT_EQ(o.exposure, -1.5);
}

TEST(Output, OtherKindsOfFilms_AreRead) {
    const OutputSettings o =
        load_sections(
            "output: {codec: hevc, bit_rate: 8 Mbit/s, hdr10: {peak: 600}, poster: 500 ms, "
            "title: 'The break'}\n")
            .output;
    EXPECT_EQ(o.codec, Codec::hevc);
    EXPECT_EQ(o.bit_rate, 8e6);
    ASSERT_TRUE(o.hdr10.has_value());
    EXPECT_EQ(o.hdr10->peak, 600);
    EXPECT_EQ(o.hdr10->white, 203);
    EXPECT_EQ(o.poster, 0.5);
    EXPECT_EQ(o.title, "The break");
    EXPECT_EQ(load_sections("output: {bit_rate: 500kbit/s}\n").output.bit_rate, 5e5);
    const OutputSettings sound =
        load_sections("output: {audio: opus, audio_bit_rate: 96 kbit/s}\n").output;
    EXPECT_EQ(sound.audio, AudioCodec::opus);
    EXPECT_EQ(sound.audio_bit_rate, 96e3);
    EXPECT_EQ(load_sections("output: {audio: none}\n").output.audio, AudioCodec::none);
    EXPECT_EQ(load_sections("output: {crf: 20}\n").output.audio, std::nullopt);
    EXPECT_EQ(load_sections("output: {bit_rate: 8e6}\n").output.bit_rate, 8e6);
    EXPECT_FALSE(load_sections("output: {exposure: 1}\n").output.codec.has_value());
}

TEST(Output, OddSize_IsAllowedForFfv1) {
    EXPECT_EQ(load_sections("render: {size: [641, 361]}\noutput: {codec: ffv1}\n").render.width,
              641);
}

}  // namespace
}  // namespace carom::pipeline

// Tests of keyed objects, from their YAML to the picture.
#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "sim/bake.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;

/// A strip 0.2 m wide moves from x = -0.5 m to `last_x` in front of an empty background. The film
/// has one frame, which is exposed for its whole second.
Shot strip(const std::string& last_x) {
    const LoadResult loaded = load_shot_text(
        "carom: 1\n"
        "simulation: {duration: 1 s}\n"
        "objects:\n"
        "  strip:\n"
        "    box: [0.2, 0.01, 4]\n"
        "    at: [-0.5, 0, 0]\n"
        "    motion: {easing: linear, keys: [{at: 0 s}, {at: 1 s, position: [" +
            last_x +
            ", 0, 0]}]}\n"
            "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, 0],\n"
            "           target: [0, 0, 0], fov: 20 deg, aperture: 0}]\n"
            "render: {size: [16, 16], samples: 64, fps: 1, filter: box,\n"
            "         shutter: {time: 1 s, position: start, switch_ratio: 0}}\n",
        "strip.yaml");
    EXPECT_TRUE(loaded.problems.empty());
    return loaded.shot.value();
}

render::Film picture(const Shot& shot, const sim::Bake& bake, const ScratchFolder& folder) {
    FilmJobOptions options;
    options.cache_folder = folder.path();
    return make_frame(shot, bake, 0, options, {}, {});
}

TEST(KeyedFilm, Strip_CoversEachPixelForAFractionOfTheExposure) {
    const ScratchFolder folder;
    const Shot shot = strip("0.5");
    const render::Film film =
        picture(shot, bake_or_reuse(shot, folder.path(), {}, {}).bake, folder);
    // The whole strip passes over each pixel: 0.2 m at 1 m/s.
    double sum = 0;
    for (int i = 0; i < 16 * 16; ++i) {
        const double coverage = film.rgba[4 * static_cast<std::size_t>(i) + 3];
        EXPECT_NEAR(coverage, 0.2, 0.1);
        sum += coverage;
    }
    EXPECT_NEAR(sum / 256, 0.2, 0.005);
}

TEST(KeyedFilm, ChangedKeys_AreFilmedWithoutAnotherBake) {
    const ScratchFolder folder;
    const Shot moves = strip("0.5");
    const Shot stands = strip("-0.5");
    const sim::Bake first = bake_or_reuse(moves, folder.path(), {}, {}).bake;
    EXPECT_EQ(sim::physics_hash(moves.world), sim::physics_hash(stands.world));
    auto [second, origin] = bake_or_reuse(stands, folder.path(), {}, {});
    EXPECT_EQ(origin, BakeOrigin::cached);
    ASSERT_EQ(second.timeline.tracks.size(), 1u);
    EXPECT_EQ(second.timeline.tracks[0], stands.keyed[0]);
    const render::Film film = picture(stands, second, folder);
    EXPECT_EQ(film.rgba[4 * 8 * 16 + 4 * 8 + 3], 0);  // outside the picture
    add_keyed_motions(second, moves);                 // replaces the track
    EXPECT_EQ(second.timeline, first.timeline);
}

TEST(KeyedFilm, Camera_MayFollowAKeyedObject) {
    const LoadResult loaded = load_shot_text(
        "carom: 1\n"
        "objects: {lamp: {sphere: 0.1, motion: {keys: [{at: 0 s}, {at: 1 s, position: [1, 0, "
        "0]}]}}}\n"
        "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, 0],\n"
        "           target: {follow: lamp}, focus: lamp}]\n",
        "lamp.yaml");
    EXPECT_TRUE(loaded.problems.empty());
}

}  // namespace
}  // namespace carom::pipeline

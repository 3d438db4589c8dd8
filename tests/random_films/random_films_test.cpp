// Bakes and renders random shots: there must be no failure, no NaN and no negative light.
// CAROM_RANDOM_FILMS is the number of shots, CAROM_FIRST_FILM the number of the first one.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/structures/make_structure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/scene_renderer.h"
#include "sim/bake.h"
#include "tests/random_films/random_film.h"

namespace carom::testing {
namespace {

using namespace carom::pipeline;

int setting(const char* name, int default_value) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::atoi(text) : default_value;
}

/// Whether the problem may occur in a random arrangement.
bool is_expected(const Problem& problem) {
    for (const char* reason : {"overlaps", "is higher than the ball"}) {
        if (problem.message.find(reason) != std::string::npos)
            return true;
    }
    return false;
}

/// False if the shot has an error that may occur in a random arrangement. Other errors fail the
/// test.
bool is_loaded(const LoadResult& loaded) {
    bool is_rejected = false;
    for (const Problem& problem : loaded.problems) {
        if (problem.severity != Severity::error)
            continue;
        EXPECT_TRUE(is_expected(problem)) << format(problem);
        is_rejected = true;
    }
    return !is_rejected;
}

void check(const render::Film& film) {
    ASSERT_EQ(film.rgba.size(), std::size_t{4} * 64 * 36);
    const bool is_light = std::all_of(film.rgba.begin(), film.rgba.end(), [](float value) {
        return std::isfinite(value) && value >= 0;
    });
    EXPECT_TRUE(is_light) << "a pixel is negative or not finite";
    for (const auto& plane : film.aovs)
        EXPECT_TRUE(std::all_of(plane.values.begin(), plane.values.end(), [](float value) {
            return !std::isnan(value);
        })) << plane.name;
}

/// A camera that is at its own target cannot make a picture.
bool is_camera_error(const carom::Error& error) {
    return std::string(error.what()).find("camera") != std::string::npos;
}

bool film_one(std::uint64_t number) {
    const LoadResult loaded = load_shot_text(random_film(number), "/nowhere/random.yaml");
    if (!is_loaded(loaded))
        return false;
    const Shot& shot = *loaded.shot;
    sim::Bake bake;
    bake.timeline = sim::bake(shot.world);
    add_keyed_motions(bake, shot);
    const FilmSource source(shot, bake.timeline);
    const std::int64_t frames = frame_count(shot.cameras, shot.timing);
    try {
        const FrameInputs inputs = source.inputs(static_cast<std::int64_t>(number) % frames);
        check(make_scene_renderer(shot, 1, render::named_structure)(inputs, {}, nullptr));
    } catch (const carom::Error& error) {
        EXPECT_TRUE(is_camera_error(error)) << error.what();
    }
    return true;
}

TEST(RandomFilms, BakeAndRenderWithoutFailure) {
    const int first = setting("CAROM_FIRST_FILM", 1);
    const int count = setting("CAROM_RANDOM_FILMS", 12);
    int filmed = 0;
    for (int number = first; filmed < count && number < first + 10 * count; ++number) {
        SCOPED_TRACE("CAROM_FIRST_FILM=" + std::to_string(number));
        try {
            filmed += film_one(static_cast<std::uint64_t>(number)) ? 1 : 0;
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
        if (HasFailure())
            break;
    }
    EXPECT_EQ(filmed, count);
}

}  // namespace
}  // namespace carom::testing

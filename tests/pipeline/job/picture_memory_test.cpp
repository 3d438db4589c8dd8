#include "pipeline/job/picture_memory.h"

#include <gmock/gmock.h>

namespace carom::pipeline {
namespace {

constexpr std::uint64_t kBytes = 16;  // of a picture of one pixel

render::Film picture(std::size_t number) {
    render::Film film;
    film.width = 1;
    film.height = 1;
    film.rgba.assign(4, static_cast<float>(number));
    return film;
}

FilmPlan plan_of(const std::vector<std::size_t>& picture_of, std::size_t pictures) {
    FilmPlan plan;
    plan.picture_of = picture_of;
    plan.pictures.resize(pictures);
    for (std::size_t i = 0; i < picture_of.size(); ++i) {
        plan.frames.push_back(static_cast<std::int64_t>(i));
    }
    return plan;
}

/// Plays the film, and returns which pictures have to be made, in order.
std::vector<std::size_t> made(const FilmPlan& plan, std::size_t passes, std::uint64_t limit) {
    PictureMemory memory(plan, passes, limit);
    std::vector<std::size_t> all;
    const auto get = [&](std::size_t number) {
        if (const std::optional<render::Film> kept = memory.find(number)) {
            EXPECT_EQ(kept->rgba, picture(number).rgba);
            return;
        }
        all.push_back(number);
        memory.keep(number, picture(number));
    };
    for (std::size_t i = 0; i < passes * plan.frames.size(); ++i) {
        const std::size_t frame = i % plan.frames.size();
        get(plan.picture_of[frame]);
        if (const FilmPlan::Blend* blend = plan.blend_of(frame)) {
            get(blend->picture);
        }
    }
    return all;
}

using ::testing::ElementsAre;

TEST(PictureMemory, Pictures_AreMadeOnceIfTheyFit) {
    const FilmPlan there_and_back = plan_of({0, 1, 2, 1, 0}, 3);
    EXPECT_THAT(made(there_and_back, 1, 10 * kBytes), ElementsAre(0, 1, 2));
    EXPECT_THAT(made(there_and_back, 2, 10 * kBytes), ElementsAre(0, 1, 2));
}

TEST(PictureMemory, WithoutRoom_ThoseNeededLastAreMadeAgain) {
    const FilmPlan there_and_back = plan_of({0, 1, 2, 1, 0}, 3);
    EXPECT_THAT(made(there_and_back, 1, kBytes), ElementsAre(0, 1, 2, 0));
    EXPECT_THAT(made(there_and_back, 1, 0), ElementsAre(0, 1, 2, 1, 0));
}

TEST(PictureMemory, BlendedPictures_AreKept) {
    FilmPlan fade = plan_of({0, 0, 1}, 2);
    fade.blends[0] = {1, 0.2};
    fade.blends[1] = {1, 0.4};
    EXPECT_THAT(made(fade, 1, 2 * kBytes), ElementsAre(0, 1));
}

}  // namespace
}  // namespace carom::pipeline

// A denoised pixel depends on the picture around it and on nothing else.
#include <gtest/gtest.h>

#include "render/denoise/denoise.h"
#include "render/threads/thread_arena.h"
#include "tests/render/denoise/noisy_picture.h"
#include "tests/render/every_target.h"

namespace carom::render {
namespace {

using test::NoisyPicture;

// The result looks at 19 pixels on either side: 8 for the variance, 4 for the windows, 7 for the
// comparison of errors.
constexpr int kReach = 19;

TEST(DenoiseBits, EveryInstructionSet_GivesTheSame) {
    const NoisyPicture picture = test::discs(150, 70, 1);
    const DenoisedPicture best = denoise(picture.input());
    int tried = 0;
    carom::test::for_each_instruction_set([&](const char* name) {
        const DenoisedPicture other = denoise(picture.input());
        EXPECT_EQ(best.rgb, other.rgb) << name;
        EXPECT_EQ(best.error, other.error) << name;
        ++tried;
    });
    EXPECT_GE(tried, 2);
}

TEST(DenoiseBits, AnyNumberOfThreads_GivesTheSame) {
    const NoisyPicture picture = test::discs(130, 150, 2);
    const auto denoise_with = [&](int threads) {
        ThreadArena arena(threads);
        return arena.execute([&] { return denoise(picture.input()); });
    };
    const DenoisedPicture one = denoise_with(1);
    const DenoisedPicture four = denoise_with(4);
    EXPECT_EQ(one.rgb, four.rgb);
    EXPECT_EQ(one.error, four.error);
}

// The part has other bands and tiles, and its pixels lie in other lanes.
TEST(DenoiseBits, PartOfPicture_GivesTheSameInside) {
    const NoisyPicture picture = test::discs(260, 300, 3);
    constexpr int kX = 37;
    constexpr int kY = 101;
    const NoisyPicture part = picture.part(kX, kY, 199, 180);
    const DenoisedPicture all = denoise(picture.input());
    const DenoisedPicture alone = denoise(part.input());
    for (int y = kReach; y < part.height - kReach; ++y) {
        for (int x = kReach; x < part.width - kReach; ++x) {
            const std::size_t i = part.index(x, y);
            const std::size_t j = picture.index(kX + x, kY + y);
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_EQ(alone.rgb[3 * i + c], all.rgb[3 * j + c]) << x << " " << y;
            }
            ASSERT_EQ(alone.error[i], all.error[j]) << x << " " << y;
        }
    }
}

}  // namespace
}  // namespace carom::render

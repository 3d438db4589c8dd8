#include "pipeline/job/frame_range.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string error_of(const std::string& text) {
    try {
        (void)parse_frame_range(text);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(FrameRange, Ranges_AreInclusiveSortedAndUnique) {
    EXPECT_THAT(parse_frame_range("5").frames(10), ElementsAre(5));
    EXPECT_THAT(parse_frame_range("2-4").frames(10), ElementsAre(2, 3, 4));
    EXPECT_THAT(parse_frame_range("0-7x3").frames(10), ElementsAre(0, 3, 6));
    EXPECT_THAT(parse_frame_range("6, 0-4x2 ,3-4").frames(10), ElementsAre(0, 2, 3, 4, 6));
}

TEST(FrameRange, BeyondTheFilm_IsCutOff) {
    EXPECT_THAT(parse_frame_range("3-9223372036854775807").frames(5), ElementsAre(3, 4));
    EXPECT_THAT(parse_frame_range("3-9223372036854775807x9223372036854775807").frames(5),
                ElementsAre(3));
    EXPECT_THAT(parse_frame_range("7").frames(5), IsEmpty());
}

TEST(FrameRange, Last_IsTheLargestFrameOfAllRanges) {
    EXPECT_EQ(parse_frame_range("0-47,12").last(), 47);
    EXPECT_EQ(parse_frame_range("0-10x4").last(), 8);
    EXPECT_EQ(FrameRange{}.last(), -1);
}

TEST(FrameRange, Empty_IsTheWholeFilm) {
    EXPECT_THAT(FrameRange{}.frames(3), ElementsAre(0, 1, 2));
    EXPECT_THAT(FrameRange{}.frames(0), IsEmpty());
}

TEST(FrameRange, InvalidText_IsAnErrorThatQuotesThePart) {
    const auto invalid = [](const std::string& part) {
        return "'" + part +
               "' is not a range of frames; write a frame (12), a range (0-47) or every n-th "
               "frame of a range (0-47x2)";
    };
    EXPECT_EQ(error_of(""), invalid(""));
    EXPECT_EQ(error_of("1,,2"), invalid(""));
    EXPECT_EQ(error_of("1,a"), invalid("a"));
    EXPECT_EQ(error_of("1-"), invalid("1-"));
    EXPECT_EQ(error_of("-1"), invalid("-1"));
    EXPECT_EQ(error_of("1-2x"), invalid("1-2x"));
    EXPECT_EQ(error_of("1x2"), invalid("1x2"));
    EXPECT_EQ(error_of("1-2-3"), invalid("1-2-3"));
    EXPECT_EQ(error_of("1 - 2"), invalid("1 - 2"));
    EXPECT_EQ(error_of("99999999999999999999"), invalid("99999999999999999999"));
    EXPECT_EQ(error_of("9-3"),
              "the range of frames '9-3' is reversed; write the smaller number first");
    EXPECT_EQ(error_of("0-9x0"), "the range of frames '0-9x0' has a step of 0; write at least 1");
}

TEST(FrameChunk, Chunks_CoverEveryFrameOnceAndDifferByOneAtMost) {
    for (const std::int64_t count : {1, 5, 12, 13}) {
        const std::vector<std::int64_t> all = FrameRange{}.frames(count);
        for (const std::int64_t of : {1, 2, 5, 12, 20}) {
            std::vector<std::int64_t> joined;
            for (std::int64_t number = 1; number <= of; ++number) {
                const std::vector<std::int64_t> part = FrameChunk{number, of}.part_of(all);
                EXPECT_GE(std::ssize(part), count / of);
                EXPECT_LE(std::ssize(part), (count + of - 1) / of);
                joined.insert(joined.end(), part.begin(), part.end());
            }
            EXPECT_EQ(joined, all);
        }
    }
}

TEST(FrameChunk, Texts_AreParsedOrRejected) {
    EXPECT_EQ(parse_frame_chunk("2/8").number, 2);
    EXPECT_EQ(parse_frame_chunk(" 8/8 ").of, 8);
    for (const char* wrong : {"", "2", "0/8", "9/8", "2/0", "-1/3", "1/3x", "a/b", "1/"}) {
        EXPECT_THROW((void)parse_frame_chunk(wrong), Error) << wrong;
    }
}

TEST(FramesText, ConsecutiveFrames_AreJoinedToRanges) {
    EXPECT_EQ(frames_text({}), "");
    EXPECT_EQ(frames_text({4}), "4");
    EXPECT_EQ(frames_text({0, 1, 2, 5, 7, 8}), "0-2, 5, 7-8");
}

}  // namespace
}  // namespace carom::pipeline

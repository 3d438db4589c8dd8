#include "pipeline/farm/wishes.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/farm/frame_record.h"
#include "tests/scratch_folder.h"

namespace carom::farm {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A job whose folder has a place for what workers note.
struct Folder : ScratchFolder {
    FarmJob job;
    Folder() {
        job.folder = path("");
        std::filesystem::create_directory(path("workers"));
    }
};

TEST(Wishes, Changes_AreReadAgainWithTheirRevision) {
    const Folder folder;
    EXPECT_EQ(read_wishes(folder.job), Wishes{});
    change_wishes(folder.job, [](Wishes& wishes) {
        wishes.preferred = {3, 12};
        wishes.skipped = {7};
    });
    change_wishes(folder.job, [](Wishes& wishes) {
        wishes.retried = {{5, wishes.revision}, {6, 1}};
    });
    EXPECT_EQ(read_wishes(folder.job), (Wishes{2, {3, 12}, {7}, {{5, 2}, {6, 1}}}));
    EXPECT_THAT(folder.names(), ::testing::UnorderedElementsAre("wishes.json", "workers"));
}

TEST(Wishes, ChangeThatFails_ChangesNothing) {
    const Folder folder;
    change_wishes(folder.job, [](Wishes& wishes) { wishes.skipped = {7}; });
    EXPECT_THROW(change_wishes(folder.job,
                               [](Wishes& wishes) {
                                   wishes.skipped = {8};
                                   throw Error("no");
                               }),
                 Error);
    change_wishes(folder.job, [](Wishes&) {});
    EXPECT_EQ(read_wishes(folder.job), (Wishes{2, {}, {7}, {}}));
}

TEST(Wishes, OfAnotherVersion_AreAnError) {
    const Folder folder;
    write_text(folder.path("wishes.json"), "{}");
    try {
        (void)read_wishes(folder.job);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "'" + folder.job.folder +
                                    "/wishes.json' was written by another version of carom");
    }
}

FrameRecord sample_record() {
    return {.worker = "12_3",
            .end = "failed",
            .host = "n1",
            .frame = 17,
            .layer = 1,
            .seconds = 2.5,
            .memory = 5000000000,
            .twice = 1,
            .continued = 1,
            .revision = 4,
            .ended = 1764400000.25,
            .log = "logs/frames-12_3.log",
            .log_from = 100,
            .log_to = 250,
            .problem = "a \"bad\" mesh\n"};
}

TEST(FrameRecord, Records_AreReadAgainWithEveryFieldInTheOrderOfTheirTimes) {
    const Folder folder;
    const FrameRecord record = sample_record();
    FrameRecord earlier = record;
    earlier.worker = "12_4";
    earlier.frame = 2;
    earlier.ended = 1;
    add_frame_record(folder.job, record);
    add_frame_record(folder.job, earlier);
    const std::vector<FrameRecord> read = read_frame_records(folder.job);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].worker, "12_4");
    EXPECT_EQ(read[1].worker, record.worker);
    EXPECT_EQ(read[1].end, record.end);
    EXPECT_EQ(read[1].host, record.host);
    EXPECT_EQ(read[1].frame, record.frame);
    EXPECT_EQ(read[1].layer, record.layer);
    EXPECT_EQ(read[1].seconds, record.seconds);
    EXPECT_EQ(read[1].memory, record.memory);
    EXPECT_EQ(read[1].twice, record.twice);
    EXPECT_EQ(read[1].continued, record.continued);
    EXPECT_EQ(read[1].revision, record.revision);
    EXPECT_EQ(read[1].ended, record.ended);
    EXPECT_EQ(read[1].log, record.log);
    EXPECT_EQ(read[1].log_from, record.log_from);
    EXPECT_EQ(read[1].log_to, record.log_to);
    EXPECT_EQ(read[1].problem, record.problem);
}

TEST(FrameRecord, LinesOfOthers_AreLeftOut) {
    const Folder folder;
    write_text(folder.path("workers/1.frames"),
               "{\"carom_frame\": 1, \"frame\": 4, \"end\": \"rendered\"}\n"
               "{\"carom_frame\": 2, \"frame\": 5}\n[1]\n"
               "{\"carom_frame\": 1, \"frame\": [[1]]}\n{\"carom_frame\": 1, \"fra");
    std::filesystem::create_directory(folder.path("workers/2.frames"));
    FarmJob job = folder.job;
    FrameRecord next = sample_record();
    next.worker = "1";
    add_frame_record(job, next);  // after half a line
    std::vector<std::int64_t> frames;
    for (const FrameRecord& record : read_frame_records(job)) {
        frames.push_back(record.frame);
    }
    EXPECT_THAT(frames, ElementsAre(4, 17));
    job.folder = folder.path("nowhere");
    EXPECT_THAT(read_frame_records(job), IsEmpty());
}

}  // namespace
}  // namespace carom::farm

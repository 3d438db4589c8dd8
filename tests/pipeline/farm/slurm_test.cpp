#include "pipeline/farm/slurm.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "pipeline/farm/program.h"
#include "pipeline/farm/shell_text.h"
#include "tests/pipeline/video/scratch_folder.h"

namespace carom::farm {
namespace {

using carom::testing::ScratchFolder;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

FarmJob make_job(const std::string& folder) {
    FarmJob job;
    job.folder = folder;
    job.workers = 5;
    job.tasks_at_once = 2;
    job.memory = 700;
    job.processors = 4;
    job.time = "22";
    job.film_time = "15";
    return job;
}

TEST(ShellWord, AnyText_IsOneWordOfAShell) {
    for (const std::string text : {"plain", "it's", "$HOME `id` \"x\" \\", "", "a b\n c"}) {
        const ProgramResult result =
            run_program({"/bin/sh", "-c", "printf %s " + shell_word(text)});
        EXPECT_EQ(result.output, text);
    }
}

TEST(RunProgram, MissingProgram_Is127WithItsName) {
    const ProgramResult result = run_program({"no-such-program-of-carom"});
    EXPECT_EQ(result.exit_code, 127);
    EXPECT_THAT(result.errors, HasSubstr("'no-such-program-of-carom' cannot be started"));
}

TEST(Submission, Frames_AreAnArrayWithTheJobsLimits) {
    FarmJob job = make_job("/store/farm/100%j");
    job.partition = "a b";
    const std::vector<std::string> words = submission(job, stages()[0], "", 0);
    for (const char* word :
         {"--array=0-4%2", "--cpus-per-task=4", "--mem=700M", "--time=22", "--partition=a b",
          "--output=/store/farm/100%%j/logs/frames-%A_%a.log", "/store/farm/100%j/worker.sh"}) {
        EXPECT_THAT(words, Contains(word));
    }
    EXPECT_THAT(words, Not(Contains(HasSubstr("--account"))));
}

TEST(Submission, Film_WaitsForTheFramesHoweverTheyEnd) {
    const std::vector<std::string> words = submission(make_job("/f"), stages()[1], "17", 10);
    for (const char* word :
         {"--dependency=afterany:17", "--begin=now+10seconds", "--time=15", "/f/film.sh"}) {
        EXPECT_THAT(words, Contains(word));
    }
    EXPECT_THAT(words, Not(Contains(HasSubstr("--array"))));
}

TEST(Scripts, FolderWithStrangeName_IsPassedAsItIs) {
    const ScratchFolder folder;
    const std::string strange = folder.path("it's $HOME `id` 100 %j");
    std::filesystem::create_directory(strange);
    write_scripts(make_job(strange), "/bin/echo");
    EXPECT_EQ(run_program({strange + "/worker.sh"}).output, "farm work " + strange + "\n");
    write_portable_scripts(make_job(strange));
    const ProgramResult result =
        run_program({"/usr/bin/env", "CAROM=/bin/echo", strange + "/film.sh"});
    EXPECT_EQ(result.output, "farm finish .\n");
}

}  // namespace
}  // namespace carom::farm

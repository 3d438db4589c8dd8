// What runs in shells: words, variables and the scripts of a job.
#include "pipeline/farm/scripts.h"

#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "pipeline/farm/program.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/task_environment.h"
#include "tests/scratch_folder.h"

namespace carom::farm {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

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

TEST(RunProgram, ProgramThatPrintsIntoAFile_IsThereBeforeItEnds) {
    const ScratchFolder folder;
    const int file = ::open(folder.path("log").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    const std::string script =
        "echo out; echo err >&2; grep -c . '" + folder.path("log") + "'; exit 3";
    EXPECT_EQ(run_program_into(file, {"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}), 3);
    ::close(file);
    EXPECT_EQ(carom::testing::read_text(folder.path("log")), "out\nerr\n2\n");
}

TEST(RunProgram, GivenVariables_AreAllThatItGets) {
    const std::string text(100, 'b');
    EXPECT_EQ(run_program({"/usr/bin/env"}, std::vector<std::string>{"A=" + text, "D="}).output,
              "A=" + text + "\nD=\n");
}

TEST(TaskEnvironment, OnlyVariablesThatTasksNeed_ArePassedOn) {
    for (const char* name : {"PATH", "LC_ALL", "SLURM_CONF", "CAROM_CONFIGS", "OCIO", "CAROM"}) {
        EXPECT_TRUE(is_for_tasks(name)) << name;
    }
    for (const char* name : {"AWS_SECRET_ACCESS_KEY", "GITHUB_TOKEN", "SSH_AUTH_SOCK", "PASSWORD",
                             "PATH_TO_KEYS", "MY_PATH", "", "CAROM_PASSWORD"}) {
        EXPECT_FALSE(is_for_tasks(name)) << name;
    }
    EXPECT_TRUE(is_for_tasks("SITE_LICENCE", "A SITE_LICENCE B"));
    EXPECT_FALSE(is_for_tasks("SITE", "A SITE_LICENCE B"));
    ::setenv("CAROM_TEST_SECRET", "hush", 1);
    EXPECT_THAT(task_environment(), Not(Contains(HasSubstr("hush"))));
    ::setenv("CAROM_FARM_VARIABLES", "CAROM_TEST_SECRET", 1);
    EXPECT_THAT(task_environment(), Contains("CAROM_TEST_SECRET=hush"));
    ::unsetenv("CAROM_FARM_VARIABLES");
    ::unsetenv("CAROM_TEST_SECRET");
}

FarmJob make_job(const std::string& folder) {
    FarmJob job;
    job.folder = folder;
    return job;
}

TEST(Scripts, FolderWithStrangeName_IsPassedAsItIs) {
    const ScratchFolder folder;
    for (const char* name : {"it's $HOME `id` 100 %j", "-n", "$(id)\n#SBATCH --uid=0", "\"; id"}) {
        const std::string strange = folder.path(name);
        std::filesystem::create_directory(strange);
        std::filesystem::create_symlink("/bin/echo", strange + "/carom");
        write_scripts(make_job(strange), strange + "/carom");
        EXPECT_EQ(run_program({strange + "/worker.sh"}).output, "farm work " + strange + "\n");
        write_portable_scripts(make_job(strange));
        write_text(strange + "/job.json", "");
        const ProgramResult result = run_program(
            {strange + "/film.sh"},
            std::vector<std::string>{"CAROM=" + strange + "/carom", "PATH=/usr/bin:/bin"});
        EXPECT_EQ(result.output, "farm finish .\n");
    }
}

TEST(Scripts, PortableOnes_GoToTheirOwnFolderOrFromACopyToThatOfTheEngine) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path("job");
    std::filesystem::create_directory(folder);
    write_portable_scripts(make_job(folder));
    write_text(folder + "/job.json", "");
    write_text(scratch.path("job.json"), "");  // of another job
    write_text(scratch.path("carom"), "#!/bin/sh\npwd -P\n");
    std::filesystem::permissions(scratch.path("carom"), std::filesystem::perms(0755));
    const auto folder_of = [&](const std::string& command, const std::string& variable) {
        std::vector<std::string> variables{"CAROM=" + scratch.path("carom"), "PATH=/usr/bin:/bin"};
        variables.push_back(variable);
        return run_program({"/bin/sh", "-c", command}, variables).output;
    };
    const std::string found = std::filesystem::canonical(folder).string() + "\n";
    const std::string there = "cd '" + scratch.path() + "' && ";
    EXPECT_EQ(folder_of(there + "job/worker.sh", "SLURM_SUBMIT_DIR=/"), found);
    EXPECT_EQ(folder_of(there + "job/worker.sh", "PBS_O_WORKDIR=/"), found);
    const std::string copy = scratch.path("copies/slurm_script");
    std::filesystem::create_directory(scratch.path("copies"));
    std::filesystem::copy_file(folder + "/worker.sh", copy);
    EXPECT_EQ(folder_of("cd '" + folder + "' && " + copy, "A="), found);
    EXPECT_EQ(folder_of("cd / && " + copy, "PBS_O_WORKDIR=" + folder), found);
}

}  // namespace
}  // namespace carom::farm

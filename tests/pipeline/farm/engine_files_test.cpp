// The files for engines, against what their publishers say of them.
#include "pipeline/farm/engine_files.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "pipeline/farm/program.h"
#include "tests/folders.h"
#include "tests/pipeline/config/yaml_as_json.h"
#include "tests/scratch_folder.h"

namespace carom::farm {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using nlohmann::json;
using ::testing::HasSubstr;

FarmJob make_job(const std::string& engine) {
    FarmJob job;
    job.film = "/films/It's_a {{long}} Name of more than forty letters: $HOME.mp4";
    job.engine = engine;
    job.id = "1f3a5b";
    job.workers = 12;
    job.tasks_at_once = 5;
    job.processors = 2;
    job.memory = 1500;
    job.time = 95;
    job.film_time = 15;
    return job;
}

std::string text_of(const EngineFiles& files, const std::string& name) {
    for (const EngineFile& file : files.files) {
        if (file.name == name) {
            return file.text;
        }
    }
    return "";
}

json as_json(const std::string& yaml) {
    pipeline::config::SourceSet sources;
    const int source = sources.add({"file.yaml", "", yaml});
    pipeline::config::ProblemList problems(sources);
    const auto root = pipeline::config::parse_yaml(sources, source, problems);
    return root ? carom::testing::to_json(*root) : json();
}

/// Whether the document is as the schema of that name wants it; all errors are reported.
bool is_valid(const json& document, const std::string& schema_name) {
    std::ifstream file(std::string(CAROM_SOURCE_DIR) + "/tests/pipeline/farm/schemas/" +
                       schema_name);
    const json text = json::parse(file);
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
    valijson::Validator validator;
    valijson::ValidationResults results;
    const bool valid =
        validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
    for (const auto& result : results) {
        for (const std::string& place : result.context) {
            std::printf("%s", place.c_str());
        }
        std::printf(": %s\n", result.description.c_str());
    }
    return valid;
}

TEST(EngineFiles, KubernetesJob_IsAsItsSchemaWants) {
    const std::string text = text_of(engine_files(make_job("k8s")), "job.yaml");
    json job = as_json(text);
    EXPECT_TRUE(is_valid(job, "kubernetes_job.json")) << text;
    EXPECT_EQ(job["metadata"]["name"], "carom-it-s-a---long---name-of-mor-1f3a5b");
    EXPECT_EQ(job["spec"]["completions"], 12);
    EXPECT_EQ(job["spec"]["parallelism"], 5);
    const json& container = job["spec"]["template"]["spec"]["containers"][0];
    EXPECT_EQ(container["resources"]["requests"], (json{{"cpu", "2"}, {"memory", "1500M"}}));
    job["spec"]["retries"] = 3;
    EXPECT_FALSE(is_valid(job, "kubernetes_job.json"));
}

TEST(EngineFiles, OpenJobDescription_IsAsItsSchemaWants) {
    const std::string text = text_of(engine_files(make_job("openjd")), "template.yaml");
    json job = as_json(text);
    EXPECT_TRUE(is_valid(job, "openjd_template.json")) << text;
    EXPECT_EQ(job["parameterDefinitions"][0]["dataFlow"], "NONE");  // all hosts see the folder
    const json& step = job["steps"][0];
    EXPECT_EQ(step["parameterSpace"]["taskParameterDefinitions"][0]["range"], "0-11");
    EXPECT_EQ(step["hostRequirements"]["amounts"][1]["min"], 1431);  // MiB
    job["steps"][0]["script"]["actions"]["onRun"]["cancelation"]["notifyPeriodInSeconds"] = 601;
    EXPECT_FALSE(is_valid(job, "openjd_template.json"));
}

void write_program(const ScratchFolder& folder, const std::string& name, const std::string& text) {
    write_text(folder.path(name), text);
    std::filesystem::permissions(folder.path(name), std::filesystem::perms(0755));
}

/// Runs the engine's script with these programs in the folder.
ProgramResult run_script(const FarmJob& job, const ScratchFolder& folder,
                         std::vector<std::string> variables) {
    const EngineFiles files = engine_files(job);
    for (const EngineFile& file : files.files) {
        write_program(folder, file.name, file.text);
    }
    variables.push_back("PATH=" + folder.path() + ":/usr/bin:/bin");
    return run_program({folder.path(files.start)}, variables);
}

/// Runs submit.sh with a qsub that prints its words, one a line. Returns what it prints.
std::string words_of_qsub(const FarmJob& job, const ScratchFolder& folder) {
    write_program(folder, "qsub",
                  "#!/bin/sh\nprintf '%s\\n' \"$@\" \"$CAROM\" '' >> words\necho '7[].server'\n");
    const ProgramResult result = run_script(
        job, folder, {"CAROM=/opt/a, carom", "OCIO=/o,1", "SITE=x", "CAROM_FARM_VARIABLES=SITE"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return carom::testing::read_text(folder.path("words"));
}

TEST(EngineFiles, Pbs_GetsAnArrayAndTheFilmAfterIt) {
    FarmJob job = make_job("pbs");
    job.partition = "it's; id";
    job.priority = 2000;
    job.engine_options = {"-Wgroup_list=a b"};
    const ScratchFolder folder;
    const std::string limits = "-l\nselect=1:ncpus=2:mem=1500mb\n-l\nwalltime=";
    const std::string end =
        "-j\noe\n-o\nlogs/\n-v\nCAROM,PATH,OCIO,SITE\n-q\nit's; id\n-p\n1023\n"
        "-Wgroup_list=a b\n";
    EXPECT_EQ(
        words_of_qsub(job, folder),
        "-N\nIt_s_a__-frames\n-J\n0-11%5\n" + limits + "01:35:00\n-r\ny\n" + end +
            "worker.sh\n/opt/a, carom\n\n-N\nIt_s_a__-film\n-W\ndepend=afterany:7[].server\n" +
            limits + "00:15:00\n" + end + "task.sh\n/opt/a, carom\n\n");
}

TEST(EngineFiles, PbsThatTakesNoLastTask_GetsItsArrayBack) {
    const ScratchFolder folder;
    write_program(folder, "qsub",
                  "#!/bin/sh\n[ -f first ] && exit 1\n> first\necho '7[].server'\n");
    write_program(folder, "qdel", "#!/bin/sh\necho \"$@\" > deleted\n");
    EXPECT_EQ(run_script(make_job("pbs"), folder, {}).exit_code, 1);
    EXPECT_EQ(carom::testing::read_text(folder.path("deleted")), "7[].server\n");
}

/// How many workers run.sh lets run at a time on a machine with 16 processors.
std::string parallel_jobs(std::int64_t processors, std::int64_t memory) {
    FarmJob job = make_job("parallel");
    job.processors = processors;
    job.memory = memory;
    const ScratchFolder folder;
    write_program(folder, "nproc", "#!/bin/sh\necho 16\n");
    write_program(folder, "parallel", "#!/bin/sh\ncat > tasks\necho \"$@\" > words\n");
    write_program(folder, "film.sh", "#!/bin/sh\n");
    EXPECT_EQ(run_script(job, folder, {}).exit_code, 0);
    return carom::testing::read_text(folder.path("words"));
}

TEST(EngineFiles, Parallel_HasAsManyWorkersAsThereAreProcessorsAndMemory) {
    EXPECT_EQ(parallel_jobs(4, 1), "--jobs 4 -N0 ./worker.sh\n");
    EXPECT_EQ(parallel_jobs(32, 1), "--jobs 1 -N0 ./worker.sh\n");
    EXPECT_EQ(parallel_jobs(1, 1000000000), "--jobs 1 -N0 ./worker.sh\n");
}

TEST(EngineFiles, PbsWithOneWorker_HasNoArray) {
    FarmJob job = make_job("pbs");
    job.workers = 1;
    const ScratchFolder folder;
    EXPECT_THAT(words_of_qsub(job, folder), ::testing::Not(HasSubstr("-J")));
}

TEST(EngineFiles, Container_HasThePackageBesideItsRecipe) {
    const EngineFile file = container_file();
    EXPECT_EQ(file.name, "container/Containerfile");
    EXPECT_THAT(file.text, HasSubstr("\nFROM docker.io/library/debian:12-slim\nCOPY carom_*.deb"));
}

}  // namespace
}  // namespace carom::farm

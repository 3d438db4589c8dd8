// Jobs of the farm that need no cluster.
#include <OpenImageIO/imageio.h>

#include "core/hash.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A picture of 8 x 4 pixels in one colour, which OpenImageIO reads whatever its name ends in.
std::string picture(const std::string& colour) {
    std::string text = "P6\n8 4\n255\n";
    for (int pixel = 0; pixel < 32; ++pixel) {
        text += colour;
    }
    return text;
}

class FarmExport : public EndToEnd {
  protected:
    /// A shot with an environment, a texture and a mesh. Two of its files have the same name.
    FarmExport() {
        for (const char* folder : {"shot", "shot/one", "shot/other one"}) {
            fs::create_directory(path(folder));
        }
        write_text(path("shot/one/it's $HOME.ppm"), picture("\x90\xA0\xF0"));
        write_text(path("shot/other one/it's $HOME.ppm"), picture("\xF0\x40\x20"));
        write_text(path("shot/wedge.obj"),
                   "v 0 0 0\nv .3 0 0\nv 0 .3 0\nv 0 0 .3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        write_text(path("shot/files.yaml"), tiny_shot() + R"(
materials:
  painted: {standard: {base: {image: "other one/it's $HOME.ppm"}}}
objects:
  wedge: {mesh: wedge.obj, at: [0, 0.2, 0.02], material: painted}
  tile: {box: [10 cm, 10 cm, 1 cm], at: [0.3, 0.2, 0.02], material: painted}
)");
        replace("shot/files.yaml",
                "lights:", "lights:\n  sky: {environment: \"one/it's $HOME.ppm\"}");
    }

    void replace(const std::string& name, const std::string& old, const std::string& by) const {
        std::string text = text_of(name);
        ASSERT_NE(text.find(old), std::string::npos);
        write_text(path(name), text.replace(text.find(old), old.size(), by));
    }

    [[nodiscard]] RunResult export_job(const std::vector<std::string>& options = {},
                                       const std::string& format = "parallel") const {
        std::vector<std::string> words{"farm", "export", "shot/files.yaml", "--format", format,
                                       "-o",   "made"};
        words.insert(words.end(), options.begin(), options.end());
        return run(words);
    }

    /// The contents of a store's frames, by their keys.
    [[nodiscard]] std::map<std::string, Hash128> frames_of(const std::string& store) const {
        std::map<std::string, Hash128> frames;
        for (const auto& entry : fs::recursive_directory_iterator(path(store))) {
            if (entry.path().extension() == ".exr") {
                frames[entry.path().filename()] = hash_file(entry.path());
            }
        }
        return frames;
    }

    [[nodiscard]] Hash128 hash_of(const std::string& name) const { return hash_file(path(name)); }
};

TEST_F(FarmExport, MovedFolderWithoutTheOriginals_GivesTheBytesOfRender) {
    ASSERT_EQ(run({"render", "shot/files.yaml", "-o", "film.mp4"}).exit_code, 0);
    const RunResult exported = export_job();
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    fs::remove_all(path("shot"));
    fs::rename(path("made"), path("a job's $HOME"));
    for (const char* task : {"work", "finish"}) {
        const RunResult done = run({"farm", task, "a job's $HOME"});
        ASSERT_EQ(done.exit_code, 0) << done.err;
    }
    EXPECT_EQ(frames_of("a job's $HOME/store"), frames_of("cache"));
    EXPECT_EQ(hash_of("a job's $HOME/files.mp4"), hash_of("film.mp4"));
}

TEST_F(FarmExport, DamagedFrame_IsRenderedAgainBeforeTheFilmIsWritten) {
    ASSERT_EQ(run({"render", "shot/files.yaml", "-o", "film.mp4"}).exit_code, 0);
    ASSERT_EQ(export_job().exit_code, 0);
    ASSERT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    for (const char* file : {"made/end.json", "made/files.mp4"}) {
        fs::remove(path(file));
    }
    const std::string damaged = frames_of("made/store").begin()->first;
    const std::string file = "made/store/frames/" + damaged.substr(0, 2) + "/" + damaged;
    std::string bytes = text_of(file);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_text(path(file), bytes);
    const RunResult refused = run({"farm", "finish", "made"});
    EXPECT_EQ(refused.exit_code, 75);
    EXPECT_THAT(refused.err, HasSubstr("1 frame is missing"));
    EXPECT_FALSE(exists(file));
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    EXPECT_EQ(hash_of("made/files.mp4"), hash_of("film.mp4"));
}

TEST_F(FarmExport, WorkerThatCompletesTheFilm_WritesItAndRunsTheCommandOnce) {
    ASSERT_EQ(
        export_job(
            {"--exec-after",
             R"sh(echo "$CAROM_FRAMES $(basename "$CAROM_FILM")" >> "$CAROM_JOB/after"; exit 3)sh"})
            .exit_code,
        0);
    const RunResult worker = run({"farm", "work", "made"});
    EXPECT_EQ(worker.exit_code, 0);
    EXPECT_THAT(worker.err, HasSubstr("the command after the film ended with exit code 3"));
    EXPECT_TRUE(exists("made/files.mp4"));
    fs::remove(path("made/files.mp4"));  // nobody writes it again
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    EXPECT_EQ(run({"farm", "finish", "made"}).exit_code, 0);
    EXPECT_FALSE(exists("made/files.mp4"));
    EXPECT_EQ(text_of("made/after"), "6 files.mp4\n");
    EXPECT_TRUE(fs::is_empty(path("made/store/frames/locks")));
    EXPECT_THAT(run({"farm", "status", "made"}).out, HasSubstr("complete, 6 of 6 frames"));
}

TEST_F(FarmExport, DamagedBake_IsRestoredFromItsCopyAndElseEndsTheJob) {
    ASSERT_EQ(export_job().exit_code, 0);
    const std::string bake = text_of("made/files.bake");
    const std::string damaged = bake.substr(0, bake.size() - 9);
    write_text(path("made/files.bake"), damaged);
    EXPECT_THAT(run({"farm", "status", "made"}).err,
                HasSubstr("; a worker restores damaged files from their copies; if it cannot, "
                          "submit the film again"));
    EXPECT_EQ(text_of("made/files.bake"), damaged) << "to look changes nothing";
    EXPECT_THAT(run({"farm", "finish", "made"}).err,
                HasSubstr("; it was restored from the job's copy"));
    EXPECT_EQ(text_of("made/files.bake"), bake);
    for (const char* file : {"made/files.bake", "made/spare/files.bake"}) {
        write_text(path(file), damaged);
    }
    const RunResult worker = run({"farm", "work", "made"});
    EXPECT_EQ(worker.exit_code, 2);
    EXPECT_THAT(worker.err, HasSubstr("; the job cannot go on: submit the film again"));
    EXPECT_THAT(text_of("made/end.json"), HasSubstr("\"state\":\"failed\""));
}

TEST_F(FarmExport, FileThatOneNodeDoesNotSee_EndsNoJob) {
    ASSERT_EQ(export_job().exit_code, 0);
    fs::rename(path("made/files"), path("elsewhere"));
    const RunResult worker = run({"farm", "work", "made"});
    EXPECT_EQ(worker.exit_code, 1);
    EXPECT_THAT(worker.err, HasSubstr("wedge.obj"));
    EXPECT_FALSE(exists("made/end.json"));
    fs::rename(path("elsewhere"), path("made/files"));
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
}

TEST_F(FarmExport, WorkerThatFindsAnotherOnesFilmClaim_SeesToItThatTheFilmIsThere) {
    ASSERT_EQ(export_job({"--dead-after", "1s"}).exit_code, 0);
    fs::create_directory(path("made/locks"));
    // Of a worker on another machine that has died.
    write_text(path("made/locks/film.0"),
               "carom claim 1\nhost other/12345678\nprocess 1-2-3\nbeat 00000000000000000007\n"
               "state working \n");
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    EXPECT_TRUE(exists("made/files.mp4"));
}

TEST_F(FarmExport, CommandAfterTheFilm_IsNotedWhileItRunsAndPrintsIntoItsLog) {
    ASSERT_EQ(
        export_job({"--exec-after", "cp \"$CAROM_JOB/end.json\" seen; echo one; echo two >&2"})
            .exit_code,
        0);
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    EXPECT_THAT(text_of("seen"), HasSubstr("complete"));
    EXPECT_THAT(text_of("seen"), HasSubstr("the command after the film has not ended"));
    EXPECT_THAT(text_of("made/end.json"), Not(HasSubstr("has not ended")));
    EXPECT_EQ(text_of("made/logs/exec-after.log"), "one\ntwo\n");
}

TEST_F(FarmExport, WorkerOfACompleteFilm_RendersNothingOfAPrunedStore) {
    ASSERT_EQ(export_job().exit_code, 0);
    ASSERT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    fs::remove_all(path("made/store/frames"));
    const RunResult late = run({"farm", "work", "made"});
    EXPECT_EQ(late.exit_code, 0);
    EXPECT_THAT(late.err, HasSubstr("the job is complete"));
    EXPECT_TRUE(frames_of("made/store").empty());
}

TEST_F(FarmExport, ResumeAndCancel_ChangeNothingOfWhatTheyDoNotStart) {
    ASSERT_EQ(export_job().exit_code, 0);
    write_text(path("made/end.json"), R"({"state": "failed", "message": "x", "frames": 0})");
    for (const char* command : {"resume", "cancel"}) {
        const RunResult result = run({"farm", command, "made"});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err,
                    HasSubstr("the tasks of this job are started outside carom (parallel)"));
        EXPECT_THAT(text_of("made/end.json"), HasSubstr("failed"));
    }
}

TEST_F(FarmExport, RoundsThatAddNothing_EndTheRepetition) {
    ASSERT_EQ(export_job().exit_code, 0);
    EXPECT_EQ(run({"farm", "finish", "made"}).exit_code, 75);
    EXPECT_EQ(run({"farm", "finish", "made"}).exit_code, 75);
    const RunResult last = run({"farm", "finish", "made"});
    EXPECT_EQ(last.exit_code, 1);
    EXPECT_THAT(last.err, HasSubstr("6 frames are missing: 0-5; the last 3 rounds of workers added "
                                    "no sample"));
}

TEST_F(FarmExport, OptionsThatMakeNoSense_AreRefused) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--budget", "0s"}, "--budget: '0s' is too short; the least is 1 s"},
        {{"--dead-after", "10ms"}, "--dead-after: '10ms' is too short; the least is 1 s"},
        {{"--time", "0"}, "'0' is not a time; write it as 30d, 12h, 90min, 20s or 500ms"},
        {{"--time", "30s"}, "--time: '30s' is too short; the least is 60 s"},
        {{"--mem", "0"}, "--mem: '0' is too little; the least is 1 MB"},
        {{"--", "--qos=x"}, "options after -- are for slurm and pbs, not for parallel"}};
    for (const auto& [options, message] : cases) {
        const RunResult result = export_job(options);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr("error: " + message + "\n"));
        EXPECT_FALSE(exists("made"));
    }
}

TEST_F(FarmExport, Change_IsWhatTheNextTasksGet) {
    ASSERT_EQ(export_job().exit_code, 0);
    EXPECT_THAT(run({"farm", "change", "made"}).err, HasSubstr("nothing is to be changed"));
    EXPECT_EQ(run({"farm", "change", "made", "--time", "1.5 h", "--workers", "3"}).exit_code, 0);
    EXPECT_THAT(text_of("made/job.json"), HasSubstr("\"time_minutes\":90"));
    EXPECT_THAT(text_of("made/job.json"), HasSubstr("\"workers\":3"));
    EXPECT_THAT(text_of("made/run.sh"), HasSubstr("seq 3 | parallel"));
    EXPECT_EQ(run({"farm", "work", "made"}).exit_code, 0);
}

TEST_F(FarmExport, ChangeOfAFileThatItsUserHasChanged_IsRefused) {
    ASSERT_EQ(export_job().exit_code, 0);
    replace("made/run.sh", "seq ", "seq 1");
    const std::string job = text_of("made/job.json");
    const RunResult change = run({"farm", "change", "made", "--workers", "3"});
    EXPECT_EQ(change.exit_code, 2);
    EXPECT_THAT(change.err, HasSubstr("/run.sh' is not as carom wrote it"));
    EXPECT_EQ(text_of("made/job.json"), job);
}

TEST_F(FarmExport, BudgetThatIsNotShorterThanTheTimeLimit_IsRefused) {
    const RunResult result = export_job({"--time", "10min", "--budget", "10min"}, "pbs");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("error: --budget: '10min' is not shorter than --time, which "
                                      "is 10 min\n"));
    EXPECT_EQ(export_job({"--time", "10min", "--budget", "10min"}).exit_code, 0);
}

TEST_F(FarmExport, BudgetByDefault_EndsBeforeTheTimeLimit) {
    ASSERT_EQ(export_job({"--time", "4min"}, "slurm").exit_code, 0);
    EXPECT_THAT(text_of("made/job.json"), HasSubstr("\"budget_seconds\":145,"));
}

TEST_F(FarmExport, Status_ShowsABarAndASheetWithTheColoursOfTheCameras) {
    ASSERT_EQ(export_job().exit_code, 0);
    EXPECT_THAT(run({"farm", "status", "made"}).out,
                HasSubstr("waiting, 0 of 6 frames\nrender [>"));
    ASSERT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    const RunResult status = run({"farm", "status", "made", "--sheet", "sheet.png"});
    EXPECT_THAT(status.out, HasSubstr("complete, 6 of 6 frames"));
    const auto sheet = OIIO::ImageInput::open(path("sheet.png"));
    ASSERT_TRUE(sheet);
    const OIIO::ImageSpec spec = sheet->spec();
    std::vector<std::uint8_t> rgb(spec.image_pixels() * 3);
    ASSERT_TRUE(sheet->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, rgb.data()));
    std::size_t blue = 0;  // #0072b2, of the first camera
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        blue += rgb[i] == 0x00 && rgb[i + 1] == 0x72 && rgb[i + 2] == 0xB2 ? 1 : 0;
    }
    EXPECT_GE(blue, 6U * 9U);
}

TEST_F(FarmExport, StatusAndLogs_DoNotControlTheTerminal) {
    ASSERT_EQ(export_job().exit_code, 0);
    write_text(path("made/workers/1.json"),
               R"({"name": "1", "state": "ended", "frame": -1, "problem": "bad \u001b[2J"})");
    write_text(path("made/logs/1.log"), "worse \x1b[2J\n");
    EXPECT_THAT(run({"farm", "status", "made"}).out, HasSubstr("bad ?[2J"));
    EXPECT_THAT(run({"farm", "logs", "made"}).out, HasSubstr("worse ?[2J"));
}

TEST_F(FarmExport, Files_AreCopiedUnderNamesOfTheirOwn) {
    ASSERT_EQ(export_job().exit_code, 0);
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("made/files"))) {
        names.push_back(entry.path().filename());
    }
    EXPECT_THAT(names,
                ::testing::UnorderedElementsAre("it_s__HOME.ppm", "it_s__HOME-2.ppm", "wedge.obj"));
    const RunResult info = run({"info", "made/files.bake", "--resolved"});
    EXPECT_THAT(info.out, HasSubstr("/made/files/wedge.obj"));
    EXPECT_THAT(info.out, Not(HasSubstr("/shot/")));
}

TEST_F(FarmExport, Folder_IsPrivate) {
    ASSERT_EQ(export_job().exit_code, 0);
    EXPECT_EQ(fs::status(path("made")).permissions(), fs::perms::owner_all);
}

TEST_F(FarmExport, FilmMask_IsThatOfTheFilmAlone) {
    ASSERT_EQ(export_job().exit_code, 0);
    replace("made/job.json", "\"film_mask\":-1", "\"film_mask\":63");  // 077
    ASSERT_EQ(run({"farm", "work", "made"}).exit_code, 0);
    EXPECT_EQ(fs::status(path("made/files.mp4")).permissions(), fs::perms(0600));
    EXPECT_NE(fs::status(path("made/end.json")).permissions(), fs::perms(0600));
}

TEST_F(FarmExport, ChangedCopy_IsNotTakenFromElsewhere) {
    ASSERT_EQ(export_job().exit_code, 0);
    fs::remove(path("made/files/wedge.obj"));
    fs::create_symlink(path("shot/wedge.obj"), path("made/files/wedge.obj"));
    const RunResult status = run({"farm", "status", "made"});
    EXPECT_NE(status.exit_code, 0);
    EXPECT_THAT(status.err, HasSubstr("--root allows only files inside that folder"));
}

TEST_F(FarmExport, Root_RefusesFilesOutsideAndLeavesNoFolder) {
    const RunResult result = export_job({"--root", "shot/one"});
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("is outside 'shot/one'"));
    EXPECT_FALSE(exists("made"));
    EXPECT_EQ(export_job({"--root", "shot"}).exit_code, 0);
}

}  // namespace
}  // namespace carom::testing

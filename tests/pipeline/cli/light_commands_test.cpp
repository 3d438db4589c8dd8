// End-to-end tests of the program itself and of check, bake, export, report and import.
#include <filesystem>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class LightCommands : public EndToEnd {};

TEST_F(LightCommands, Help_IsPrintedOnStdout) {
    const RunResult result = run({"--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, StartsWith("Usage: carom COMMAND [OPTIONS]\n"));
    EXPECT_EQ(result.err, "");
}

TEST_F(LightCommands, WrongUsage_IsReportedOnStderr) {
    const RunResult result = run({"chek", "tiny.yaml"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, StartsWith("carom: error: unknown command 'chek'"));
}

TEST_F(LightCommands, CheckOfAValidShot_WritesNothing) {
    const RunResult result = run({"check", "tiny.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(run({"check", "tiny.yaml", "-q"}).err, "");
    EXPECT_THAT(results(), IsEmpty());
    EXPECT_FALSE(exists("cache"));
}

TEST_F(LightCommands, CheckOfAnInvalidShot_ReportsEveryPlaceWithExitCode2) {
    std::string text = carom::testing::tiny_shot();
    text.replace(text.find("position:"), 9, "postion: ");
    text.replace(text.find("fov: 40 deg"), 11, "fov: 40 kg ");
    write_text(path("bad.yaml"), text);
    const RunResult result = run({"check", "bad.yaml"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr("bad.yaml:15:5: error: "));
    EXPECT_THAT(result.err, HasSubstr("postion"));
    EXPECT_THAT(result.err, HasSubstr("bad.yaml:17:10: error: "));
    EXPECT_THAT(result.err, HasSubstr("carom: error: 'bad.yaml' has "));
}

TEST_F(LightCommands, CheckWithJsonLog_PrintsOneObjectPerLine) {
    write_text(path("bad.yaml"), "carom: 1\nfrobnicate: 3\n");
    const RunResult result = run({"check", "bad.yaml", "--log", "json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("\"event\":\"problem\",\"severity\":\"error\""));
    EXPECT_THAT(result.err, HasSubstr("\"line\":2,\"column\":1"));
    std::istringstream lines(result.err);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("{\"time\":") && line.ends_with("}")) << line;
    }
}

TEST_F(LightCommands, MissingShot_IsExitCode2) {
    for (const std::string name : {"none.yaml", "none.bake"}) {
        for (const std::string command : {"check", "export", "bake", "report", "plan"}) {
            const RunResult result = run({command, name});
            EXPECT_EQ(result.exit_code, 2) << command << " " << name;
            EXPECT_THAT(result.err, HasSubstr(name));
        }
    }
    EXPECT_THAT(results(), IsEmpty());
}

TEST_F(LightCommands, CheckOfAnOddSize_GivesAWarningWithAHint) {
    const RunResult result = run({"check", "tiny.yaml", "--set", "render.size=[65, 36]"});
    EXPECT_EQ(result.exit_code, 0) << "image sequences support it";
    EXPECT_THAT(result.err, HasSubstr("64x36 and 66x36"));
}

TEST_F(LightCommands, Bake_PrintsItsPathAndIsTheSameEveryTime) {
    const RunResult result = run({"bake", "tiny.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "tiny.bake\n");
    EXPECT_THAT(results(), ElementsAre("tiny.bake"));
    const std::string first = text_of("tiny.bake");
    EXPECT_EQ(run({"bake", "tiny.yaml", "-o", "kept.bake"}).out, "kept.bake\n");
    EXPECT_EQ(text_of("kept.bake"), first);
    EXPECT_EQ(run({"bake", "tiny.yaml", "-o", "new.bake", "--cache", "cache2"}).exit_code, 0);
    EXPECT_EQ(text_of("new.bake"), first);
}

TEST_F(LightCommands, BakeOfABake_IsRejected) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult result = run({"bake", "tiny.bake"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("is already a bake"));
}

TEST_F(LightCommands, DamagedBake_IsExitCode2) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    std::string bytes = text_of("tiny.bake");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_text(path("tiny.bake"), bytes);
    for (const std::string command : {"check", "export", "render", "report", "plan"}) {
        const RunResult result = run({command, "tiny.bake"});
        EXPECT_EQ(result.exit_code, 2) << command;
        EXPECT_THAT(result.err, HasSubstr("tiny.bake"));
        EXPECT_EQ(result.out, "");
    }
}

TEST_F(LightCommands, ExportOfShotAndOfItsBake_AreTheSameTables) {
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    const RunResult of_shot = run({"export", "tiny.yaml", "-o", "a.csv", "--events", "b.csv"});
    EXPECT_EQ(of_shot.exit_code, 0) << of_shot.err;
    EXPECT_EQ(of_shot.out, "a.csv\nb.csv\n");
    EXPECT_EQ(run({"export", "tiny.bake", "-o", "c.csv", "--events", "d.csv"}).exit_code, 0);
    EXPECT_EQ(text_of("a.csv"), text_of("c.csv"));
    EXPECT_EQ(text_of("b.csv"), text_of("d.csv"));
    EXPECT_THAT(text_of("a.csv"),
                StartsWith("object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\ncue,0,"));
    EXPECT_THAT(text_of("b.csv"), StartsWith("time,kind,a,b,x,y,z,nx,ny,nz,normal_impulse,"));
    EXPECT_THAT(text_of("b.csv"), HasSubstr(",strike,cue,"));
    EXPECT_THAT(text_of("b.csv"), HasSubstr(",impact,"));
}

TEST_F(LightCommands, ExportAtARate_SamplesEvenly) {
    const RunResult result = run({"export", "tiny.yaml", "--rate", "10", "-o", "-"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 2 * 7);
    EXPECT_THAT(result.out, HasSubstr("\none,0.5,"));
    EXPECT_THAT(results(), IsEmpty());
}

TEST_F(LightCommands, ExportAtAnImpossibleRate_IsRejectedInOneLine) {
    for (const std::string rate : {"0", "-5", "1e7", "nan", "fast", "240Hz"}) {
        const RunResult result = run({"export", "tiny.yaml", "--rate=" + rate, "-o", "-"});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "carom: error: --rate: '" + rate +
                                  "' is not a number of samples per second; write a number above 0 "
                                  "and at most 1000000, such as 240\n"
                                  "See 'carom export --help'.\n");
    }
}

TEST_F(LightCommands, ExportOfEventsAlone_WritesNoTracks) {
    EXPECT_EQ(run({"export", "tiny.yaml", "--events", "e.csv"}).out, "e.csv\n");
    EXPECT_THAT(results(), ElementsAre("e.csv"));
}

TEST_F(LightCommands, ExportOfContactsAlone_WritesNoTracks) {
    EXPECT_EQ(run({"export", "tiny.yaml", "--contacts", "c.csv"}).out, "c.csv\n");
    EXPECT_THAT(text_of("c.csv"), StartsWith("from,to,a,b,normal_force,slip\n"));
    EXPECT_THAT(results(), ElementsAre("c.csv"));
}

TEST_F(LightCommands, ExportOfTwoTablesToOneFile_IsAnError) {
    const RunResult result =
        run({"export", "tiny.yaml", "--events", "e.csv", "--contacts", "e.csv"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("'e.csv' cannot contain both the events and the lasting "
                                      "contacts; give two files"));
    EXPECT_THAT(results(), IsEmpty());
}

TEST_F(LightCommands, ExportFormat_IsSelectedByTheFileName) {
    const RunResult glb = run({"export", "tiny.yaml", "-o", "a.glb"});
    EXPECT_EQ(glb.exit_code, 0) << glb.err;
    EXPECT_EQ(glb.out, "a.glb\n");
    EXPECT_THAT(text_of("a.glb"), StartsWith("glTF"));
    EXPECT_EQ(run({"export", "tiny.yaml", "-o", "a.usda"}).out, "a.usda\n");
    EXPECT_THAT(text_of("a.usda"), StartsWith("#usda 1.0\n"));
    EXPECT_EQ(run({"export", "tiny.yaml", "-o", "a.json", "--rate", "10"}).out, "a.json\n");
    EXPECT_THAT(text_of("a.json"), HasSubstr("\"carom_export\": 1"));
    // The bake contains the shot, so it gives the same files.
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    for (const std::string name : {"a.glb", "a.usda"}) {
        const std::string of_shot = text_of(name);
        EXPECT_EQ(run({"export", "tiny.bake", "-o", name}).exit_code, 0);
        EXPECT_EQ(text_of(name), of_shot) << name;
    }
}

/// A shot with a picture that no USD file can refer to.
constexpr const char* kPainted = R"(carom: 1
balls: {cue: {at: [0, 0]}}
objects: {wall: {rectangle: [1, 1], at: [0, 0, 1], material: paint}}
materials: {paint: {standard: {base: {image: {file: paint.hdr}}}}}
)";
const std::string kPaint =
    std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") + "\x80\x40\x20\x80";

TEST_F(LightCommands, ExportToUsda_WritesThePicturesThatItNeeds) {
    write_text(path("painted.yaml"), kPainted);
    write_text(path("paint.hdr"), kPaint);
    const RunResult result = run({"export", "painted.yaml", "-o", "out.usda"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "out.usda\n");
    EXPECT_THAT(text_of("out.usda"), HasSubstr("@./out_textures/paint_base.png@"));
    EXPECT_THAT(text_of("out_textures/paint_base.png"), StartsWith("\x89PNG"));
}

TEST_F(LightCommands, ExportToUsdaWithoutRoomForPictures_WritesNothing) {
    write_text(path("painted.yaml"), kPainted);
    write_text(path("paint.hdr"), kPaint);
    write_text(path("out_textures"), "a file");
    const RunResult result = run({"export", "painted.yaml", "-o", "out.usda"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("cannot make the folder 'out_textures'"));
    EXPECT_EQ(text_of("out.usda"), "");
    EXPECT_EQ(text_of("out_textures"), "a file");
}

TEST_F(LightCommands, ExportInAnUnknownFormat_IsRejected) {
    const RunResult result = run({"export", "tiny.yaml", "-o", "a.fbx"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err,
                HasSubstr("'a.fbx': an export can only be written as .csv, .json, .glb or .usda"));
    const RunResult rate = run({"export", "tiny.yaml", "-o", "a.glb", "--rate", "10"});
    EXPECT_EQ(rate.exit_code, 2);
    EXPECT_THAT(rate.err, HasSubstr("--rate is only for .csv and .json"));
    EXPECT_THAT(results(), IsEmpty());
}

TEST_F(LightCommands, ReportOfShotAndOfItsBake_IsTheSameText) {
    const RunResult of_shot = run({"report", "tiny.yaml"});
    EXPECT_EQ(of_shot.exit_code, 0) << of_shot.err;
    EXPECT_THAT(of_shot.out, StartsWith("0.000 s to 0.600 s, 2 objects, "));
    EXPECT_THAT(of_shot.out, HasSubstr("impact   cue - one"));
    EXPECT_THAT(of_shot.out, HasSubstr("\nafter the strike on cue"));
    EXPECT_THAT(results(), IsEmpty());
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    EXPECT_EQ(run({"report", "tiny.bake"}).out, of_shot.out);
    EXPECT_EQ(run({"report", "tiny.bake", "-o", "r.txt"}).out, "r.txt\n");
    EXPECT_EQ(text_of("r.txt"), of_shot.out);
}

TEST_F(LightCommands, ReportAsJson_IsOneObject) {
    const RunResult result = run({"report", "tiny.yaml", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, StartsWith("{\"start_time\":0,\"end_time\":0.6,"));
    EXPECT_THAT(result.out, HasSubstr("\"kind\":\"impact\",\"a\":\"cue\",\"b\":\"one\""));
    EXPECT_THAT(result.out, HasSubstr("\"a_spin_after\":["));
    const std::string strike =
        result.out.substr(result.out.find("\"strike\""), result.out.find("\"impact\""));
    EXPECT_THAT(strike.substr(0, strike.find('\n')), HasSubstr("\"normal_impulse\":0."));
    EXPECT_THAT(result.out, HasSubstr("\"energy_over_time\":[\n{\"time\":0,\"kinetic\":0,"));
    // The film shows scene time as it is, so an impact is heard when it happens.
    const std::size_t impact = result.out.find("\"impact\"");
    EXPECT_THAT(strike.substr(0, strike.find('\n')), HasSubstr("\"heard_at\":[0.1]"));
    EXPECT_THAT(result.out.substr(impact, result.out.find('\n', impact) - impact),
                ::testing::ContainsRegex("\"heard_at\":.0\\.[0-9]+.}"));
    // Twice as slow it is heard twice as late, and in a silent film never.
    const auto with = [this](const std::string& setting) {
        return run({"report", "tiny.yaml", "--json", "--set", setting}).out;
    };
    EXPECT_THAT(with("cameras[0].scene=[0 s, 0.3 s]"), HasSubstr("\"heard_at\":[0.2]"));
    EXPECT_THAT(with("cameras[0].scene=[0.3 s, 0.6 s]"), HasSubstr("\"heard_at\":[]"));
    EXPECT_THAT(with("sound=none"), Not(HasSubstr("\"heard_at\":[0")));
    ASSERT_EQ(run({"bake", "tiny.yaml"}).exit_code, 0);
    EXPECT_EQ(run({"report", "tiny.bake", "--json"}).out, result.out);
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '{'),
              std::count(result.out.begin(), result.out.end(), '}'));
}

TEST_F(LightCommands, ReportOfTheExample_Fits80ColumnsAndListsTheBreak) {
    const RunResult result = run({"report", CAROM_SOURCE_DIR "/examples/nine_ball_break.yaml"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("strike   cue"));
    EXPECT_THAT(result.out, HasSubstr("impact   one - cue"));
    EXPECT_THAT(result.out, HasSubstr("\nnine "));
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 80U) << line;
    }
}

TEST_F(LightCommands, ReportWithFilters_HasWhatIsAskedFor) {
    const auto report = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"report", "tiny.yaml", "-q"});
        return run(arguments);
    };
    const RunResult result = report({"--only", "strikes, collisions", "--object", "one", "--from",
                                     "{strike: cue}", "--min-impulse", "0.001 N s"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("impact   cue - one"));
    EXPECT_THAT(result.out, Not(HasSubstr("strike  ")));
    const RunResult json = report({"--json", "--without", "energy_over_time,motion"});
    EXPECT_THAT(json.out, HasSubstr("\"energy\":["));
    EXPECT_THAT(json.out, Not(HasSubstr("energy_over_time")));
    EXPECT_THAT(json.out, Not(HasSubstr("rolling")));
    for (const auto& [wrong, message] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--only", "pot"},
              "--only: there is no 'pot' (did you mean 'pots'?); the words are "},
             {{"--object", "oen"},
              "--object: nothing in the report is called 'oen' (did you mean 'one'?)"},
             {{"--from", "1", "--to", "0.5"}, "--to is before --from"},
             {{"--min-impulse", "2 m"}, "'2 m' is not an impulse; write 0.01 or '0.01 N s'"}}) {
        const RunResult refused = report(wrong);
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_THAT(refused.err, HasSubstr(message));
    }
}

TEST_F(LightCommands, ExportAsJson_LeavesPartsOut) {
    write_text(path("table.yaml"),
               "carom: 1\ninclude: [tables/pool_9ft.yaml, balls/pool.yaml]\n"
               "simulation: {duration: 0.1 s}\nballs: {cue: {at: [0, 0]}}\n");
    const RunResult whole = run({"export", "table.yaml", "-o", "whole.json"});
    EXPECT_EQ(whole.exit_code, 0);
    EXPECT_THAT(whole.err, HasSubstr("MB; --without meshes,energy or --only tracks,events"));
    ASSERT_EQ(run({"export", "table.yaml", "-o", "small.json", "--without", "meshes"}).exit_code,
              0);
    EXPECT_LT(text_of("small.json").size(), text_of("whole.json").size() / 20);
    EXPECT_THAT(text_of("small.json"), HasSubstr("\"kind\":\"mesh\"}"));
    ASSERT_EQ(run({"export", "table.yaml", "-o", "tracks.json", "--only", "tracks"}).exit_code, 0);
    EXPECT_THAT(text_of("tracks.json"), Not(HasSubstr("\"objects\"")));
    EXPECT_THAT(run({"export", "table.yaml", "-o", "t.json", "--only", "trakcs"}).err,
                HasSubstr("--only: there is no 'trakcs' (did you mean 'tracks'?)"));
    EXPECT_THAT(run({"export", "table.yaml", "-o", "t.glb", "--only", "tracks"}).err,
                HasSubstr("leave out parts of a .json"));
    // A film is not asked for, so that it need not be possible.
    for (const std::string command : {"report", "export", "bake"}) {
        EXPECT_THAT(run({command, "table.yaml"}).err, Not(HasSubstr("no camera"))) << command;
        EXPECT_EQ(run({command, "table.yaml", "-q"}).err, "") << command;
    }
    EXPECT_THAT(run({"check", "table.yaml"}).err, HasSubstr("the shot has no camera"));
}

TEST_F(LightCommands, MissingFolderOfTheOutput_IsReportedBeforeTheWork) {
    const RunResult result = run({"bake", "tiny.yaml", "-o", "none/tiny.bake"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("there is no folder 'none'"));
}

TEST_F(LightCommands, FullStdout_IsExitCode1) {
    // Writing to /dev/full fails. The shell redirects, since RunningProgram redirects to files.
    const std::string command = "'" + carom::testing::carom_program() + "' export '" +
                                path("tiny.yaml") + "' -o - --cache '" + path("cache") +
                                "' > /dev/full 2> '" + path("err") + "'";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_THAT(text_of("err"), HasSubstr("No space left on device"));
}

TEST_F(LightCommands, MissingRenderer_IsAnError) {
    std::filesystem::create_directory(path("bin"));
    std::filesystem::copy_file(carom::testing::carom_program(), path("bin/carom"));
    const RunResult result =
        carom::testing::RunningProgram(path("bin/carom"), {"render", "tiny.yaml"}, options())
            .wait();
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, StartsWith("carom: error: cannot start the renderer '"));
    EXPECT_THAT(result.err, HasSubstr("libexec/carom/carom-film"));
}

/// The libraries of a program: with this variable the dynamic loader lists them instead of running
/// the program (ld.so(8)).
std::string libraries_of(const std::string& program) {
    return carom::testing::RunningProgram(program, {"--help"},
                                          {{}, {{"LD_TRACE_LOADED_OBJECTS", "1"}}})
        .wait()
        .out;
}

TEST_F(LightCommands, LightProgram_LoadsNeitherImageNorVideoLibraries) {
    const std::string light = libraries_of(carom::testing::carom_program());
    ASSERT_THAT(light, HasSubstr("libc.so"));
    for (const char* library :
         {"libOpenImageIO", "libav", "libsw", "libembree", "librsvg", "libcairo"}) {
        EXPECT_THAT(light, Not(HasSubstr(library)));
    }
    const std::string heavy = libraries_of(carom::testing::carom_film_program());
    EXPECT_THAT(heavy, HasSubstr("libavcodec"));
    EXPECT_THAT(heavy, Not(HasSubstr("libOpenImageIO")));
    EXPECT_THAT(libraries_of(carom::testing::carom_draw_program()), HasSubstr("librsvg"));
}

TEST_F(LightCommands, ImportOfTheSample_WritesAValidShotThatCanBeBaked) {
    const std::string scene = CAROM_SOURCE_DIR "/tests/examples/sample_scene.txt";
    const RunResult made = run({"import", scene, "-o", "shot.yaml"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.out, "shot.yaml\n");
    EXPECT_THAT(made.err, HasSubstr("note: a force became one impulse: it acts for 0.05 s"));
    const RunResult checked = run({"check", "shot.yaml"});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_THAT(checked.err, Not(HasSubstr("warning")));
    const RunResult baked = run({"bake", "shot.yaml", "-o", "shot.bake"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    const RunResult report = run({"report", "shot.bake"});
    EXPECT_THAT(report.out, HasSubstr("Striker"));
}

TEST_F(LightCommands, ImportOfAnInvalidScene_ReportsPlacesWithExitCode2) {
    write_text(path("scene.txt"), "camera C { video_ende 1 }\n");
    const RunResult result = run({"import", "scene.txt"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr("scene.txt:1:12: error: unknown attribute 'video_ende'"));
    EXPECT_THAT(result.err, HasSubstr("carom: error: 'scene.txt' has 3 errors"));
    EXPECT_FALSE(exists("scene.yaml"));
}

TEST_F(LightCommands, ImportWithMeaningsOfFovAndBoxes_WritesOtherShots) {
    const std::string scene = CAROM_SOURCE_DIR "/tests/examples/sample_scene.txt";
    const RunResult usual = run({"import", scene, "-o", "-"});
    EXPECT_THAT(usual.out, HasSubstr("physics: fixed"));
    const RunResult formula = run({"import", scene, "--fov", "formula", "-o", "-"});
    EXPECT_THAT(formula.out, HasSubstr("fov: [73.7397953 deg, 96.7329"));
    const RunResult moving = run({"import", scene, "--boxes", "dynamic", "-o", "-"});
    EXPECT_THAT(moving.out, Not(HasSubstr("physics: fixed")));
    EXPECT_EQ(run({"import", scene, "--boxes", "some", "-o", "-"}).exit_code, 2);
}

TEST_F(LightCommands, CommandsForAnOlderScene_NameImport) {
    write_text(path("scene.txt"), "\r\n settings Main{ width 64 }\n");
    write_text(path("shot.yaml"), "carom: 1\ninclude: scene.txt\n");
    for (const char* command : {"check", "bake", "render", "frame", "plan", "info", "report"}) {
        const RunResult result = run({command, "scene.txt"});
        EXPECT_EQ(result.exit_code, 2) << command;
        EXPECT_THAT(result.err, HasSubstr("convert it with 'carom import scene.txt'")) << command;
    }
    const RunResult included = run({"check", "shot.yaml"});
    EXPECT_EQ(included.exit_code, 2);
    EXPECT_THAT(included.err, HasSubstr("convert it with 'carom import scene.txt'"));
}

TEST_F(LightCommands, ImportOverItsOwnScene_IsRejected) {
    write_text(path("scene.txt"), "camera C { }\n");
    const RunResult result = run({"import", "scene.txt", "-o", "scene.txt"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("'scene.txt' is the scene itself"));
}

}  // namespace
}  // namespace carom::cli

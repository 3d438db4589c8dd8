// Checks that filming a shot again does not simulate it again: ODE is not called at all.
#include <filesystem>

#include <gmock/gmock.h>

#include "pipeline/cli/run_program.h"
#include "tests/pipeline/cli/ode_calls.h"
#include "tests/pipeline/cli/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::cli {
namespace {

using carom::testing::ode_calls;
using carom::testing::OdeCalls;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::Not;

class NoSimulation : public ::testing::Test {
  protected:
    NoSimulation() {
        // The shot also has a falling box, which ODE has to step.
        std::string text = carom::testing::tiny_shot();
        text.insert(text.find("lights:"),
                    "objects: {tile: {box: [0.02, 0.02, 0.05], at: [0, 0.3, 0.2], physics: "
                    "{density: 700 kg/m^3}}}\n");
        write_text(path("shot.yaml"), text);
        BakeCommand bake;
        bake.input.path = path("shot.yaml");
        bake.cache.folder = path("cache");
        bake.output = path("shot.bake");
        run(bake, context_);
        before_ = ode_calls();
    }

    /// Checks that ODE was not called since the bake.
    void expect_no_call() const {
        // The bake was counted, so the counters work.
        EXPECT_GT(before_.starts, 0);
        EXPECT_GT(before_.worlds, 0);
        EXPECT_GT(before_.steps, 10);
        const OdeCalls now = ode_calls();
        EXPECT_EQ(now.starts, before_.starts);
        EXPECT_EQ(now.worlds, before_.worlds);
        EXPECT_EQ(now.steps, before_.steps);
    }

    [[nodiscard]] RenderCommand render(const std::string& input, const std::string& output) const {
        RenderCommand command;
        command.input.path = path(input);
        command.cache.folder = path("cache");
        command.output = path(output);
        return command;
    }
    [[nodiscard]] ConsoleSettings settings() {
        ConsoleSettings settings;
        settings.clock = [] { return 0.0; };
        settings.write = [this](std::string_view text) { messages_ += text; };
        return settings;
    }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

    ScratchFolder folder_;
    std::string messages_;
    Console console_{settings()};
    CommandContext context_{console_, {}};
    OdeCalls before_;
};

TEST_F(NoSimulation, BakeUnderAnotherCamera_CallsNoOde) {
    write_text(path("other.yaml"),
               "cameras: [{video: [0 s, 0.2 s], scene: [0.4 s, 0.2 s], position: [1, 1, 1], "
               "target: {follow: tile}}]\n");
    RenderCommand command = render("shot.bake", "slow.mp4");
    command.input.camera_file = path("other.yaml");
    run(command, context_);
    EXPECT_TRUE(std::filesystem::exists(path("slow.mp4")));
    expect_no_call();
}

TEST_F(NoSimulation, Retime_CallsNoOde) {
    for (const std::string input : {"shot.bake", "shot.yaml"}) {
        RetimeCommand command;
        command.render = render(input, input + ".mp4");
        command.retime.speed = "1/4";
        command.retime.from = "0.2s";
        command.retime.to = "0.3s";
        run(command, context_);
        command.retime.speed = command.retime.from = command.retime.to = "";
        command.retime.reverse = true;
        run(command, context_);
        command.retime.ramp = "0s:1,0.2s:1/8";
        run(command, context_);
    }
    expect_no_call();
}

TEST_F(NoSimulation, ChangeOfLookCameraOrOutput_ReusesTheBake) {
    for (const std::string change :
         {"cameras[0].fov=50 deg", "lights.lamp.radiance=[1, 2, 3]", "output.crf=30",
          "render.fps=5", "balls.cue.look={number: 5}"}) {
        messages_.clear();
        RenderCommand command = render("shot.yaml", "film.mp4");
        command.input.overrides = {change};
        run(command, context_);
        EXPECT_THAT(messages_, HasSubstr("the physics is unchanged: using the cached bake"))
            << change;
    }
    expect_no_call();
}

TEST_F(NoSimulation, ChangeOfPhysics_SimulatesAgainAndReportsTheChange) {
    RenderCommand command = render("shot.yaml", "film.mp4");
    command.input.overrides = {"events[0].strike.speed=4", "physics.gravity=9.8"};
    messages_.clear();
    run(command, context_);
    EXPECT_THAT(messages_, HasSubstr("simulated the shot again: its physics has changed "
                                     "(events[0].strike.speed, physics)"));
    EXPECT_GT(ode_calls().steps, before_.steps);
    const OdeCalls changed = ode_calls();
    messages_.clear();
    run(render("shot.yaml", "film.mp4"), context_);  // the original physics again
    EXPECT_THAT(messages_, HasSubstr("this physics was simulated before: using the cached bake"));
    EXPECT_EQ(ode_calls().steps, changed.steps);
    std::filesystem::remove_all(path("cache/bakes"));
    messages_.clear();
    run(render("shot.yaml", "film.mp4"), context_);
    EXPECT_THAT(messages_,
                HasSubstr("simulated the shot again: its bake was no longer in the cache"));
}

TEST_F(NoSimulation, DamagedBake_IsReportedAndSimulatedAgain) {
    for (const auto& entry : std::filesystem::directory_iterator(path("cache/bakes"))) {
        if (entry.path().extension() == ".bake") {
            std::filesystem::resize_file(entry.path(), 500);
        }
    }
    messages_.clear();
    run(render("shot.yaml", "film.mp4"), context_);
    EXPECT_THAT(messages_,
                HasSubstr("the cached bake cannot be used, so the shot is simulated again: "));
    EXPECT_THAT(messages_,
                HasSubstr("simulated the shot again: the cached bake could not be used"));
    EXPECT_THAT(messages_, Not(HasSubstr("no longer in the cache")));
}

}  // namespace
}  // namespace carom::cli

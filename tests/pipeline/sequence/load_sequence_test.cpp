// How films of several shots are read, and the whole messages of their problems.
#include "pipeline/sequence/load_sequence.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "pipeline/job/film_job.h"
#include "pipeline/sequence/sequence_text.h"
#include "sim/timeline/bake_file.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

class LoadSequence : public ::testing::Test {
  protected:
    LoadSequence() {
        write("a.yaml", shot("[640, 360]", "24"));
        write("b.yaml", shot("[640, 360]", "24"));
        write("wide.yaml", shot("[800, 300]", "24"));
        write("fast.yaml", shot("[640, 360]", "60"));
    }

    static std::string shot(const std::string& size, const std::string& fps) {
        return "carom: 1\ntable: {kind: cloth}\nballs: {cue: {at: [0, 0]}}\ncameras: [{video: [0 "
               "s, 2 "
               "s], scene: [0 s, 2 s], position: [0, -2, 1], target: [0, 0, 0]}]\nrender: {size: " +
               size + ", fps: " + fps + "}\n";
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_.path(name)) << text;
    }
    [[nodiscard]] SequenceResult load(const std::string& film,
                                      const LoadOptions& options = {}) const {
        write("film.yaml", "carom: 1\nfilm:\n" + film);
        return load_sequence(folder_.path("film.yaml"), options);
    }
    /// The first problem with its place, without the folder.
    [[nodiscard]] std::string problem(const std::string& film) const {
        const SequenceResult result = load(film);
        if (result.problems.empty()) {
            return "";
        }
        const Problem& first = result.problems[0];
        return first.place.file.substr(folder_.path("").size() + 1) + ":" +
               std::to_string(first.place.line) + ": " + first.message;
    }

    carom::testing::ScratchFolder folder_;
};

TEST_F(LoadSequence, Parts_AreFramesOfTheirShots) {
    const SequenceResult result = load(R"(  shots:
    - {title: Hello, for: 1 s, fade: 0.25 s}
    - a.yaml
    - {shot: b.yaml, set: {render.samples: 7}, from: 0.5 s, to: 1.5 s, fade: 0.5 s}
output: {codec: hevc}
)");
    ASSERT_TRUE(result.sequence) << result.problems[0].message;
    const Sequence& film = *result.sequence;
    EXPECT_EQ(film.name, "film");
    EXPECT_EQ(film.width, 640);
    EXPECT_EQ(film.output.codec, Codec::hevc);
    ASSERT_EQ(film.parts.size(), 3U);
    EXPECT_EQ(film.parts[0].frames, 24);
    EXPECT_EQ(film.parts[0].fade, 6);
    EXPECT_EQ(film.parts[1].frames, 48);
    EXPECT_EQ(film.parts[2].frames, 24);
    EXPECT_EQ(film.parts[2].fade, 12);
    const auto& last = std::get<ShotPart>(film.parts[2].content);
    EXPECT_EQ(last.first, 12);
    EXPECT_EQ(last.shot.render.samples, 7);
    EXPECT_EQ(film.frames(), 24 + 48 + 24 - 12);
}

TEST_F(LoadSequence, SizeAndRate_CanBeThoseOfTheFilm) {
    const std::string parts =
        "  size: [320, 180]\n  fps: 12\n  shots: [a.yaml, wide.yaml, fast.yaml]\n";
    const SequenceResult result = load(parts);
    ASSERT_TRUE(result.sequence);
    for (const SequencePart& part : result.sequence->parts) {
        const Shot& shot = std::get<ShotPart>(part.content).shot;
        EXPECT_EQ(shot.render.width, 320);
        EXPECT_EQ(shot.render.height, 180);
        EXPECT_EQ(shot.timing.fps, Rational(12));
        EXPECT_EQ(part.frames, 24);
    }
    // A preset scales the film's size as it does a shot's.
    const SequenceResult draft =
        load("  size: [1920, 1080]\n  fps: 12\n  shots: [a.yaml]\n", {.quality = "draft"});
    ASSERT_TRUE(draft.sequence);
    EXPECT_EQ(draft.sequence->width, 640);
}

TEST_F(LoadSequence, ShotsThatDiffer_AreErrorsWithBothValues) {
    EXPECT_EQ(problem("  shots: [a.yaml, wide.yaml]\n"),
              "film.yaml:3: 'wide.yaml' has 800x300 pixels, but 'a.yaml' has 640x360; give "
              "'size' in 'film'");
    EXPECT_EQ(problem("  shots: [a.yaml, fast.yaml]\n"),
              "film.yaml:3: 'fast.yaml' has 60 frames per second, but 'a.yaml' has 24; give 'fps' "
              "in 'film'");
    EXPECT_EQ(problem("  shots: [{title: alone}]\n"),
              "film.yaml:3: a film of title cards alone needs 'size' and 'fps'");
}

TEST_F(LoadSequence, PartsThatCannotBe_AreErrors) {
    EXPECT_EQ(problem("  shots: [{shot: a.yaml, to: 3 s}]\n"),
              "film.yaml:3: the film of 'a.yaml' ends at 2 s, before this part does");
    EXPECT_EQ(problem("  shots: [{shot: a.yaml, from: 1 s, to: 0.5 s}]\n"),
              "film.yaml:3: 'to' must be after 'from'");
    EXPECT_EQ(problem("  shots: [a.yaml, {title: t, for: 0.5 s, fade: 0.4 s}, {shot: b.yaml, fade: "
                      "0.4 s}]\n"),
              "film.yaml:3: this part has 12 frames, too few for the fades at its ends, which take "
              "20");
    EXPECT_EQ(problem("  shots: [{shot: a.yaml, title: t}]\n"),
              "film.yaml:3: 'title' contradicts 'shot' in 'shots' of 'film'; give only one of "
              "them");
    EXPECT_EQ(problem("  shots: [none.yaml]\n"), "none.yaml:0: the file does not exist");
    EXPECT_EQ(problem("  shots: [a.yaml]\noutput: {hdr10: {}}\n"),
              "film.yaml:4: a film of several shots cannot be written as 'hdr10' yet");
}

TEST_F(LoadSequence, BracesOfATitle_AreThoseOfTextsOnFrames) {
    EXPECT_EQ(problem("  shots: [a.yaml, {title: \"a {b\"}]\n"),
              "film.yaml:3: a '{' has no '}' after it; write '{{' for the brace itself");
    EXPECT_EQ(problem("  shots: [a.yaml, {title: a, subtitle: \"}\"}]\n"),
              "film.yaml:3: a '}' has no '{' before it; write '}}' for the brace itself");
    const std::string nothing =
        "film.yaml:3: a title card shows no moment of a shot, so that values in braces say nothing "
        "on it; write '{{' for the brace itself";
    EXPECT_EQ(problem("  shots: [a.yaml, {title: \"{frame}\"}]\n"), nothing);
    const SequenceResult result = load("  shots: [a.yaml, {title: a, subtitle: \"{cue.x}\"}]\n");
    EXPECT_TRUE(result.sequence);
    ASSERT_EQ(result.problems.size(), 1U);
    EXPECT_EQ(result.problems[0].severity, Severity::warning);
    EXPECT_EQ(result.problems[0].place.column, 30);
    EXPECT_EQ(problem("  shots: [a.yaml, {title: \"{{a}}\"}]\n"), "");
}

TEST_F(LoadSequence, OutputThatNoFilmCanHave_IsAnErrorAtTheSetting) {
    EXPECT_EQ(problem("  shots: [a.yaml]\noutput: {codec: h264, crf: 60}\n"),
              "film.yaml:4: crf must be from 0 (lossless) to 51 (worst)");
}

TEST_F(LoadSequence, Bakes_AreShotsWithTheirMotion) {
    const LoadResult shot = load_shot(folder_.path("a.yaml"));
    ASSERT_TRUE(shot.shot);
    sim::Bake bake = bake_shot(*shot.shot);
    sim::write_bake(bake, folder_.path("a.bake"));
    const SequenceResult result =
        load("  shots: [b.yaml, {shot: a.bake, set: {render.samples: 3}}]\n");
    ASSERT_TRUE(result.sequence) << result.problems[0].message;
    const auto& part = std::get<ShotPart>(result.sequence->parts[1].content);
    EXPECT_EQ(part.shot.render.samples, 3);
    ASSERT_TRUE(part.bake);
    EXPECT_EQ(part.bake->physics_hash, bake.physics_hash);
    EXPECT_EQ(problem("  shots: [{shot: a.bake, set: {\"balls.cue.at\": [0.1, 0]}}]\n"),
              "film.yaml:3: 'a.bake' is a bake, whose physics cannot be changed; change the shot "
              "and bake it again");
    write("bad.bake", "no bake");
    EXPECT_THAT(problem("  shots: [bad.bake]\n"), ::testing::StartsWith("film.yaml:3: "));
}

TEST_F(LoadSequence, Root_HoldsTheShotsToo) {
    std::filesystem::create_directory(folder_.path("inside"));
    write("inside/a.yaml", shot("[640, 360]", "24"));
    EXPECT_TRUE(load("  shots: [inside/a.yaml]\n", {.root = folder_.path("")}).sequence);
    const SequenceResult result = load("  shots: [a.yaml]\n", {.root = folder_.path("inside")});
    ASSERT_EQ(result.problems.size(), 1U);
    EXPECT_THAT(result.problems[0].message,
                ::testing::HasSubstr("--root allows only files inside that folder"));
    EXPECT_EQ(result.problems[0].place.line, 3);
}

TEST_F(LoadSequence, Text_ReadsBackAsTheSameFilm) {
    const SequenceResult first = load(R"(  shots:
    - {title: "Say \"it\": #1", subtitle: two, for: 0.7 s, colour: [1, 0.2158605, 0], fade: 0.25 s}
    - {shot: a.yaml, from: 1/24 s, to: 47/24 s, fade: 1/24 s}
    - b.yaml
output: {crf: 18, poster: 0.5 s, title: "A: film"}
)");
    ASSERT_TRUE(first.sequence) << first.problems[0].message;
    const auto file_of = [](std::size_t part) { return part == 1 ? "a.yaml" : "b.yaml"; };
    const std::string text = sequence_text(*first.sequence, file_of);
    write("again.yaml", text);
    const SequenceResult second = load_sequence(folder_.path("again.yaml"));
    ASSERT_TRUE(second.sequence) << text << second.problems[0].message;
    EXPECT_EQ(sequence_text(*second.sequence, file_of), text);
    EXPECT_EQ(second.sequence->starts(), first.sequence->starts());
    EXPECT_EQ(second.sequence->frames(), first.sequence->frames());
    EXPECT_EQ(std::get<ShotPart>(second.sequence->parts[1].content).first, 1);
    const auto& card = std::get<TitleCard>(second.sequence->parts[0].content);
    EXPECT_EQ(card.text, "Say \"it\": #1");
    EXPECT_EQ(card.colour, Vec3(1, 0.2158605, 0));
    EXPECT_EQ(second.sequence->output.crf, 18);
    EXPECT_EQ(second.sequence->output.title, "A: film");
}

TEST_F(LoadSequence, ProblemsOfAShot_SayWhichFilmNamesIt) {
    write("a.yaml", "carom: 1\nrendr: {}\n");
    const SequenceResult result = load("  shots: [a.yaml]\n");
    EXPECT_FALSE(result.sequence);
    ASSERT_FALSE(result.problems.empty());
    ASSERT_EQ(result.problems[0].included_by.size(), 1U);
    EXPECT_EQ(result.problems[0].included_by[0].line, 3);
}

TEST_F(LoadSequence, OtherFiles_AreNoFilmsOfShots) {
    EXPECT_FALSE(is_sequence_file(folder_.path("a.yaml")));
    EXPECT_FALSE(is_sequence_file(folder_.path("none.yaml")));
    static_cast<void>(load("  shots: [a.yaml]\n"));
    EXPECT_TRUE(is_sequence_file(folder_.path("film.yaml")));
}

}  // namespace
}  // namespace carom::pipeline

// A film of several shots in a session: its state, its problems and its files.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "sim/bake.h"
#include "sim/timeline/bake_file.h"
#include "tests/folders.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFilm = R"(carom: 1
film:
  shots:
    - {title: A lesson, for: 1 s, fade: 0.25 s}
    - {shot: parts/short.yaml, from: 0.5 s, to: 1.5 s, fade: 0.5 s}
    - parts/short.yaml
)";
const std::string kShot = R"(carom: 1
table: {kind: cloth}
balls: {cue: {at: [0, 0]}}
cameras: [{video: [0 s, 2 s], scene: [0 s, 2 s], position: [0, -2, 1], target: [0, 0, 0]}]
render: {size: [640, 360], fps: 24}
)";

class SequenceSession : public StudioSession {
  protected:
    SequenceSession() {
        std::filesystem::create_directories(path("parts"));
        write_file(path("film.yaml"), kFilm);
        write_file(path("parts/short.yaml"), kShot);
    }

    void open(const std::string& name = "film.yaml") {
        SessionOptions all = options();
        all.shot = path(name);
        start(all);
    }

    void type(const std::string& name, const std::string& text) {
        forget();
        version_ += 1;
        say(TextChange{version_, path(name), text});
    }

    /// The problems of the newest text.
    Problems problems() {
        return wait_for<Problems>(
            [this](const Problems& one) { return one.complete && one.v >= version_; });
    }

    /// The sentence of the newest text's only problem, which is at that place.
    std::string only_problem(const std::string& file, int line) {
        const Problems found = problems();
        EXPECT_EQ(found.list.size(), 1U);
        if (found.list.empty()) {
            return "";
        }
        EXPECT_EQ(found.list[0].place.file, path(file));
        EXPECT_EQ(found.list[0].place.line, line);
        return found.list[0].message;
    }

    /// Whether the cameras of a shot were sent.
    bool has_cameras() {
        const std::lock_guard lock(mutex_);
        return std::ranges::any_of(sent_, [](const Outgoing& one) {
            return one.binary && one.slot == CamerasHead::kName;
        });
    }

    void see(int question, int frame) {
        See see;
        see.q = question;
        see.frame = frame;
        see.samples = 1;
        say(see);
    }

    /// The pixels of the last picture that answers a question.
    std::string picture(int question) {
        const std::string q = "\"q\":" + std::to_string(question) + ",";
        std::unique_lock lock(mutex_);
        std::string pixels;
        const bool heard = wake_.wait_for(lock, kPatience, [&] {
            for (const Outgoing& one : sent_) {
                if (one.binary && one.slot == PictureHead::kName &&
                    one.data.find(q) != std::string::npos &&
                    one.data.find("\"complete\":true") != std::string::npos) {
                    std::uint32_t head = 0;
                    std::memcpy(&head, one.data.data() + 4, sizeof head);
                    pixels = one.data.substr(8 + head);
                }
            }
            return !pixels.empty();
        });
        return heard ? pixels : throw std::runtime_error("there is no picture");
    }

    std::int64_t version_ = 1;
};

TEST_F(SequenceSession, Opened_TellsPartsAndNoProblem) {
    open();
    const auto state = wait_for<SequenceState>();
    EXPECT_EQ(state.name, "film");
    EXPECT_EQ(state.film.frames, 84);  // 24 + 24 + 48 less the fade between two parts
    EXPECT_EQ(state.film.fps, 24);
    ASSERT_EQ(state.parts.size(), 3U);
    EXPECT_EQ(state.parts[0].kind, "title");
    EXPECT_EQ(state.parts[0].name, "A lesson");
    EXPECT_EQ(state.parts[0].fade, 6);
    EXPECT_EQ(state.parts[1].kind, "shot");
    EXPECT_EQ(state.parts[1].name, "short.yaml");
    EXPECT_EQ(state.parts[1].file, path("parts/short.yaml"));
    EXPECT_THAT(state.parts[1].path, ElementsAre("film", "shots", "1"));
    EXPECT_EQ(state.parts[1].start, 12);
    EXPECT_EQ(state.parts[1].first, 12);
    EXPECT_EQ(state.parts[1].frames, 24);
    EXPECT_EQ(state.parts[1].of_frames, 48);
    EXPECT_EQ(state.parts[2].start, 36);
    EXPECT_THAT(problems().list, IsEmpty());
}

TEST_F(SequenceSession, Opened_HasTheFilesOfItsShots) {
    open();
    const auto files =
        wait_for<Files>([](const Files& message) { return message.files.size() > 1; });
    EXPECT_EQ(files.files[0].name, "film.yaml");
    EXPECT_EQ(files.files[1].name, "parts/short.yaml");
    EXPECT_TRUE(files.files[1].writable);
}

TEST_F(SequenceSession, TextOfAShot_CountsBeforeItIsSaved) {
    open();
    static_cast<void>(
        wait_for<Files>([](const Files& message) { return message.files.size() > 1; }));
    std::string longer = kShot;
    longer.replace(longer.find("[0 s, 2 s]"), 10, "[0 s, 3 s]");
    type("parts/short.yaml", longer);
    const auto state =
        wait_for<SequenceState>([this](const SequenceState& one) { return one.v >= version_; });
    EXPECT_EQ(state.parts[2].frames, 72);
}

TEST_F(SequenceSession, MistakeInAShot_IsToldOnceAtItsPlace) {
    open();
    static_cast<void>(
        wait_for<Files>([](const Files& message) { return message.files.size() > 1; }));
    std::string wrong = kShot;
    wrong.replace(wrong.find("[640, 360]"), 10, "[640, oak]");
    type("parts/short.yaml", wrong);
    const Problems found = problems();
    ASSERT_EQ(found.list.size(), 1U);  // though two parts show it
    EXPECT_EQ(found.list[0].place.file, path("parts/short.yaml"));
    EXPECT_EQ(found.list[0].place.line, 5);
}

TEST_F(SequenceSession, MistakeInTheFilm_IsToldAtItsPlace) {
    open();
    std::string wrong = kFilm;
    wrong.replace(wrong.find("to: 1.5 s"), 9, "to: 9.5 s");
    type("film.yaml", wrong);
    EXPECT_EQ(only_problem("film.yaml", 5),
              "the film of 'parts/short.yaml' ends at 2 s, before this part does");
}

TEST_F(SequenceSession, ValueThatTheShotDoesNotHave_IsToldAtThePart) {
    open();
    std::string wrong = kFilm;
    wrong.replace(wrong.find("from: 0.5 s"), 11, "set: {render.oak: 3}");
    type("film.yaml", wrong);
    EXPECT_THAT(only_problem("film.yaml", 5), HasSubstr("oak"));
}

TEST_F(SequenceSession, ShotOutsideOfTheRoot_IsNotRead) {
    write_file(path("outside.yaml"), kShot);
    write_file(path("parts/film.yaml"), "carom: 1\nfilm: {shots: [../outside.yaml]}\n");
    SessionOptions all = options();
    all.shot = path("parts/film.yaml");
    all.root = path("parts");
    start(all);
    const Problems found = problems();
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_THAT(found.list[0].message, HasSubstr("'../outside.yaml' is outside"));
}

TEST_F(SequenceSession, ShotThatAppears_IsRead) {
    std::filesystem::rename(path("parts/short.yaml"), path("elsewhere.yaml"));
    open();
    EXPECT_THAT(problems().list[0].message, HasSubstr("'parts/short.yaml' does not exist"));
    forget();
    std::filesystem::rename(path("elsewhere.yaml"), path("parts/short.yaml"));
    EXPECT_EQ(wait_for<SequenceState>().parts.size(), 3U);
}

TEST_F(SequenceSession, Pictures_AreThoseOfTheCardAndOfTheShot) {
    open();
    static_cast<void>(problems());
    see(1, 8);
    const std::string card = picture(1);
    see(2, 30);
    const std::string shot = picture(2);
    EXPECT_EQ(card.size(), 640U * 360U * 4U);
    EXPECT_EQ(shot.size(), card.size());
    EXPECT_NE(shot, card);
    see(3, 12 + 9);  // a fade, in which the shot prevails
    see(4, 12 + 3);  // in which the card does
    EXPECT_EQ(picture(4), card);
}

TEST_F(SequenceSession, PictureThatIsAskedForAtOnce_ComesOnceTheFilmIsRead) {
    open();
    see(1, 8);
    EXPECT_EQ(picture(1).size(), 640U * 360U * 4U);
}

TEST_F(SequenceSession, PictureOfANewText_ComesByItself) {
    open();
    static_cast<void>(problems());
    see(1, 8);
    const std::string before = picture(1);
    std::string other = kFilm;
    other.replace(other.find("A lesson"), 8, "Another lesson");
    type("film.yaml", other);
    EXPECT_NE(picture(1), before);
}

TEST_F(SequenceSession, PartThatIsABake_HasPicturesButNoText) {
    pipeline::LoadResult loaded = pipeline::load_shot(path("parts/short.yaml"));
    sim::Bake bake;
    bake.timeline = sim::bake(loaded.shot->world);
    bake.physics_hash = sim::physics_hash(loaded.shot->world);
    bake.shot_text = read_file(path("parts/short.yaml"));
    sim::write_bake(bake, path("parts/short.bake"));
    std::string film = kFilm;
    film.replace(film.rfind("parts/short.yaml"), 16, "parts/short.bake");
    write_file(path("film.yaml"), film);
    open();
    const auto state = wait_for<SequenceState>();
    EXPECT_EQ(state.parts[2].file, "");
    EXPECT_EQ(state.parts[2].name, "short.bake");
    EXPECT_THAT(problems().list, IsEmpty());
    see(1, 80);
    EXPECT_EQ(picture(1).size(), 640U * 360U * 4U);
    const auto files =
        wait_for<Files>([](const Files& message) { return message.files.size() > 1; });
    EXPECT_EQ(files.files.size(), 2U);  // the film and the other shot
}

TEST_F(SequenceSession, MomentThatNeverComes_IsAnError) {
    std::string shot = kShot;
    shot.replace(shot.find("scene: [0 s,"), 12, "scene: [{potted: cue},");
    write_file(path("parts/short.yaml"), shot);
    open();
    const Problems found = problems();
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_EQ(found.list[0].place.file, path("parts/short.yaml"));
    EXPECT_EQ(found.list[0].severity, "error");
}

TEST_F(SequenceSession, NewFilmFromAnExample_HasItsShots) {
    SessionOptions all = options();
    all.shot = "";
    start(all);
    Open request;
    request.file = path("mine.yaml");
    request.from = CAROM_SOURCE_DIR "/examples/lesson.yaml";
    say(request);
    EXPECT_EQ(wait_for<SequenceState>().parts.size(), 4U);
    EXPECT_TRUE(std::filesystem::exists(path("parts/half_ball.yaml")));
    EXPECT_THAT(problems().list, IsEmpty());
}

TEST_F(SequenceSession, TextThatBecomesAShot_IsAShot) {
    open();
    static_cast<void>(wait_for<SequenceState>());
    type("film.yaml", "carom: 1\nfilm: {shots: [");  // still a film
    EXPECT_THAT(problems().list, testing::Not(IsEmpty()));
    type("film.yaml", kShot);
    EXPECT_GE(wait_for<ShotState>().v, version_);
    EXPECT_THAT(problems().list, IsEmpty());
    EXPECT_TRUE(has_cameras());
    type("film.yaml", kFilm);
    static_cast<void>(wait_for<SequenceState>());
    type("film.yaml", kShot);
    EXPECT_THAT(problems().list, IsEmpty());
    EXPECT_TRUE(has_cameras());  // again, because the page forgot them
}

}  // namespace
}  // namespace carom::studio

// The annotations in the scene at a time, as a page gets them.
#include "pipeline/studio/annotations_message.h"

#include <condition_variable>
#include <cstring>
#include <mutex>
#include <span>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/picture/colours.h"
#include "pipeline/picture/fonts.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/scene_annotations.h"
#include "tests/patience.h"
#include "tests/pipeline/picture/drawn_scene.h"

namespace carom::studio {
namespace {

using carom::testing::drawn_shot;
using carom::testing::kRadius;
using carom::testing::two_balls;
using pipeline::Annotation;

constexpr double kTime = 0.25;  // s; "cue" is at (-0.5, 0) then

/// From the front, as drawn_scene.h.
SeeAnnotations question(double time = kTime) {
    SeeAnnotations result;
    result.q = 7;
    result.v = 3;
    result.view.scene_time = time;
    result.view.position = {0, -1, kRadius};
    result.view.target = {0, 0, kRadius};
    result.view.fov = 0.3;
    return result;
}

Annotation annotation(pipeline::AnnotationKind kind) {
    Annotation result;
    result.kind = std::move(kind);
    return result;
}

pipeline::Shot shot_with(std::vector<Annotation> annotations) {
    pipeline::Shot shot = drawn_shot();
    shot.annotations = std::move(annotations);
    return shot;
}

Numbers<AnnotationsHead> message_of(const pipeline::Shot& shot, const SeeAnnotations& see) {
    pipeline::TextExtents extents;
    return annotations_message(shot, two_balls(), see, extents);
}

/// The numbers of a point of a shape.
std::array<double, 4> point(const Numbers<AnnotationsHead>& message, std::size_t shape,
                            std::int64_t index) {
    const AnnotationShape& one = message.head.shapes.at(shape);
    EXPECT_LT(index, one.points);
    const auto first = static_cast<std::size_t>(one.first + 4 * index);
    return {message.numbers.at(first), message.numbers.at(first + 1), message.numbers.at(first + 2),
            message.numbers.at(first + 3)};
}

TEST(AnnotationsMessage, Path_EndsAtTheBallAtTheTimeOfTheQuestion) {
    Annotation path = annotation(pipeline::PathAnnotation{.of = "cue", .fading = 0.5});
    path.opacity = 0.8;
    const Numbers<AnnotationsHead> message = message_of(shot_with({path}), question());
    EXPECT_EQ(message.head.q, 7);
    ASSERT_EQ(message.head.shapes.size(), 1U);
    const AnnotationShape& line = message.head.shapes.front();
    EXPECT_EQ(line.kind, "line");
    EXPECT_EQ(line.annotation, 0);
    EXPECT_EQ(line.width, 0.0075);
    EXPECT_EQ(line.opacity, 0.8);
    const Vec3 colour = pipeline::path_colour(0);
    EXPECT_EQ(line.colour, (Triple{colour.x, colour.y, colour.z}));
    EXPECT_FALSE(line.is_closed || line.has_head || line.label);
    EXPECT_THAT(point(message, 0, 0),
                ::testing::ElementsAre(-1, 0, kRadius, ::testing::DoubleNear(0.5, 1e-12)));
    EXPECT_THAT(point(message, 0, line.points - 1),
                ::testing::ElementsAre(::testing::DoubleNear(-0.5, 1e-12), 0, kRadius, 1));
}

TEST(AnnotationsMessage, OnlyWhatIsShownAtThatTime_HasShapes) {
    Annotation late = annotation(pipeline::PathAnnotation{"cue"});
    late.from = pipeline::AnnotationTime{0.3};
    late.fade = 0.2;
    const Annotation title = annotation(pipeline::TitleAnnotation{"title"});
    const pipeline::Shot shot =
        shot_with({title, late, annotation(pipeline::PathAnnotation{"cue"})});
    const Numbers<AnnotationsHead> before = message_of(shot, question(0.25));
    ASSERT_FALSE(before.head.shapes.empty());
    for (const AnnotationShape& shape : before.head.shapes) {
        EXPECT_EQ(shape.annotation, 2);
    }
    // The colours and numbers of paths count those that are not shown.
    EXPECT_EQ(before.head.shapes.back().label->text, "2");
    const Numbers<AnnotationsHead> fading = message_of(shot, question(0.4));
    EXPECT_EQ(fading.head.shapes.front().annotation, 1);
    EXPECT_NEAR(fading.head.shapes.front().opacity, 0.5, 1e-12);
}

TEST(AnnotationsMessage, LitAnnotation_HasItsTextsOnly) {
    Annotation path = annotation(
        pipeline::PathAnnotation{.of = "cue", .part = pipeline::PathPart::whole, .number = 4});
    path.lit = 0.005;
    const Numbers<AnnotationsHead> message = message_of(shot_with({path}), question());
    ASSERT_EQ(message.head.shapes.size(), 1U);
    EXPECT_EQ(message.head.shapes.front().label->text, "4");
}

TEST(AnnotationsMessage, DottedLine_IsDots) {
    Annotation path = annotation(pipeline::PathAnnotation{"cue"});
    path.dash = pipeline::Dash::dotted;
    path.width = 0.004;
    const Numbers<AnnotationsHead> message = message_of(shot_with({path}), question());
    ASSERT_GT(message.head.shapes.size(), 5U);
    for (std::size_t i = 0; i + 1 < message.head.shapes.size(); ++i) {
        EXPECT_EQ(message.head.shapes[i].points, 1);
        EXPECT_NEAR(message.head.shapes[i].width, 0.006, 1e-12);
        EXPECT_NEAR(point(message, i + 1, 0)[0] - point(message, i, 0)[0], 0.0075, 1e-9);
    }
}

TEST(AnnotationsMessage, ArrowAreaAndText_HaveTheirLooks) {
    pipeline::ZoneAnnotation zone;
    zone.polygon = {{0, 0}, {0.3, 0}, {0.3, 0.2}};
    Annotation label = annotation(pipeline::LabelAnnotation{"cue", "{cue.speed:.1f} m/s\n{frame}"});
    label.font = std::string(pipeline::named_fonts()[2].file);
    label.size = 0.05;
    SeeAnnotations see = question();
    see.frame = 12;
    const Numbers<AnnotationsHead> message = message_of(
        shot_with({annotation(zone), annotation(pipeline::VelocityAnnotation{"cue"}), label}), see);
    ASSERT_EQ(message.head.shapes.size(), 4U);
    const auto& shapes = message.head.shapes;
    EXPECT_EQ(shapes[0].kind, "area");
    EXPECT_NEAR(shapes[0].opacity, 0.3, 1e-12);
    EXPECT_THAT(point(message, 0, 2), ::testing::ElementsAre(0.3, 0.2, 0.0005, 1));
    EXPECT_TRUE(shapes[1].is_closed);
    EXPECT_TRUE(shapes[2].has_head);
    EXPECT_EQ(shapes[2].annotation, 1);
    EXPECT_EQ(shapes[3].kind, "text");
    ASSERT_TRUE(shapes[3].label);
    const AnnotationLabel& text = *shapes[3].label;
    EXPECT_EQ(text.text, "2.0 m/s\n12");
    EXPECT_EQ(text.font, "serif");
    EXPECT_EQ(text.line_height, 0.05);
    EXPECT_TRUE(text.is_above);
    EXPECT_EQ(text.nearer, kRadius);
    EXPECT_EQ(text.box_opacity, 0);
    // Letters are 0.6 em wide on average, an em is 0.8 lines, and lines of letters 1.16 em high.
    EXPECT_NEAR(text.letters[0], 7 * 0.6 * 0.8 * 0.05, 0.04);
    EXPECT_NEAR(text.letters[1], 2 * 1.16 * 0.8 * 0.05, 0.002);
    EXPECT_NEAR(text.margin[0], 0.13 * 0.05, 1e-12);
}

TEST(AnnotationsMessage, WholeMessage_IsTheSameAfterARoundTrip) {
    pipeline::ZoneAnnotation zone;
    zone.polygon = {{0, 0}, {0.25, 0}, {0.25, 0.5}};
    Annotation one = annotation(zone);
    one.colour = Vec3(0.25, 0.5, 1);
    one.width = 0.0078125;
    Numbers<AnnotationsHead> message = message_of(shot_with({one}), question());
    message.head.v = 3;
    const auto payload = std::as_bytes(std::span(message.numbers));
    const std::string bytes = pack(message.head, payload);
    EXPECT_EQ(bytes.substr(8, bytes.size() - 8 - payload.size()),
              R"({"t":"annotations","q":7,"v":3,"shapes":[)"
              R"({"annotation":0,"kind":"area","first":0,"points":3,)"
              R"("colour":[0.25,0.5,1],"opacity":0.3,"width":0,"is_closed":false,)"
              R"("has_round_ends":true,"has_head":false},)"
              R"({"annotation":0,"kind":"line","first":12,"points":3,)"
              R"("colour":[0.25,0.5,1],"opacity":1,"width":0.0078125,"is_closed":true,)"
              R"("has_round_ends":true,"has_head":false}]}  )");
    EXPECT_THAT(message.numbers, ::testing::ElementsAre(
                                     0, 0, 0.0005, 1, 0.25, 0, 0.0005, 1, 0.25, 0.5, 0.0005, 1,  //
                                     0, 0, 0.0005, 1, 0.25, 0, 0.0005, 1, 0.25, 0.5, 0.0005, 1));
    const Unpacked unpacked = unpack(std::as_bytes(std::span(bytes)));
    EXPECT_EQ(pack(unpacked.head, unpacked.payload), bytes);
}

TEST(AnnotationsMessage, ViewThatIsNone_IsAnError) {
    SeeAnnotations see = question();
    see.view.target = see.view.position;
    EXPECT_THROW(static_cast<void>(message_of(shot_with({}), see)), Error);
    see = question();
    see.view.fov = 0;
    EXPECT_THROW(static_cast<void>(message_of(shot_with({}), see)), Error);
}

/// The worker and what it answered.
class SceneAnnotationsWork : public ::testing::Test {
  protected:
    SceneAnnotationsWork()
        : annotations_(
              [this](PageId page, const AnnotationsHead& head, const std::vector<double>&) {
                  tell("page " + std::to_string(page) + ": " + std::to_string(head.q) + " of " +
                       std::to_string(head.v));
              },
              [this](PageId page, const ServerMessage& message) {
                  const auto& failed = std::get<Failed>(message);
                  tell("page " + std::to_string(page) + ": " + failed.what + " of " +
                       std::to_string(failed.v) + ": " + failed.message);
              }) {}

    void show(std::int64_t v) {
        annotations_.set_shot(shot_, std::make_shared<const sim::Timeline>(two_balls()), v);
    }

    void ask(PageId page, std::int64_t q, std::int64_t v) {
        SeeAnnotations see = question();
        see.q = q;
        see.v = v;
        annotations_.ask(page, see);
    }

    std::vector<std::string> wait_for(std::size_t count) {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, kPatience, [&] { return told_.size() >= count; });
        return told_;
    }

    void tell(std::string what) {
        const std::lock_guard lock(mutex_);
        told_.push_back(std::move(what));
        wake_.notify_all();
    }

    std::shared_ptr<const pipeline::Shot> shot_ = std::make_shared<const pipeline::Shot>(
        shot_with({annotation(pipeline::PathAnnotation{"cue"})}));
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::string> told_;
    SceneAnnotations annotations_;
};

TEST_F(SceneAnnotationsWork, Questions_WaitForTheirVersionAndTheNewestCounts) {
    ask(1, 5, 2);
    ask(1, 6, 2);
    ask(2, 1, 1);
    show(1);
    EXPECT_THAT(wait_for(1), ::testing::ElementsAre("page 2: 1 of 1"));
    show(3);
    EXPECT_THAT(wait_for(2), ::testing::ElementsAre("page 2: 1 of 1", "page 1: 6 of 3"));
}

TEST_F(SceneAnnotationsWork, QuestionsOfAClosedShotOrPage_AreForgotten) {
    ask(1, 1, 4);
    annotations_.set_shot(nullptr, nullptr, 0);
    ask(2, 1, 4);
    annotations_.cancel(2);
    show(4);
    ask(3, 1, 4);
    EXPECT_THAT(wait_for(1), ::testing::ElementsAre("page 3: 1 of 4"));
}

TEST_F(SceneAnnotationsWork, QuestionThatCannotBeAnswered_IsToldAndTheNextOneIsAnswered) {
    show(4);
    SeeAnnotations see = question();
    see.view.fov = 0;
    annotations_.ask(1, see);
    ASSERT_EQ(wait_for(1).size(), 1U);
    ask(1, 8, 4);
    EXPECT_THAT(wait_for(2), ::testing::ElementsAre(
                                 "page 1: see_annotations of 4: camera: the vertical field of "
                                 "view must lie between 0 and 180 degrees",
                                 "page 1: 8 of 4"));
}

}  // namespace
}  // namespace carom::studio

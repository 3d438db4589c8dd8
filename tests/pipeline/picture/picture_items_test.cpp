#include "pipeline/picture/picture_items.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/film/image_file.h"
#include "tests/pipeline/picture/drawn_scene.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::drawn_shot;
using carom::testing::ScratchFolder;
using carom::testing::two_balls;

constexpr int kWide = 320;
constexpr int kHigh = 200;

/// The rectangle of pixels that are not transparent.
struct Extent {
    int left = 9999, top = 9999, right = -1, bottom = -1;
    [[nodiscard]] int width() const { return right - left + 1; }
    [[nodiscard]] int height() const { return bottom - top + 1; }
};

struct Items {
    Shot shot = drawn_shot();
    sim::Timeline timeline = two_balls();
    Fonts fonts;
    Canvas canvas{kWide, kHigh};

    Extent draw(const Annotation& annotation, double scene_time = 0.25) {
        PictureItems items(shot, timeline, fonts);
        items.draw(annotation, {7, 1, scene_time, 1}, canvas);
        Extent extent;
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                if (pixel(x, y) >> 24 != 0) {
                    extent.left = std::min(extent.left, x);
                    extent.right = std::max(extent.right, x);
                    extent.top = std::min(extent.top, y);
                    extent.bottom = std::max(extent.bottom, y);
                }
            }
        }
        return extent;
    }
    [[nodiscard]] std::uint32_t pixel(int x, int y) const {
        return canvas.pixels()[static_cast<std::size_t>(y * kWide + x)];
    }
};

TEST(PictureItems, Text_HasABoxAtItsPlace) {
    Annotation text;
    text.kind = TextAnnotation{"{cue.speed:.1f} m/s"};
    text.size = 0.1;
    Items items;
    const Extent box = items.draw(text);
    EXPECT_EQ(box.left, 7);  // the margin of 0.035 heights
    EXPECT_EQ(box.top, 7);
    EXPECT_NEAR(box.height(), 20 * (0.8 * 1.164 + 2 * 0.18), 2);  // DejaVu's line is 1.164 em high
    // Letters are white, the box is dark and lets light through.
    int white = 0;
    for (int x = box.left; x <= box.right; ++x) {
        white += items.pixel(x, (box.top + box.bottom) / 2) == 0xffffffff ? 1 : 0;
    }
    EXPECT_GT(white, 10);
    EXPECT_EQ(items.pixel(box.left + 3, (box.top + box.bottom) / 2) >> 24, 153U);  // 0.6
}

TEST(PictureItems, TextWithoutBox_HasADarkEdge) {
    Annotation text;
    text.kind = TextAnnotation{"I"};
    text.size = 0.5;
    text.box = TextBox{Vec3(0), 0};
    text.place = PicturePlace{{0.5, 0.5}, false};
    Items items;
    const Extent box = items.draw(text);
    EXPECT_NEAR(0.5 * (box.left + box.right + 1), kWide / 2.0, 1);
    const int middle = (box.top + box.bottom) / 2;
    EXPECT_EQ(items.pixel((box.left + box.right) / 2, middle), 0xffffffff);
    const std::uint32_t edge = items.pixel(box.left + 5, middle);
    EXPECT_GT(edge >> 24, 200U);
    EXPECT_LT(edge & 0xff, 40U);
}

TEST(PictureItems, Values_ChangeWithTheFrame) {
    Annotation text;
    text.kind = TextAnnotation{"{cue.x:.2f}"};
    Items first, same, other;
    first.draw(text, 0.25);
    same.draw(text, 0.25);
    other.draw(text, 0.3);
    EXPECT_TRUE(std::ranges::equal(std::as_const(first.canvas).pixels(),
                                   std::as_const(same.canvas).pixels()));
    EXPECT_FALSE(std::ranges::equal(std::as_const(first.canvas).pixels(),
                                    std::as_const(other.canvas).pixels()));
}

TEST(PictureItems, Title_IsCentredWithItsSubtitleBelow) {
    Annotation title;
    title.kind = TitleAnnotation{"The 30-degree rule", ""};
    Items alone;
    const Extent one = alone.draw(title);
    EXPECT_NEAR(0.5 * (one.left + one.right), kWide / 2.0, 2);
    title.kind = TitleAnnotation{"The 30-degree rule", "a half-ball hit"};
    Items both;
    EXPECT_GT(both.draw(title).height(), one.height() + 5);
}

/// The text in a picture of that size: whether it is inside, and its scale.
struct Fitted {
    AnnotationBox box;
    double scale = 1;
    bool is_inside = false;
};
Fitted fitted(const Annotation& annotation, const Vec2& picture) {
    Items items;
    PictureItems drawn(items.shot, items.timeline, items.fonts);
    const FrameMoment moment{7, 1, 0.25, 1};
    Fitted result;
    result.box = drawn.box_of(annotation, moment, picture).value();
    result.scale = drawn.scale_of(annotation, moment, picture);
    const Vec2 high = result.box.corner + result.box.size;
    result.is_inside = result.box.corner.x >= 0 && result.box.corner.y >= 0 &&
                       high.x <= picture.x && high.y <= picture.y;
    return result;
}

TEST(PictureItems, TextsThatAreTooWide_AreBrokenBetweenWords) {
    const std::string caption = "Watch where the nine ball goes now";
    const std::vector<Vec2> pictures{{320, 180}, {180, 320}, {240, 240}, {100, 400}};
    for (const Vec2& picture : pictures) {
        for (const double x : {0.0, 0.5, 1.0}) {
            Annotation text;
            text.kind = TextAnnotation{caption};
            text.place = PicturePlace{{x, 1}, true};
            const Fitted fit = fitted(text, picture);
            EXPECT_TRUE(fit.is_inside) << picture.x << "x" << picture.y;
            EXPECT_GT(fit.scale, 0.5);
        }
        Annotation title;
        title.kind = TitleAnnotation{"A long title of this film", "and what it is about"};
        EXPECT_TRUE(fitted(title, picture).is_inside) << picture.x << "x" << picture.y;
    }
    // As it was written where it fits; else with more lines of the same height.
    Annotation text;
    text.kind = TextAnnotation{caption};
    const Fitted wide = fitted(text, {640, 360});
    const Fitted narrow = fitted(text, {360, 640});
    EXPECT_EQ(wide.scale, 1);
    EXPECT_EQ(narrow.scale, 1);
    EXPECT_GT(narrow.box.size.y / 640, 1.6 * wide.box.size.y / 360) << "two lines";
    EXPECT_LE(narrow.box.size.x, 360 - 2 * 0.035 * 640 + 1e-9);
}

TEST(PictureItems, PositionsAtTheEdge_KeepTextsInsideThePicture) {
    Annotation text;
    text.kind = TextAnnotation{"a caption"};
    for (const Vec2& at : {Vec2(0, 0), Vec2(1, 1), Vec2(0.99, 0.5)}) {
        text.place = PicturePlace{at, false};
        EXPECT_TRUE(fitted(text, {320, 180}).is_inside) << at;
    }
    text.place = PicturePlace{{0.4, 0.6}, false};
    const AnnotationBox box = fitted(text, {320, 180}).box;
    EXPECT_NEAR(box.corner.x + 0.5 * box.size.x, 128, 1e-9) << "as written where it fits";
    Annotation tip;
    tip.kind = PlanAnnotation{};
    tip.place = PicturePlace{{0, 0}, false};
    EXPECT_FALSE(fitted(tip, {320, 180}).is_inside) << "which check warns of";
}

TEST(PictureItems, WordsThatAreTooWide_AreSmaller) {
    Annotation text;
    text.kind = TextAnnotation{"Wiederholungsaufnahmen"};
    text.size = 0.1;
    const Fitted fit = fitted(text, {180, 320});
    EXPECT_TRUE(fit.is_inside);
    EXPECT_LT(fit.scale, 0.7);
    EXPECT_GT(fit.scale, 0.25);
    // As many lines as there are do not fit at their size.
    text.kind = TextAnnotation{"a\nb\nc\nd\ne\nf\ng\nh\ni\nj\nk\nl"};
    EXPECT_TRUE(fitted(text, {320, 180}).is_inside);
    Annotation plan;
    plan.kind = PlanAnnotation{};
    plan.size = 0.9;
    EXPECT_LT(fitted(plan, {100, 320}).scale, 1);
    EXPECT_LE(fitted(plan, {100, 320}).box.size.x, 100);
}

TEST(PictureItems, Tip_IsWhereTheStickHits) {
    Annotation tip;
    tip.kind = TipAnnotation{"cue"};
    tip.size = 0.5;
    tip.colour = Vec3(1, 0, 0);
    Items items;
    EXPECT_EQ(items.draw(tip).right, -1) << "nothing without a strike";
    sim::Strike strike;
    strike.direction = 0;
    strike.tip = {0.4, 0.3};
    items.shot.world.events = {{"cue", 0, {}, 0, strike}};
    const Extent box = items.draw(tip);
    EXPECT_NEAR(box.width(), 100, 1);
    EXPECT_NEAR(box.height(), 100, 1);
    // The ball's radius is 0.4 of the diagram's size.
    const int x = box.left + 50 + static_cast<int>(0.4 * 40);
    const int y = box.top + 50 - static_cast<int>(0.3 * 40);
    EXPECT_EQ(items.pixel(x, y), 0xffff0000);
    EXPECT_NE(items.pixel(box.left + 50 - 16, box.top + 50 + 12), 0xffff0000);
}

TEST(PictureItems, Plan_ShowsBallsWhereTheyAre) {
    Annotation plan;
    plan.kind = PlanAnnotation{false};
    plan.size = 0.5;
    plan.place = PicturePlace{{0, 0}, true};
    Items before, after;
    const Extent box = before.draw(plan, 0);
    after.draw(plan, 0.5);
    EXPECT_NEAR(box.height(), 100, 1);
    // Without a table the drawing is symmetric, up to 0.12 m beyond the farthest position.
    const double half_x = 1.12;
    const double half_y = std::max(0.5, 0.5 + 0.042426 + 0.12);
    const auto place = [&](double x, double y) {
        return std::pair{box.left + static_cast<int>(50 / half_y * (x + half_x)),
                         box.top + static_cast<int>(50 / half_y * (half_y - y))};
    };
    const auto [x0, y0] = place(-1, 0);
    const auto [x1, y1] = place(0, 0);
    EXPECT_NE(before.pixel(x0, y0), after.pixel(x0, y0));
    EXPECT_NE(before.pixel(x1, y1), after.pixel(x1, y1));
}

TEST(PictureItems, Image_KeepsItsProportionsAndColours) {
    const ScratchFolder folder;
    const std::string path = folder.path("logo.png");
    render::write_display_image(
        [] {
            std::vector<std::uint8_t> rgb;
            for (int i = 0; i < 20 * 10; ++i) {
                rgb.insert(rgb.end(), {255, 128, 0});
            }
            return rgb;
        }(),
        20, 10, path);
    Annotation image;
    image.kind = ImageAnnotation{path};
    image.size = 0.2;
    Items items;
    const Extent box = items.draw(image);
    EXPECT_NEAR(box.width(), 80, 1);
    EXPECT_NEAR(box.height(), 40, 1);
    EXPECT_EQ(items.pixel(box.left + 20, box.top + 20), 0xffff8000);
    image.kind = ImageAnnotation{folder.path("none.png")};
    EXPECT_THROW(items.draw(image), Error);
}

}  // namespace
}  // namespace carom::pipeline

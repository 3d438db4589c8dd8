#include "pipeline/picture/scene_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "pipeline/picture/colours.h"
#include "render/acceleration/flush_denormals.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

constexpr double kEdgeOpacity = 0.75;
constexpr double kHeadWidth = 0.8;    // of an arrowhead, of its length
constexpr double kLongestPiece = 64;  // of a line whose depth is set at once, samples
constexpr double kBeyond = 2;         // of depths beyond a line's edge, samples

Vec2 towards(const Vec2& from, const Vec2& to) {
    const Vec2 way = to - from;
    const double length = way.length();
    return length > 0 ? way / length : Vec2(1, 0);
}

/// The arrowhead at the end of a line, and the line without it.
struct Headed {
    std::vector<Vec2> places;
    std::array<Vec2, 3> head;  // base, tip, base
    bool has_head = false;
};

Headed headed(const PlacedLine& line) {
    Headed result;
    for (const PlacedPoint& point : line.points) {
        result.places.push_back(point.place);
    }
    if (line.head <= 0 || result.places.size() < 2) {
        return result;
    }
    const Vec2 tip = result.places.back();
    // The point of the line at the head's length from the tip.
    Vec2 base = tip;
    while (result.places.size() > 1) {
        base = result.places.back();
        const Vec2 before = result.places[result.places.size() - 2];
        const double from_tip = (before - tip).length();
        if (from_tip >= line.head) {
            const double here = (base - tip).length();
            base =
                before + (from_tip - line.head) / std::max(from_tip - here, 1e-9) * (base - before);
            break;
        }
        result.places.pop_back();
        base = before;
    }
    const Vec2 along = towards(base, tip);
    const Vec2 side = 0.5 * kHeadWidth * line.head * Vec2(-along.y, along.x);
    const Vec2 foot = tip - line.head * along;
    result.places.back() = foot + 0.25 * line.head * along;
    if (result.places.size() == 1) {
        result.places.insert(result.places.begin(), base);
    }
    result.head = {foot + side, tip, foot - side};
    result.has_head = true;
    return result;
}

void add_places(cairo_t* context, std::span<const Vec2> places) {
    cairo_new_sub_path(context);
    for (const Vec2& place : places) {
        cairo_line_to(context, place.x, place.y);
    }
}

/// Composes a colour over a premultiplied pixel.
std::uint32_t composed(std::uint32_t below, const std::array<float, 4>& colour) {
    std::uint32_t result = 0;
    const float left = 1 - colour[3] / 255;
    for (int channel = 0; channel < 4; ++channel) {
        const auto old = static_cast<float>((below >> (8 * channel)) & 0xff);
        const auto value = static_cast<std::uint32_t>(
            std::lround(std::min(255.0F, colour[static_cast<std::size_t>(channel)] + left * old)));
        result |= value << (8 * channel);
    }
    return result;
}

}  // namespace

SceneLayer::SceneLayer(std::span<const PlacedShape> shapes, const PixelBox& box)
    : box_(box),
      canvas_(columns(), rows()),
      samples_(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows())) {
    cairo_t* context = canvas_.context();
    cairo_scale(context, kSide, kSide);
    cairo_translate(context, -box.left, -box.top);
    for (const PlacedShape& shape : shapes) {
        std::visit(
            [&](const auto& s) {
                draw(s);
                set_depth(s);
            },
            shape);
    }
}

void SceneLayer::draw(const PlacedArea& area) {
    cairo_t* context = canvas_.context();
    add_places(context, area.corners);
    cairo_close_path(context);
    set_colour(context, area.colour, area.opacity);
    cairo_fill(context);
}

void SceneLayer::draw_line(const PlacedLine& line, double width) {
    cairo_t* context = canvas_.context();
    const Headed parts = headed(line);
    cairo_set_line_cap(context, line.is_round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_width(context, width);
    add_places(context, parts.places);
    if (line.is_closed || line.points.size() == 1) {
        cairo_close_path(context);
    }
    cairo_stroke(context);
    if (parts.has_head) {
        add_places(context, parts.head);
        cairo_close_path(context);
        cairo_fill_preserve(context);
        cairo_set_line_width(context, std::max(0.0, width - line.width));
        cairo_stroke(context);
    }
}

void SceneLayer::draw(const PlacedLine& line) {
    cairo_t* context = canvas_.context();
    set_colour(context, casing_colour(), kEdgeOpacity);
    draw_line(line, line.width + 2 * line.edge);
    set_colour(context, line.colour, 1);
    draw_line(line, line.width);
}

void SceneLayer::draw(const PlacedText& text) {
    text.text.draw(canvas_.context(), text.corner);
}

void SceneLayer::set_depth(const PlacedArea& area) {
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column) {
            samples_[index(column, row)].inverse_depth = static_cast<float>(
                area.constant + area.slope.dot(area.bend.straight(place_of(column, row))));
        }
    }
}

void SceneLayer::set_depth(const PlacedLine& line) {
    const double radius =
        kSide * std::max(0.5 * line.width + line.edge, 0.5 * kHeadWidth * line.head + line.edge) +
        kBeyond;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < (line.is_closed || count == 1 ? count : count - 1); ++i) {
        const PlacedPoint& from = line.points[i];
        const PlacedPoint& to = line.points[(i + 1) % count];
        const double length = kSide * (to.place - from.place).length();
        const int pieces = std::max(1, static_cast<int>(std::min(1e5, length / kLongestPiece)));
        PlacedPoint begin = from;
        for (int piece = 1; piece <= pieces; ++piece) {
            const double u = static_cast<double>(piece) / pieces;
            const PlacedPoint end{from.place + u * (to.place - from.place),
                                  from.inverse_depth + u * (to.inverse_depth - from.inverse_depth),
                                  from.strength + u * (to.strength - from.strength)};
            set_depth_of_piece(begin, end, radius);
            begin = end;
        }
    }
}

void SceneLayer::set_depth_of_piece(const PlacedPoint& from, const PlacedPoint& to, double radius) {
    const Vec2 a = sample_at(from.place);
    const Vec2 b = sample_at(to.place);
    const Vec2 way = b - a;
    const double squared = way.dot(way);
    const auto clipped = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    const int right = clipped(std::max(a.x, b.x) + radius + 1, columns());
    const int bottom = clipped(std::max(a.y, b.y) + radius + 1, rows());
    for (int row = clipped(std::min(a.y, b.y) - radius, rows()); row < bottom; ++row) {
        for (int column = clipped(std::min(a.x, b.x) - radius, columns()); column < right;
             ++column) {
            const Vec2 off = Vec2(column + 0.5, row + 0.5) - a;
            const double u = squared > 0 ? std::clamp(off.dot(way) / squared, 0.0, 1.0) : 0;
            const auto distance = static_cast<float>((off - u * way).length());
            Sample& sample = samples_[index(column, row)];
            if (distance <= radius && distance < sample.distance) {
                sample = {static_cast<float>(from.inverse_depth +
                                             u * (to.inverse_depth - from.inverse_depth)),
                          static_cast<float>(from.strength + u * (to.strength - from.strength)),
                          distance};
            }
        }
    }
}

void SceneLayer::set_depth(const PlacedText& text) {
    const Vec2 low = sample_at(text.corner);
    const Vec2 high = sample_at(text.corner + text.text.size());
    const auto clipped = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    for (int row = clipped(low.y - 1, rows()); row < clipped(high.y + 2, rows()); ++row) {
        for (int column = clipped(low.x - 1, columns()); column < clipped(high.x + 2, columns());
             ++column) {
            samples_[index(column, row)] = {static_cast<float>(text.inverse_depth), 1, -1};
        }
    }
}

SceneLayer::PixelSamples SceneLayer::drawn_samples(int x, int y,
                                                   std::span<const std::uint32_t> pixels) const {
    PixelSamples samples;
    for (int row = kSide * y; row < kSide * (y + 1); ++row) {
        for (int column = kSide * x; column < kSide * (x + 1); ++column) {
            const std::size_t at = index(column, row);
            if (pixels[at] >> 24 != 0 && samples_[at].inverse_depth > 0) {
                samples.at[samples.count++] = at;
            }
        }
    }
    return samples;
}

bool SceneLayer::is_hidden(std::size_t at, const Pinhole& view, const Obstacles& obstacles) const {
    const auto column = static_cast<int>(at % static_cast<std::size_t>(columns()));
    const auto row = static_cast<int>(at / static_cast<std::size_t>(columns()));
    return obstacles.hides(view.position(), view.direction(place_of(column, row)),
                           1 / static_cast<double>(samples_[at].inverse_depth));
}

void SceneLayer::remove_hidden(PixelSamples& samples, const Pinhole& view,
                               const Obstacles& obstacles) const {
    // Four samples that agree stand for all.
    constexpr std::size_t kFew = 4;
    if (samples.count > kFew) {
        std::size_t hidden = 0;
        for (std::size_t i = 0; i < kFew; ++i) {
            const std::size_t chosen = i * (samples.count - 1) / (kFew - 1);
            hidden += is_hidden(samples.at[chosen], view, obstacles) ? 1U : 0U;
        }
        if (hidden == 0 || hidden == kFew) {
            samples.count = hidden == 0 ? samples.count : 0;
            return;
        }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.count; ++i) {
        if (!is_hidden(samples.at[i], view, obstacles)) {
            samples.at[kept++] = samples.at[i];
        }
    }
    samples.count = kept;
}

SceneLayer::Colour SceneLayer::mean_of(const PixelSamples& samples,
                                       std::span<const std::uint32_t> pixels) const {
    Colour sum;
    for (std::size_t i = 0; i < samples.count; ++i) {
        const std::uint32_t pixel = pixels[samples.at[i]];
        const float weight = samples_[samples.at[i]].strength / (kSide * kSide);
        sum.blue += weight * static_cast<float>(pixel & 0xff);
        sum.green += weight * static_cast<float>((pixel >> 8) & 0xff);
        sum.red += weight * static_cast<float>((pixel >> 16) & 0xff);
        sum.alpha += weight * static_cast<float>(pixel >> 24);
    }
    return sum;
}

void SceneLayer::compose(const Pinhole& view, const Obstacles& obstacles, double opacity,
                         Canvas& picture) const {
    const std::span<const std::uint32_t> drawn = canvas_.pixels();
    const std::span<std::uint32_t> pixels = picture.pixels();
    const auto factor = static_cast<float>(opacity);
    render::parallel_for(static_cast<std::size_t>(box_.bottom - box_.top), [&](std::size_t row) {
        const render::FlushDenormals flush;
        const auto y = static_cast<int>(row);
        for (int x = 0; x < box_.right - box_.left; ++x) {
            PixelSamples samples = drawn_samples(x, y, drawn);
            remove_hidden(samples, view, obstacles);
            const Colour colour = mean_of(samples, drawn);
            if (colour.alpha <= 0) {
                continue;
            }
            std::uint32_t& pixel = pixels[static_cast<std::size_t>(box_.top + y) *
                                              static_cast<std::size_t>(picture.width()) +
                                          static_cast<std::size_t>(box_.left + x)];
            pixel = composed(pixel, {factor * colour.blue, factor * colour.green,
                                     factor * colour.red, factor * colour.alpha});
        }
    });
    picture.changed();
}

}  // namespace carom::pipeline

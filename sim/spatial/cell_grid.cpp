#include "sim/spatial/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"

namespace carom::sim {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
// Beyond this many cells from the origin everything is one cell, so distant balls cross no cells.
constexpr std::int32_t kOutermost = 1 << 16;

/// The first t >= 0 at which c0 + c1 t + c2 t^2 rises through zero; kNever if it does not.
double rise_time(double c0, double c1, double c2) {
    if (c0 >= 0 && (c1 > 0 || (c1 == 0 && c2 > 0))) {
        return 0;
    }
    if (c2 == 0) {
        if (!(c1 > 0)) {
            return kNever;
        }
        return -c0 / c1;
    }
    const double discriminant = c1 * c1 - 4 * c2 * c0;
    if (!(discriminant > 0)) {
        return kNever;
    }
    // The root with a positive slope, in the form without cancellation.
    const double root = std::sqrt(discriminant);
    const double t = c1 > 0 ? -2 * c0 / (root + c1) : (root - c1) / (2 * c2);
    if (t > 0) {
        return t;
    }
    return kNever;
}

}  // namespace

CellGrid::CellGrid(double width, std::size_t count)
    : width_(width), cells_(count), next_(count, kNone), previous_(count, kNone) {
    CAROM_ASSERT(width > 8 * kCellMargin);
    std::size_t size = 64;
    while (size < 2 * count) {
        size *= 2;
    }
    buckets_.assign(size, kNone);
    for (std::uint32_t item = 0; item < count; ++item) {
        link(item);
    }
}

std::int32_t CellGrid::coordinate(double value) const {
    const double cell = std::floor(value / width_);
    // Written so that NaN ends up in a cell too.
    if (!(cell > -kOutermost)) {
        return -kOutermost;
    }
    return cell < kOutermost ? static_cast<std::int32_t>(cell) : kOutermost;
}

std::size_t CellGrid::bucket_of(Cell cell) const {
    // A simple hash suffices: multiplication by odd constants, with high bits folded down.
    const auto x = static_cast<std::uint32_t>(cell.x);
    const auto y = static_cast<std::uint32_t>(cell.y);
    std::uint32_t mixed = x * 0x9E3779B1U + y * 0x85EBCA77U;
    mixed ^= mixed >> 15U;
    return mixed & (buckets_.size() - 1);
}

void CellGrid::link(std::uint32_t item) {
    std::uint32_t& head = buckets_[bucket_of(cells_[item])];
    next_[item] = head;
    previous_[item] = kNone;
    if (head != kNone) {
        previous_[head] = item;
    }
    head = item;
}

void CellGrid::unlink(std::uint32_t item) {
    if (next_[item] != kNone) {
        previous_[next_[item]] = previous_[item];
    }
    if (previous_[item] != kNone) {
        next_[previous_[item]] = next_[item];
    } else {
        buckets_[bucket_of(cells_[item])] = next_[item];
    }
}

void CellGrid::place(std::uint32_t item, const Vec3& position) {
    const Cell known = cells_[item];
    const auto is_in = [&](double value, std::int32_t cell) {
        const double offset = value - cell * width_;
        const bool above = cell == -kOutermost || offset > -kCellMargin;
        const bool below = cell == kOutermost || offset < width_ + kCellMargin;
        return above && below;
    };
    if (is_in(position.x, known.x) && is_in(position.y, known.y)) {
        return;
    }
    unlink(item);
    cells_[item] = {coordinate(position.x), coordinate(position.y)};
    link(item);
}

std::optional<CellGrid::Crossing> CellGrid::next_crossing(std::uint32_t item,
                                                          const MotionSegment& path, double now,
                                                          double until) const {
    const Cell cell = cells_[item];
    const Vec3 p = path.position_at(now);
    const Vec3 v = path.velocity_at(now);
    const Vec3& a = path.acceleration;
    double first = kNever;
    Side side = Side::left;
    const auto consider = [&](double time, Side to) {
        if (time < first) {
            first = time;
            side = to;
        }
    };
    if (cell.x > -kOutermost) {
        consider(rise_time(cell.x * width_ - p.x, -v.x, -0.5 * a.x), Side::left);
    }
    if (cell.x < kOutermost) {
        consider(rise_time(p.x - (cell.x + 1) * width_, v.x, 0.5 * a.x), Side::right);
    }
    if (cell.y > -kOutermost) {
        consider(rise_time(cell.y * width_ - p.y, -v.y, -0.5 * a.y), Side::front);
    }
    if (cell.y < kOutermost) {
        consider(rise_time(p.y - (cell.y + 1) * width_, v.y, 0.5 * a.y), Side::back);
    }
    if (!(now + first <= until)) {
        return std::nullopt;
    }
    return Crossing{now + first, side};
}

void CellGrid::cross(std::uint32_t item, Side to) {
    unlink(item);
    Cell& cell = cells_[item];
    switch (to) {
        case Side::left:
            --cell.x;
            break;
        case Side::right:
            ++cell.x;
            break;
        case Side::front:
            --cell.y;
            break;
        case Side::back:
            ++cell.y;
            break;
    }
    link(item);
}

void CellGrid::find_in(Cell cell, std::uint32_t item, std::vector<std::uint32_t>& found) const {
    for (std::uint32_t i = buckets_[bucket_of(cell)]; i != kNone; i = next_[i]) {
        if (i != item && cells_[i] == cell) {
            found.push_back(i);
        }
    }
}

void CellGrid::find_near(std::uint32_t item, std::vector<std::uint32_t>& found) const {
    found.clear();
    const Cell cell = cells_[item];
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            find_in({cell.x + dx, cell.y + dy}, item, found);
        }
    }
}

void CellGrid::find_ahead(std::uint32_t item, Side to, std::vector<std::uint32_t>& found) const {
    found.clear();
    const Cell cell = cells_[item];
    for (std::int32_t d = -1; d <= 1; ++d) {
        switch (to) {
            case Side::left:
                find_in({cell.x - 1, cell.y + d}, item, found);
                break;
            case Side::right:
                find_in({cell.x + 1, cell.y + d}, item, found);
                break;
            case Side::front:
                find_in({cell.x + d, cell.y - 1}, item, found);
                break;
            case Side::back:
                find_in({cell.x + d, cell.y + 1}, item, found);
                break;
        }
    }
}

}  // namespace carom::sim

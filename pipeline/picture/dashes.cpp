#include "pipeline/picture/dashes.h"

#include <span>

namespace carom::pipeline {
namespace {

constexpr double kDashed[] = {0.05, 0.035};  // m: a dash, a gap ...
constexpr double kDotted[] = {0, 0.03};
constexpr double kDashDot[] = {0.06, 0.03, 0, 0.03};

std::span<const double> pattern_of(Dash dash) {
    switch (dash) {
        case Dash::dashed:
            return kDashed;
        case Dash::dotted:
            return kDotted;
        case Dash::dash_dot:
            return kDashDot;
        case Dash::solid:
            break;
    }
    return {};
}

/// Walks along a line and switches between dashes and gaps.
class Cutter {
  public:
    Cutter(std::span<const double> pattern, double scale) : pattern_(pattern), scale_(scale) {
        left_ = scale_ * pattern_[0];
    }

    std::vector<StrongLine> cut(const StrongLine& line) {
        begin_at(line.front());
        for (std::size_t i = 1; i < line.size(); ++i) {
            walk(line[i - 1], line[i]);
        }
        end_piece();
        return std::move(pieces_);
    }

  private:
    [[nodiscard]] bool is_gap() const { return part_ % 2 == 1; }

    void begin_at(const StrongPoint& point) {
        if (!is_gap()) {
            piece_ = {point};
        }
        while (left_ <= 0) {  // a dot
            next_part(point);
        }
    }
    void end_piece() {
        if (!piece_.empty()) {
            pieces_.push_back(std::move(piece_));
            piece_.clear();
        }
    }
    void next_part(const StrongPoint& point) {
        if (!is_gap()) {
            end_piece();
        }
        part_ = (part_ + 1) % pattern_.size();
        left_ += scale_ * pattern_[part_];
        if (!is_gap()) {
            piece_ = {point};
        }
    }
    void walk(const StrongPoint& from, const StrongPoint& to) {
        const double length = (to.at - from.at).length();
        double done = 0;
        while (length - done > left_) {
            done += left_;
            left_ = 0;
            const double u = done / length;
            const StrongPoint point{from.at + u * (to.at - from.at),
                                    from.strength + u * (to.strength - from.strength)};
            if (!is_gap()) {
                piece_.push_back(point);
            }
            next_part(point);
            while (left_ <= 0) {
                next_part(point);
            }
        }
        left_ -= length - done;
        if (!is_gap()) {
            piece_.push_back(to);
        }
    }

    std::span<const double> pattern_;
    double scale_;
    std::size_t part_ = 0;
    double left_ = 0;  // of this part, m
    StrongLine piece_;
    std::vector<StrongLine> pieces_;
};

}  // namespace

std::vector<StrongLine> cut_into_dashes(const StrongLine& line, Dash dash, double scale) {
    if (dash == Dash::solid || line.size() < 2) {
        return {line};
    }
    return Cutter(pattern_of(dash), scale).cut(line);
}

}  // namespace carom::pipeline

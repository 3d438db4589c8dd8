#include "sound/source/mode_bank.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/elementary.h"
#include "core/vector_clones.h"

namespace carom::sound {
namespace {

constexpr double kHeightThreshold = 1e-3;  // of the least height, below which a ring is left out

/// The part of a row of times first + i step that lies in (from, to].
struct SampleRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// How many of the times are at most `limit`, for a positive step, or above it, for a negative one.
/// The quotient only guesses: the times themselves decide.
std::size_t count_before(double first, double step, std::size_t count, double limit) {
    const auto is_before = [&](std::size_t i) {
        const double time = first + static_cast<double>(i) * step;
        return step > 0 ? time <= limit : time > limit;
    };
    const double guess = std::floor((limit - first) / step);
    auto i = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(count)));
    while (i > 0 && !is_before(i - 1)) {
        --i;
    }
    while (i < count && is_before(i)) {
        ++i;
    }
    return i;
}

SampleRange range_of(double first, double step, std::size_t count, double from, double to) {
    const std::size_t begin = count_before(first, step, count, step > 0 ? from : to);
    const std::size_t end = count_before(first, step, count, step > 0 ? to : from);
    return {begin, std::max(begin, end)};
}

/// Adds Re(amplitude e^{pole i step}) for i = 0, 1, 2 ... Eight numbers are kept at a time, each of
/// which advances by eight steps, since one product would have to wait for the one before.
CAROM_VECTOR_CLONES void add_ring(Complex amplitude, Complex pole, double step,
                                  std::span<double> pressures) {
    constexpr std::size_t kLanes = 8;
    std::array<double, kLanes> re{};
    std::array<double, kLanes> im{};
    const Complex turn = exponential(step * pole);
    Complex state = amplitude;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        re[lane] = state.re;
        im[lane] = state.im;
        state = state * turn;
    }
    const Complex two_turns = turn * turn;
    const Complex four_turns = two_turns * two_turns;
    const Complex turns = four_turns * four_turns;
    std::size_t i = 0;
    for (; i + kLanes <= pressures.size(); i += kLanes) {
        double* out = &pressures[i];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            out[lane] += re[lane];
            const double real = re[lane] * turns.re - im[lane] * turns.im;
            im[lane] = re[lane] * turns.im + im[lane] * turns.re;
            re[lane] = real;
        }
    }
    for (std::size_t lane = 0; i < pressures.size(); ++i, ++lane) {
        pressures[i] += re[lane];
    }
}

}  // namespace

ModeBank::ModeBank(double duration, std::span<const Partial> partials, double least,
                   PulseShape shape)
    : duration_(duration), end_(duration) {
    for (const Partial& partial : partials) {
        const PoleResponse response = pole_response(partial.pole, duration, shape);
        Ring ring;
        ring.pole = partial.pole;
        ring.during = 2 * (partial.residue * response.a);
        ring.after = ring.during * (Complex{1, 0} + exponential(duration * partial.pole));
        const double height = std::sqrt(squared_length(ring.after));
        ring.fade = ring.end = duration;
        if (height > least) {
            ring.fade += logarithm(height / least) / -partial.pole.re;
        }
        if (height > kHeightThreshold * least) {
            ring.end = ring.fade + std::numbers::ln2 / -partial.pole.re;
        }
        end_ = std::max(end_, ring.end);
        rings_.push_back(ring);
        for (std::size_t k = 0; k < kPulseSines; ++k) {
            cosines_[k] += 2 * (partial.residue * response.c[k]).re;
            sines_[k] += 2 * (partial.residue * response.s[k]).re;
        }
    }
}

void ModeBank::add(double first, double step, std::span<double> pressures) const {
    const SampleRange during = range_of(first, step, pressures.size(), 0, duration_);
    add_during(first + static_cast<double>(during.begin) * step, step,
               pressures.subspan(during.begin, during.end - during.begin));
    for (const Ring& ring : rings_) {
        const SampleRange after = range_of(first, step, pressures.size(), duration_, ring.fade);
        if (after.begin < after.end) {
            const double time = first + static_cast<double>(after.begin) * step - duration_;
            add_ring(ring.after * exponential(time * ring.pole), ring.pole, step,
                     pressures.subspan(after.begin, after.end - after.begin));
        }
        const SampleRange fade = range_of(first, step, pressures.size(), ring.fade, ring.end);
        if (fade.begin < fade.end) {
            add_fade(ring, first + static_cast<double>(fade.begin) * step, step,
                     pressures.subspan(fade.begin, fade.end - fade.begin));
        }
    }
}

/// The factor (1 + cos x)/2 is the sum of 1/2, e^{ix}/4 and e^{-ix}/4: three rings.
void ModeBank::add_fade(const Ring& ring, double first, double step,
                        std::span<double> pressures) const {
    const Complex height = ring.after * exponential((first - duration_) * ring.pole);
    add_ring(0.5 * height, ring.pole, step, pressures);
    for (const double sign : {-1.0, 1.0}) {
        const Complex turn{0, sign * std::numbers::pi / (ring.end - ring.fade)};
        add_ring(0.25 * height * exponential((first - ring.fade) * turn), ring.pole + turn, step,
                 pressures);
    }
}

void ModeBank::add_during(double first, double step, std::span<double> pressures) const {
    if (pressures.empty()) {
        return;
    }
    for (const Ring& ring : rings_) {
        add_ring(ring.during * exponential(first * ring.pole), ring.pole, step, pressures);
    }
    const double w = std::numbers::pi / duration_;
    for (std::size_t k = 0; k < kPulseSines; ++k) {
        // -(c cos + s sin) is the real part of -(c - i s) e^{i angle}.
        const Complex frequency{0, pulse_harmonic(k) * w};
        add_ring(Complex{-cosines_[k], sines_[k]} * exponential(first * frequency), frequency, step,
                 pressures);
    }
}

}  // namespace carom::sound

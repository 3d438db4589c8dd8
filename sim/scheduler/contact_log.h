// Collects the lasting contacts of a simulation, in stretches of nearly constant force and slip.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/timeline/event.h"

namespace carom::sim {

/// A pair whose surfaces move past each other, and whose bodies turn against each other, by less
/// than this (m/s) rests.
inline constexpr double kStillSpeed = 0.005;

/// How two objects press against each other from one instant to another.
struct ContactLoad {
    double from = 0, to = 0;    // scene time, s; the same for a tap
    double normal_impulse = 0;  // N s, > 0
    double slip = 0;            // m/s, mean speed of the surfaces past each other
    double turning = 0;         // m/s, speed of a point at the smaller body's radius as both turn
                                // against each other
};

/// The rule, which docs/timeline.md explains: a stretch begins when a pair that does not rest
/// touches, and ends when it rests or parts for more than kLongestPause. It has pieces of kPiece;
/// those next to each other are joined as long as no force in them is more than kJoinedForces times
/// another, and no slip more than kJoinedSlips times another or kStillSpeed above it. Stretches of
/// less than kMinStretch are left out. Of more than kMaxContacts pieces, those with the greatest
/// normal impulses are kept.
class ContactLog {
  public:
    static constexpr double kLongestPause = 2.1e-3;  // s, two of the longest steps
    static constexpr double kMinStretch = 2e-3;      // s
    static constexpr double kPiece = 0.02;           // s
    static constexpr double kJoinedForces = 1.25;
    static constexpr double kJoinedSlips = 1.25;
    static constexpr std::size_t kMaxContacts = 100'000;

    explicit ContactLog(std::size_t most_contacts = kMaxContacts) : most_(most_contacts) {}

    /// Object `a` and object or surface `b` touched during a step, or for an instant (a tap). Taps
    /// that follow each other within kLongestPause count as one contact: balls that their spin
    /// presses against something bounce off it thousands of times a second. Loads of a pair are
    /// added in order of time.
    void add(const std::string& a, const std::string& b, const ContactLoad& load);

    /// Ends all stretches. The contacts are in order of their beginnings, those that begin together
    /// in order of their names. Call it once.
    [[nodiscard]] std::vector<LastingContact> take();

  private:
    struct Sum {
        double from = 0, to = 0;  // s
        double impulse = 0;       // N s
        double slip_path = 0;     // m, slip times time
        double slip_time = 0;     // s

        void add(const ContactLoad& load, double since);
        void add(const Sum& next);
        [[nodiscard]] double duration() const { return to - from; }
        [[nodiscard]] double force() const { return impulse / duration(); }
        [[nodiscard]] double slip() const { return slip_time > 0 ? slip_path / slip_time : 0; }
    };
    struct Range {
        double least = 0, most = 0;

        [[nodiscard]] Range with(double value) const;
    };
    struct Piece {
        std::uint32_t pair = 0;
        Sum sum;
    };
    /// Of one pair; it has a beginning while a stretch is open.
    struct Open {
        bool is_open = false;
        double from = 0;          // beginning of the stretch
        Sum rest;                 // loads at rest since `piece` ended, empty if duration() is 0
        Sum piece;                // the last one, shorter than kPiece
        bool has_joined = false;  // whether there are pieces before it
        Sum joined;
        Range forces, slips;  // of the joined pieces

        [[nodiscard]] double end() const { return rest.duration() > 0 ? rest.to : piece.to; }
    };

    [[nodiscard]] std::uint32_t pair_number(const std::string& a, const std::string& b);
    void join(std::uint32_t pair);
    void end_stretch(std::uint32_t pair);
    void write(std::uint32_t pair, const Sum& sum);
    void keep_greatest();

    std::size_t most_;
    std::map<std::string, std::map<std::string, std::uint32_t>> numbers_;
    std::vector<Open> open_;  // per pair
    std::vector<Piece> written_;
};

}  // namespace carom::sim

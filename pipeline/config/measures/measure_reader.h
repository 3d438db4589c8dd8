// Reads the arguments of a measure, and finds what they name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/measures/measures.h"
#include "sim/event_time.h"

namespace carom::pipeline::measures {

/// Thrown and caught while a measure is read.
struct WrongMeasure {
    TextProblem problem;
};

/// The arguments in order. Each function takes the next one, and throws WrongMeasure if it is
/// missing or wrong.
class Arguments {
  public:
    /// `text` after `begin`; the commas in braces and brackets do not separate. `usage`:
    /// "cut:BALL,BALL".
    Arguments(const std::string& text, std::size_t begin, std::string usage,
              const sim::WorldDescription& world);

    [[nodiscard]] bool has_more() const { return next_ < words_.size(); }

    [[nodiscard]] std::string ball();     // that moves
    [[nodiscard]] std::string partner();  // an object or a surface
    [[nodiscard]] std::string pocket();
    [[nodiscard]] int number();     // at least 1; 1 if there are no more
    [[nodiscard]] double length();  // m
    /// All that remain: a moment as in YAML, or its words: cushion,cue,2.
    [[nodiscard]] sim::EventTime moment();

    /// There must be no more.
    void end() const;

  private:
    struct Word {
        std::string text;
        std::size_t offset = 0;
    };
    [[noreturn]] void fail(const Word& word, std::string sentence) const;
    const Word& take();
    void check_name(const Word& word, bool may_be_surface, bool must_move) const;

    std::vector<Word> words_;
    std::size_t next_ = 0;
    std::string usage_;
    std::size_t end_ = 0;  // of the text
    const sim::WorldDescription& world_;
};

/// The contact of two objects, or of an object and a surface, for the n-th time.
[[nodiscard]] sim::Trigger contact_of(std::string a, std::string b, int nth);

/// The event of a contact, pot or strike; nullptr if it never comes.
[[nodiscard]] const sim::Event* find_event(const sim::Trigger& trigger, const Played& played);

/// How many there are, whatever the trigger's `nth`.
[[nodiscard]] int count_events(const sim::Trigger& trigger, const Played& played);

/// Whether the time of this moment is found from the motion.
[[nodiscard]] bool needs_motion(const sim::EventTime& moment);

/// s; empty if the moment never comes.
[[nodiscard]] std::optional<double> time_of(const sim::EventTime& moment, const Played& played);

}  // namespace carom::pipeline::measures

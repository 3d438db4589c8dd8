#include "pipeline/config/measures/measure_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <variant>

#include "core/text.h"
#include "pipeline/config/parse_moment.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/config/quantity.h"
#include "pipeline/config/text.h"
#include "sim/occurrence.h"
#include "sim/timeline/surface.h"

namespace carom::pipeline::measures {

using config::hint;
using config::quote;

Arguments::Arguments(const std::string& text, std::size_t begin, std::string usage,
                     const sim::WorldDescription& world)
    : usage_(std::move(usage)), end_(text.size()), world_(world) {
    int depth = 0;
    for (std::size_t i = begin, first = begin; i <= text.size() && begin < text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ',';
        depth += (c == '{' || c == '[' ? 1 : 0) - (c == '}' || c == ']' ? 1 : 0);
        if (i == text.size() || (c == ',' && depth <= 0)) {
            const std::size_t from = std::min(text.find_first_not_of(' ', first), i);
            std::size_t to = i;
            while (to > from && text[to - 1] == ' ') {
                --to;
            }
            words_.push_back({text.substr(from, to - from), from});
            first = i + 1;
        }
    }
}

void Arguments::fail(const Word& word, std::string sentence) const {
    throw WrongMeasure{
        {std::move(sentence), word.offset, std::max<std::size_t>(word.text.size(), 1)}};
}

const Arguments::Word& Arguments::take() {
    if (!has_more() || words_[next_].text.empty()) {
        const std::size_t at = has_more() ? words_[next_].offset : end_;
        fail({"", at}, "this measure needs more arguments: " + usage_);
    }
    return words_[next_++];
}

void Arguments::end() const {
    if (has_more()) {
        fail(words_[next_], quote(words_[next_].text) + " is one argument too many for " + usage_);
    }
}

void Arguments::check_name(const Word& word, bool may_be_surface, bool must_move) const {
    std::vector<std::string> known;
    for (const sim::Body& body : world_.bodies) {
        if (!must_move || body.kind == sim::BodyKind::dynamic) {
            known.push_back(body.name);
        }
    }
    if (may_be_surface) {
        known.insert(known.end(), sim::surface_names().begin(), sim::surface_names().end());
    }
    if (std::ranges::find(known, word.text) != known.end()) {
        return;
    }
    const bool exists =
        std::ranges::find(world_.bodies, word.text, &sim::Body::name) != world_.bodies.end();
    fail(word,
         exists ? quote(word.text) + " is not moved by the simulation"
                : "there is no ball or object " + quote(word.text) + hint(word.text, known).text);
}

std::string Arguments::ball() {
    const Word& word = take();
    check_name(word, false, true);
    return word.text;
}

std::string Arguments::partner() {
    const Word& word = take();
    check_name(word, true, false);
    return word.text;
}

std::string Arguments::pocket() {
    const Word& word = take();
    const std::vector<std::string> known =
        world_.table ? config::pocket_names(*world_.table) : std::vector<std::string>();
    if (known.empty()) {
        fail(word, "the table has no pockets");
    }
    std::string pocket = config::pocket_of_name(*world_.table, word.text);
    if (pocket.empty()) {
        fail(word, "there is no pocket " + quote(word.text) + hint(word.text, known).text +
                       "; the pockets are " + enumerate(known, "and"));
    }
    return pocket;
}

int Arguments::number() {
    if (!has_more()) {
        return 1;
    }
    const Word& word = take();
    int value = 0;
    const char* last = word.text.data() + word.text.size();
    const auto [end, code] = std::from_chars(word.text.data(), last, value);
    if (code != std::errc() || end != last || value < 1) {
        fail(word, quote(word.text) + " is not a number of times; write 1, 2 or more");
    }
    return value;
}

double Arguments::length() {
    const Word& word = take();
    const auto parsed = config::parse_quantity(word.text);
    const auto* quantity = std::get_if<config::Quantity>(&parsed);
    const bool is_length =
        quantity != nullptr && (!quantity->has_unit || quantity->exponents == config::Exponents{1});
    if (!is_length) {
        fail(word, quote(word.text) + " is not a length; write 0.3 or 30 cm");
    }
    return quantity->value;
}

namespace {

/// The words of a moment as YAML: {contact: [cue, one], nth: 2}.
std::string moment_yaml(const std::vector<std::string>& words) {
    const std::size_t names = words[0] == "contact" ? 2 : 1;
    std::string text = "{" + words[0] + ": ";
    std::vector<std::string> named(
        words.begin() + 1,
        words.begin() + 1 + static_cast<std::ptrdiff_t>(std::min(names, words.size() - 1)));
    text += names == 2 ? "[" + join(named, ", ") + "]" : join(named, ", ");
    for (std::size_t i = 1 + names; i < words.size(); ++i) {
        text += ", nth: " + words[i];
    }
    return text + "}";
}

}  // namespace

sim::EventTime Arguments::moment() {
    const Word first = take();
    std::vector<Word> names;
    std::string yaml = first.text;
    if (!yaml.starts_with('{')) {
        constexpr std::array<std::string_view, 5> kKinds{"contact", "cushion", "potted", "resting",
                                                         "strike"};
        const std::vector<std::string> kinds(kKinds.begin(), kKinds.end());
        if (std::ranges::find(kinds, first.text) == kinds.end()) {
            fail(first, quote(first.text) + " is no moment" + hint(first.text, kinds).text +
                            "; write one such as cushion,cue,2 or '{contact: [cue, one]}'");
        }
        std::vector<std::string> words{first.text};
        while (has_more()) {
            words.push_back(take().text);
        }
        yaml = moment_yaml(words);
    }
    end();
    const auto parsed = parse_moment(yaml);
    const Word all{std::string(end_ - first.offset, ' '), first.offset};
    if (const auto* problem = std::get_if<std::string>(&parsed)) {
        fail(all, *problem);
    }
    const auto& moment = std::get<sim::EventTime>(parsed);
    for (const std::string& name : {moment.trigger.a, moment.trigger.b}) {
        if (!name.empty() && !sim::is_surface(name)) {
            check_name({name, first.offset}, true, false);
        }
    }
    return moment;
}

sim::Trigger contact_of(std::string a, std::string b, int nth) {
    sim::Trigger trigger;
    trigger.a = std::move(a);
    trigger.b = std::move(b);
    trigger.nth = nth;
    return trigger;
}

const sim::Event* find_event(const sim::Trigger& trigger, const Played& played) {
    sim::OccurrenceCounter counter(trigger);
    int count = 0;
    for (const sim::Event& event : played.outcome.events) {
        if (counter.counts(event) && ++count == trigger.nth) {
            return &event;
        }
    }
    return nullptr;
}

int count_events(const sim::Trigger& trigger, const Played& played) {
    sim::OccurrenceCounter counter(trigger);
    return static_cast<int>(std::ranges::count_if(
        played.outcome.events, [&](const sim::Event& event) { return counter.counts(event); }));
}

bool needs_motion(const sim::EventTime& moment) {
    return !sim::is_logged(moment.trigger.kind);
}

std::optional<double> time_of(const sim::EventTime& moment, const Played& played) {
    if (needs_motion(moment)) {
        const std::vector<double> times =
            sim::find_occurrences(moment.trigger, *played.outcome.motion, played.world);
        const auto nth = static_cast<std::size_t>(moment.trigger.nth);
        return nth <= times.size() ? std::optional(times[nth - 1] + moment.delay) : std::nullopt;
    }
    const sim::Event* event = find_event(moment.trigger, played);
    return event != nullptr ? std::optional(event->time + moment.delay) : std::nullopt;
}

}  // namespace carom::pipeline::measures

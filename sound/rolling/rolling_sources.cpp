#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/hash.h"
#include "sound/rolling/rolling_level.h"
#include "sound/rolling/rolling_plan.h"
#include "sound/rolling/rolling_source.h"
#include "sound/rolling/scraping_way.h"
#include "sound/source/impact_sound.h"

namespace carom::sound {
namespace {

RollingPlan plan_of(const SoundBody& body, const std::string& other,
                    const sim::Timeline& timeline) {
    RollingPlan plan;
    plan.body = body.name;
    plan.track = timeline.find(body.name);
    plan.place = body.position;
    plan.seed = Hasher().add(body.name).add(other).finish().low;
    return plan;
}

RollingPlan ball_plan(const SoundBody& body, std::vector<Stretch> stretches,
                      std::vector<Touch> touches, const sim::Timeline& timeline) {
    RollingPlan plan = plan_of(body, "cloth", timeline);
    plan.texture = kCloth;
    plan.stretches = std::move(stretches);
    const double radius = std::get<BallShape>(body.shape).radius;
    plan.ways = [track = plan.track, radius, touches = std::move(touches)](const Stretch& stretch) {
        return ball_ways(*track, radius, stretch.from, stretch.to, touches);
    };
    return plan;
}

/// The contacts of all things by their names, in order of time.
std::unordered_map<std::string_view, std::vector<Touch>> touches_of(const SoundShot& shot) {
    const ImpactSounds sounds(shot);
    std::unordered_map<std::string_view, std::vector<Touch>> touches;
    for (const sim::Event& event : shot.timeline->events) {
        if (const std::optional<ImpactSound> sound = sounds.sound_of(event)) {
            for (const std::string* name : {&event.a, &event.b}) {
                touches[*name].push_back({event.time, sound->contact_time});
            }
        }
    }
    return touches;
}

/// Whether two scrapes of a pair are parts of one contact.
bool are_adjacent(const Scrape& scrape, const Scrape& next) {
    constexpr double kSame = 1e-9;  // s
    return next.from - scrape.to < kSame;
}

RollingPlan scraping_plan(const SoundBody& body, const std::string& other,
                          std::vector<Scrape> scrapes, const sim::Timeline& timeline) {
    RollingPlan plan = plan_of(body, other, timeline);
    plan.texture = other == "cloth" || other == "cushion" ? kCloth : kSolid;
    for (std::size_t i = 0; i < scrapes.size(); ++i) {
        if (i > 0 && are_adjacent(scrapes[i - 1], scrapes[i])) {
            plan.stretches.back().to = scrapes[i].to;
        } else {
            plan.stretches.push_back({scrapes[i].from, scrapes[i].to});
        }
    }
    plan.ways = [scrapes = std::move(scrapes)](const Stretch& stretch) {
        const auto first =
            std::partition_point(scrapes.begin(), scrapes.end(),
                                 [&](const Scrape& scrape) { return scrape.to <= stretch.from; });
        const auto last = std::partition_point(
            first, scrapes.end(), [&](const Scrape& scrape) { return scrape.from < stretch.to; });
        return BallWays{{}, scraping_way({first, last})};
    };
    return plan;
}

/// Adds a scrape to those of a pair, which are in order of their beginnings. Where two contacts of
/// one pair overlap, the later one goes on alone.
void add_scrape(std::vector<Scrape>& scrapes, const Scrape& scrape) {
    while (!scrapes.empty() && scrape.from < scrapes.back().to) {
        scrapes.back().to = scrape.from;
        if (scrapes.back().to > scrapes.back().from) {
            break;
        }
        scrapes.pop_back();
    }
    scrapes.push_back(scrape);
}

/// The scrapes of one pair.
struct Pair {
    const SoundBody* body = nullptr;
    std::string other;
    std::vector<Scrape> scrapes;
};

/// The pairs with lasting contacts that are heard somewhere, in order of their first.
std::vector<Pair> scraping_pairs(const SoundShot& shot) {
    std::map<std::string_view, const SoundBody*> bodies;
    for (const SoundBody& body : shot.bodies) {
        bodies.emplace(body.name, &body);
    }
    std::vector<Pair> pairs;
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> indices;
    for (const sim::LastingContact& contact : shot.timeline->lasting_contacts) {
        const auto body = bodies.find(contact.a);
        if (body == bodies.end() || !(contact.from < contact.to)) {
            continue;
        }
        const bool is_ball = std::holds_alternative<BallShape>(body->second->shape);
        if (is_ball && (contact.b == "cloth" || contact.b == "floor")) {
            continue;
        }
        const auto [index, is_new] = indices.try_emplace({contact.a, contact.b}, pairs.size());
        if (is_new) {
            pairs.push_back({body->second, contact.b, {}});
        }
        add_scrape(pairs[index->second].scrapes,
                   {contact.from, contact.to, contact.normal_force, contact.slip});
    }
    std::erase_if(pairs, [](const Pair& pair) {
        return std::all_of(pair.scrapes.begin(), pair.scrapes.end(), [](const Scrape& scrape) {
            return scraping_pressure(scrape.slip, scrape.force) == 0;
        });
    });
    return pairs;
}

}  // namespace

std::vector<RollingSource> rolling_sources(const SoundShot& shot) {
    const sim::Timeline& timeline = *shot.timeline;
    std::vector<RollingSource> sources;
    std::vector<std::vector<Stretch>> rolling = rolling_stretches(timeline, shot.bodies);
    auto touches = touches_of(shot);
    for (std::size_t i = 0; i < shot.bodies.size(); ++i) {
        if (!rolling[i].empty()) {
            sources.emplace_back(ball_plan(shot.bodies[i], std::move(rolling[i]),
                                           std::move(touches[shot.bodies[i].name]), timeline));
        }
    }
    for (Pair& pair : scraping_pairs(shot)) {
        sources.emplace_back(
            scraping_plan(*pair.body, pair.other, std::move(pair.scrapes), timeline));
    }
    return sources;
}

}  // namespace carom::sound

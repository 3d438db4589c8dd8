#include "sim/scheduler/respotting.h"

#include <algorithm>

namespace carom::sim {

Respotting::Respotting(const WorldDescription& world, const Bodies& bodies,
                       const Recorder& recorder, BallPlacer& placer)
    : bodies_(bodies), recorder_(recorder), placer_(placer) {
    if (world.respot && world.table) {
        rules_.emplace(*world.respot, *world.table);
        has_cue_ball_ = *world.respot != billiards::Game::carom;
        note_balls_on_table();
    }
}

void Respotting::note_balls_on_table() {
    on_table_.clear();
    for (const MovingBody& ball : bodies_.balls()) {
        if (ball.is_on_table()) {
            on_table_.insert(ball.name());
        }
    }
}

std::uint32_t Respotting::index_of(const std::string& ball) const {
    const auto found = std::ranges::find(bodies_.balls(), ball, &MovingBody::name);
    return static_cast<std::uint32_t>(found - bodies_.balls().begin());
}

/// Without a strike the cue ball is the one that has its name.
billiards::ShotOutcome Respotting::played_shot() const {
    billiards::ShotOutcome shot;
    shot.on_table = on_table_;
    for (const char* name : {"white", "cue"}) {
        if (has_cue_ball_ && index_of(name) < bodies_.balls().size()) {
            shot.cue_ball = name;
        }
    }
    for (std::size_t i = seen_events_; i < recorder_.events().size(); ++i) {
        const Event& event = recorder_.events()[i];
        if (event.kind == EventKind::strike) {
            shot.cue_ball = event.a;
        }
        if (event.kind == EventKind::potted) {
            shot.potted.insert(event.a);
        }
        if (event.kind == EventKind::off_table) {
            shot.off_table.insert(event.a);
        }
        if (event.kind != EventKind::impact || !shot.first_hit.empty()) {
            continue;
        }
        for (const auto& [a, b] : {std::pair(&event.a, &event.b), std::pair(&event.b, &event.a)}) {
            if (*a == shot.cue_ball && index_of(*b) < bodies_.balls().size()) {
                shot.first_hit = *b;
            }
        }
    }
    return shot;
}

/// A ball that was taken off is no longer part of the game.
std::vector<billiards::GameBall> Respotting::game_balls(double time) const {
    std::vector<billiards::GameBall> balls;
    for (const MovingBody& ball : bodies_.balls()) {
        if (!ball.is_removed) {
            const Vec3 centre = ball.segment.position_at(time);
            balls.push_back({ball.name(), ball.radius, ball.is_on_table(), {centre.x, centre.y}});
        }
    }
    return balls;
}

/// Putting balls somewhere and resting are no shot.
bool Respotting::is_shot_played() const {
    const auto first_new = recorder_.events().begin() + static_cast<std::ptrdiff_t>(seen_events_);
    return std::any_of(first_new, recorder_.events().end(), [](const Event& event) {
        return event.kind != EventKind::placed && event.kind != EventKind::removed &&
               event.kind != EventKind::resting;
    });
}

void Respotting::act(double time) {
    if (is_shot_played()) {
        for (const billiards::RespottedBall& put : rules_->after(played_shot(), game_balls(time))) {
            put_back(put, time);
        }
    }
    seen_events_ = recorder_.events().size();
    note_balls_on_table();
}

void Respotting::put_back(const billiards::RespottedBall& put, double time) {
    const std::uint32_t ball = index_of(put.ball);
    const std::string obstacle = placer_.obstacle(ball, put.place, time);
    if (obstacle.empty()) {
        placer_.put_down(ball, put.place, put.spot, time);
    } else {
        blocked_.push_back(
            {Subject::body(put.ball), "",
             "'" + put.ball + "' was not put back: '" + obstacle + "' is in its place"});
    }
}

std::vector<Diagnostic> Respotting::never_put_back() const {
    std::vector<Diagnostic> warnings = blocked_;
    if (rules_) {
        for (const std::string& ball : rules_->without_place()) {
            warnings.push_back({Subject::body(ball), "",
                                "'" + ball + "' was not put back: no place on its line was free"});
        }
    }
    return warnings;
}

}  // namespace carom::sim

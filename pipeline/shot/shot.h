// A shot as read from YAML: the world, the scene, the cameras and the output.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/picture/annotation.h"
#include "pipeline/shot/cue_stick.h"
#include "pipeline/shot/sound_settings.h"
#include "pipeline/video/output_settings.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/aim/find_aims.h"
#include "sim/timeline/bake_file.h"
#include "sim/world.h"

namespace carom::pipeline {

namespace solve {
struct SolveQuestion;  // pipeline/solve/question.h
struct SolveResult;    // pipeline/solve/solver.h
}  // namespace solve

/// A value of the shot that is a scene time named by what happens ("the cue ball touches the one").
struct ShotMoment {
    std::string key_path;        // "cameras[0].scene[1]"
    std::optional<double> time;  // scene time, s; empty: the motion is not known yet

    bool operator==(const ShotMoment&) const = default;
};

/// A strike that `solve` found, or several solutions of it, the best one first.
struct SolvedStrike {
    std::size_t event = 0;                                    // of the world
    std::shared_ptr<const solve::SolveQuestion> question;     // not null
    std::shared_ptr<const solve::SolveResult> result;         // likewise
    std::vector<std::pair<std::string, std::string>> values;  // keys that were found, with units
};

struct Shot {
    std::string name;  // the file's name without folder and extension
    sim::WorldDescription world;
    /// Of strikes whose aims say what they shall do; the world and the resolved text have them,
    /// too.
    std::vector<sim::FoundDirection> found_directions;
    std::vector<SolvedStrike> solved;  // likewise
    render::SceneDescription scene;  // its objects refer to tracks of bodies or of `keyed` by name
    bool draws_table = true;         // false: the world's table is not in the scene
    std::vector<sim::Track> keyed;   // of objects that keys move
    ShownStick stick;                // its parts are objects of the scene
    std::vector<CameraRig> cameras;
    FilmTiming timing;
    render::RenderSettings render;
    OutputSettings output;
    SoundSettings sound;
    /// While the motion is not known, the values of moments are 0 s (resolve_moments in
    /// config/load_shot.h).
    std::vector<ShotMoment> moments;
    std::vector<Annotation> annotations;
    std::string resolved_text;  // the shot after includes and overrides, as self-contained YAML
    std::vector<sim::Asset> assets;  // files to which it refers
};

}  // namespace carom::pipeline
